#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <utility>

#include "base/files.h"
#include "base/qgis_style_table.h"
#include "record/checkpoint_table.h"
#include "record/gpkg.h"
#include "record/log.h"
#include "record/row_layer.h"

namespace lsos {

namespace {

using Clock = std::chrono::steady_clock;

// Wall time after which rows are committed: the most that a reader or a kill may miss.
constexpr std::chrono::milliseconds commit_period{900};

}  // namespace

struct LogWriter::Impl {
  std::string file;
  Instant start;
  // Declared before the layers' features, which need its column definitions until destroyed.
  gpkg::Dataset dataset;
  std::optional<FileIdentity> identity;  // of the file that the dataset writes
  gpkg::RowLayer<SampleRow> samples;
  gpkg::RowLayer<JointRow> joints;
  gpkg::RowLayer<PanelRow> panels;
  gpkg::RowLayer<PairRow> pairs;
  gpkg::RowLayer<SightIntervalRow> sight_intervals;
  gpkg::RowLayer<ResourceRow> resources;
  gpkg::RowLayer<EventRow> events;
  gpkg::RowLayer<PhaseRow> phases;
  gpkg::RowLayer<PlannedPathRow> planned_paths;
  gpkg::RowLayer<NoteRow> notes;
  gpkg::RowLayer<RunRow> run;
  gpkg::RowLayer<OrderRow> orders;
  std::map<std::pair<std::string, std::int64_t>, std::int64_t> event_fids;
  std::map<std::string, std::int64_t> run_fids;
  Clock::time_point last_commit = Clock::now();
  bool in_transaction = false;
  std::uintmax_t bytes_max = 0;  // of the file; 0: any

  // Runs `action`; if it fails, abandons the log after the last commit and throws LogError.
  template <class Action>
  void attempt(const char* what, Action action) {
    if (dataset == nullptr) throw LogError(fmt::format("{}: {}: the log is closed", file, what));
    const gpkg::QuietErrors errors;
    if (action() && !errors.has_failed()) return;
    const std::string why = errors.message();
    abandon();
    throw LogError(fmt::format("{}: {}: {}", file, what, why));
  }

  // Closes the file in the state of the last commit.
  void abandon() {
    const gpkg::QuietErrors errors;
    if (in_transaction) dataset->RollbackTransaction();
    in_transaction = false;
    release_features();
    dataset.reset();
  }

  // Calls `visit` with each layer: those of contract_layers() in their order, then the orders.
  template <class Visit>
  void for_each_layer(Visit visit) {
    const auto visit_if = [&](std::string_view name, auto& layer) {
      if (name == name_of(layer)) visit(layer);
    };
    for (const LayerSpec& spec : contract_layers()) {
      visit_if(spec.name, samples);
      visit_if(spec.name, joints);
      visit_if(spec.name, panels);
      visit_if(spec.name, pairs);
      visit_if(spec.name, sight_intervals);
      visit_if(spec.name, resources);
      visit_if(spec.name, events);
      visit_if(spec.name, phases);
      visit_if(spec.name, planned_paths);
      visit_if(spec.name, notes);
      visit_if(spec.name, run);
    }
    visit(orders);
  }

  // Features refer to the definition of their layer, so they are released before the dataset.
  void release_features() {
    for_each_layer([](auto& layer) { layer = {}; });
  }

  void open_layers() {
    for_each_layer([&](auto& layer) {
      layer.open(*dataset->GetLayerByName(std::string(name_of(layer)).c_str()));
    });
  }

  void create_layers(const std::string& crs_name) {
    OGRSpatialReference crs;
    crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    attempt("reading the reference system",
            [&] { return crs.SetFromUserInput(crs_name.c_str()) == OGRERR_NONE; });
    for (const LayerSpec& spec : contract_layers()) {
      attempt("making a layer", [&] { return gpkg::create_layer(*dataset, spec, crs) != nullptr; });
    }
    attempt("making a layer",
            [&] { return gpkg::create_layer(*dataset, order_layer(), crs) != nullptr; });
    open_layers();
    // GDAL creates tables lazily; all must be in the file before the first step.
    attempt("making the layers", [&] {
      dataset->FlushCache(false);
      return true;
    });
    // GIS tools look the reference system up under PROJ's name of the authority, with the year.
    attempt("naming the reference system", [&] {
      gpkg::run_sql(*dataset,
                    "UPDATE gpkg_spatial_ref_sys SET definition = replace(definition, "
                    "'AUTHORITY[\"IAU\"', 'AUTHORITY[\"IAU_2015\"')");
      return true;
    });
    attempt("giving columns titles", [&] {
      gpkg::add_titles(*dataset);
      return true;
    });
  }

  template <class Row>
  static std::string_view name_of(const gpkg::RowLayer<Row>&) {
    return layer_name<Row>;
  }

  // Removes the rows after these fids, the last of each layer to keep, and learns the fids of rows
  // that are updated.
  void trim(const std::vector<std::int64_t>& last_fids) {
    std::size_t number = 0;
    for_each_layer([&](auto& layer) {
      const std::int64_t last = last_fids[number++];
      layer.set_last_fid(last);
      attempt("removing later rows", [&] {
        gpkg::run_sql(*dataset, fmt::format("DELETE FROM {} WHERE fid > {}", name_of(layer), last));
        return true;
      });
    });
    attempt("reading events", [&] {
      gpkg::run_sql(*dataset, "SELECT fid + 0 AS number, rover_id, sequence FROM events",
                    [&](const OGRFeature& row) {
                      event_fids[{row.GetFieldAsString(1), row.GetFieldAsInteger64(2)}] =
                          row.GetFieldAsInteger64(0);
                    });
      gpkg::run_sql(*dataset, "SELECT fid + 0 AS number, key FROM run", [&](const OGRFeature& row) {
        run_fids[row.GetFieldAsString(1)] = row.GetFieldAsInteger64(0);
      });
      return true;
    });
  }

  void begin() {
    attempt("starting a transaction", [&] { return dataset->StartTransaction() == OGRERR_NONE; });
    in_transaction = true;
  }

  // SQLite would go on writing into a file that nobody finds again.
  void check_is_there() {
    if (dataset == nullptr || identity_of(file) == identity) return;
    abandon();
    throw LogError(fmt::format(
        "{}: is gone: another program has removed, moved or replaced it during the run", file));
  }

  void commit() {
    check_is_there();
    attempt("writing", [&] {
      return samples.sync() && events.sync() && planned_paths.sync() && notes.sync() &&
             dataset->CommitTransaction() == OGRERR_NONE;
    });
    in_transaction = false;
    last_commit = Clock::now();
  }

  // What was committed stays readable, as on a full disk.
  void check_size() {
    const std::string fault = gpkg::size_fault(file, bytes_max);
    if (fault.empty()) return;
    abandon();
    throw LogError(fault);
  }

  template <class Row>
  void append(gpkg::RowLayer<Row>& layer, const Row& row) {
    attempt("writing", [&] { return layer.append(row, start); });
  }

  // Writes the row, or updates the one that was already written for this key.
  template <class Row, class Key>
  void upsert(gpkg::RowLayer<Row>& layer, std::map<Key, std::int64_t>& fids, const Key& key,
              const Row& row) {
    const auto known = fids.find(key);
    if (known != fids.end()) {
      attempt("writing", [&] { return layer.update(known->second, row, start); });
      return;
    }
    append(layer, row);
    fids[key] = layer.last_fid();
  }

  void put_run(const RunRow& row) { upsert(run, run_fids, row.key, row); }
};

LogWriter::LogWriter(const std::string& file, const std::string& crs, Instant start)
    : impl_(std::make_unique<Impl>()) {
  impl_->file = file;
  impl_->start = start;
  {
    // GDAL would open an existing GeoPackage and append to it.
    if (std::filesystem::exists(file)) {
      throw LogError(fmt::format("{}: making the log: the file exists", file));
    }
    const gpkg::QuietErrors errors;
    impl_->dataset = gpkg::create(file);
    if (impl_->dataset == nullptr) {
      throw LogError(fmt::format("{}: making the log: {}", file, errors.message()));
    }
  }
  impl_->identity = identity_of(file);
  impl_->begin();
  impl_->create_layers(crs);
  impl_->put_run({std::string(start_key), fmt::format("{}", start.tai_us)});
  impl_->commit();
  // Checkpoint into the file itself, so that from the beginning it is a GeoPackage on its own.
  impl_->attempt("making the layers", [&] {
    gpkg::run_sql(*impl_->dataset, "PRAGMA wal_checkpoint(TRUNCATE)");
    return true;
  });
  impl_->begin();
}

LogWriter::LogWriter(const std::string& file, Instant start, std::int64_t checkpoint_id)
    : impl_(std::make_unique<Impl>()) {
  impl_->file = file;
  impl_->start = start;
  const std::vector<std::int64_t> last_fids = LogReader(file).checkpoint(checkpoint_id).last_fids;
  {
    const gpkg::QuietErrors errors;
    impl_->dataset = gpkg::open_to_write(file);
    if (impl_->dataset == nullptr) {
      throw LogError(fmt::format("{}: opening the log: {}", file, errors.message()));
    }
  }
  impl_->identity = identity_of(file);
  impl_->open_layers();
  impl_->begin();
  impl_->trim(last_fids);
  impl_->attempt("removing later checkpoints", [&] {
    gpkg::remove_checkpoints_after(*impl_->dataset, checkpoint_id);
    return true;
  });
}

LogWriter::~LogWriter() {
  if (impl_->dataset != nullptr) impl_->abandon();
}

void LogWriter::write(const SampleRow& row) { impl_->append(impl_->samples, row); }
void LogWriter::write(const JointRow& row) { impl_->append(impl_->joints, row); }
void LogWriter::write(const PanelRow& row) { impl_->append(impl_->panels, row); }
void LogWriter::write(const PairRow& row) { impl_->append(impl_->pairs, row); }
void LogWriter::write(const SightIntervalRow& row) { impl_->append(impl_->sight_intervals, row); }
void LogWriter::write(const ResourceRow& row) { impl_->append(impl_->resources, row); }
void LogWriter::write(const PhaseRow& row) { impl_->append(impl_->phases, row); }
void LogWriter::write(const PlannedPathRow& row) { impl_->append(impl_->planned_paths, row); }
void LogWriter::write(const NoteRow& row) { impl_->append(impl_->notes, row); }
void LogWriter::write(const OrderRow& row) { impl_->append(impl_->orders, row); }

void LogWriter::write(const EventRow& row) {
  impl_->upsert(impl_->events, impl_->event_fids, {row.rover_id, row.sequence}, row);
}

void LogWriter::write_run(const std::map<std::string, std::string>& values) {
  for (const auto& [key, value] : values) impl_->put_run({key, value});
}

void LogWriter::write_styles(const std::vector<LayerStyle>& styles) {
  impl_->attempt("writing styles", [&] {
    for (const LayerStyle& style : styles) {
      for (const std::string& statement :
           qgis_style_sql({style.layer, "geom", style.name, style.qml, format_utc(impl_->start)})) {
        gpkg::run_sql(*impl_->dataset, statement);
      }
    }
    return true;
  });
}

void LogWriter::commit_if_due() {
  if (Clock::now() - impl_->last_commit >= commit_period) commit();
}

std::string LogWriter::lost_numbers() const {
  gpkg::LostNumbers all;
  impl_->for_each_layer([&](const auto& layer) {
    if (all.count == 0) all.first = layer.lost().first;
    all.count += layer.lost().count;
  });
  if (all.count == 0) return "";
  return fmt::format(
      "{}: {}: too large for the log, which has NULL there; the same holds for {} numbers in all",
      impl_->file, all.first, all.count);
}

void LogWriter::limit_size(std::uintmax_t bytes) { impl_->bytes_max = bytes; }

void LogWriter::commit() {
  impl_->commit();
  impl_->check_size();
  impl_->begin();
}

void LogWriter::write(const Checkpoint& checkpoint) {
  StoredCheckpoint stored{checkpoint, {}};
  impl_->for_each_layer([&](auto& layer) { stored.last_fids.push_back(layer.last_fid()); });
  impl_->attempt("writing a checkpoint", [&] {
    gpkg::make_checkpoint_table(*impl_->dataset);
    gpkg::add_checkpoint(*impl_->dataset, stored);
    return true;
  });
  commit();
}

void LogWriter::begin_branch(const BranchOrigin& origin) {
  impl_->attempt("beginning a branch", [&] {
    gpkg::remove_checkpoints_after(*impl_->dataset, 0);
    gpkg::write_branch(*impl_->dataset, origin);
    return true;
  });
  commit();
}

void LogWriter::keep_events(const std::set<std::pair<std::string, std::int64_t>>& events) {
  impl_->attempt("removing events", [&] {
    if (!impl_->events.sync()) return false;
    std::erase_if(impl_->event_fids, [&](const auto& known) {
      if (events.contains(known.first)) return false;
      gpkg::run_sql(*impl_->dataset,
                    fmt::format("DELETE FROM events WHERE fid = {}", known.second));
      return true;
    });
    return true;
  });
}

void LogWriter::finish(bool can_resume) {
  if (!can_resume) {
    impl_->attempt("removing checkpoints", [&] {
      gpkg::remove_passing_checkpoints(*impl_->dataset);
      return true;
    });
  }
  impl_->commit();
  impl_->attempt("finishing", [&] {
    gpkg::run_sql(*impl_->dataset, "PRAGMA wal_checkpoint(TRUNCATE)");
    return true;
  });
  {
    // Switch from WAL to the plain journal, so that the one file can be read from a read-only
    // place. SQLite refuses this while another program has the file open; the log then stays in WAL
    // mode, which is no error.
    const gpkg::QuietErrors ignored;
    gpkg::run_sql(*impl_->dataset, "PRAGMA journal_mode = DELETE");
  }
  impl_->attempt("closing", [&] {
    impl_->release_features();
    impl_->dataset.reset();
    return true;
  });
}

}  // namespace lsos
