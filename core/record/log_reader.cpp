#include <fmt/format.h>

#include <cstring>
#include <filesystem>

#include "base/error.h"
#include "base/quantity.h"
#include "base/sha256.h"
#include "record/checkpoint_table.h"
#include "record/gpkg.h"
#include "record/log.h"

namespace lsos {

namespace {

// The number of each column in the file, in the order of `names`.
std::vector<int> field_numbers(OGRLayer& layer, const LayerSpec& spec, const std::string& file) {
  std::vector<int> numbers;
  for (const ColumnSpec& column : spec.columns) {
    const std::string name(column.name);
    const int number = layer.GetLayerDefn()->GetFieldIndex(name.c_str());
    if (number < 0) {
      throw InputError({file}, fmt::format("no log of this version of lsos-host: layer '{}' has no "
                                           "column '{}'",
                                           spec.name, name));
    }
    numbers.push_back(number);
  }
  return numbers;
}

// Limits the rows that a layer returns, until the end of the scope.
class Filter {
 public:
  Filter(OGRLayer& layer, const std::string& where) : layer_(layer) {
    layer_.SetAttributeFilter(where.c_str());
  }
  ~Filter() { layer_.SetAttributeFilter(nullptr); }
  Filter(const Filter&) = delete;
  Filter& operator=(const Filter&) = delete;

 private:
  OGRLayer& layer_;
};

template <class T>
void add_bytes(Sha256& hash, char tag, T number) {
  char bytes[1 + sizeof number];
  bytes[0] = tag;
  std::memcpy(bytes + 1, &number, sizeof number);
  hash.add({bytes, sizeof bytes});
}

void add_text(Sha256& hash, char tag, std::string_view text) {
  add_bytes(hash, tag, static_cast<std::uint64_t>(text.size()));
  hash.add(text);
}

void add_value(Sha256& hash, const ColumnValue& value) {
  if (const auto* real = std::get_if<double>(&value)) {
    add_bytes(hash, 'd', *real);
  } else if (const auto* integer = std::get_if<std::int64_t>(&value)) {
    add_bytes(hash, 'i', *integer);
  } else if (const auto* text = std::get_if<std::string>(&value)) {
    add_text(hash, 's', *text);
  } else {
    hash.add("n");
  }
}

// "" where the feature has no geometry.
std::string geometry_wkb(const OGRFeature& feature) {
  const OGRGeometry* geometry = feature.GetGeometryRef();
  if (geometry == nullptr) return {};
  std::string wkb(geometry->WkbSize(), '\0');
  geometry->exportToWkb(wkbNDR, reinterpret_cast<unsigned char*>(wkb.data()), wkbVariantIso);
  return wkb;
}

std::size_t size_of(const LogRow& row) {
  std::size_t bytes = row.geometry.size();
  for (const ColumnValue& value : row.values) {
    const auto* text = std::get_if<std::string>(&value);
    bytes += sizeof value + (text == nullptr ? 0 : text->size());
  }
  return bytes;
}

void add_geometry(Sha256& hash, const OGRFeature& feature) {
  const std::string wkb = geometry_wkb(feature);
  if (wkb.empty()) {
    hash.add("n");
  } else {
    add_text(hash, 'g', wkb);
  }
}

}  // namespace

struct LogReader::Impl {
  std::string file;
  gpkg::Dataset dataset;

  OGRLayer& layer(const LayerSpec& spec) const {
    OGRLayer* found = dataset->GetLayerByName(std::string(spec.name).c_str());
    if (found == nullptr) {
      throw InputError({file}, fmt::format("no log of lsos-host: it has no layer '{}'", spec.name));
    }
    return *found;
  }

  const LayerSpec& spec(std::string_view name) const {
    for (const LayerSpec& layer : contract_layers()) {
      if (layer.name == name) return layer;
    }
    if (order_layer().name == name) return order_layer();
    assertion_failed("rows belong to a layer of the contract", __FILE__, __LINE__);
  }

  void query(const std::string& statement,
             const std::function<void(const OGRFeature&)>& visit) const {
    const gpkg::QuietErrors errors;
    gpkg::run_sql(*dataset, statement, visit);
    if (errors.has_failed()) throw InputError({file}, "cannot be read: " + errors.message());
  }

  // Visits the features of a layer in fid order, which is the order of the table.
  template <class Visit>
  void for_each_feature(OGRLayer& layer, Visit visit) const {
    const gpkg::QuietErrors errors;
    GIntBig last_fid = 0;
    layer.ResetReading();
    while (const gpkg::Feature feature{layer.GetNextFeature()}) {
      LSOS_ASSERT(feature->GetFID() > last_fid);
      last_fid = feature->GetFID();
      visit(*feature);
    }
    if (errors.has_failed()) throw InputError({file}, "cannot be read: " + errors.message());
  }

  template <class Row, class Visit>
  void for_each_row(Visit visit) const {
    const LayerSpec& layer_spec = spec(layer_name<Row>);
    OGRLayer& source = layer(layer_spec);
    const std::vector<int> numbers = field_numbers(source, layer_spec, file);
    for_each_feature(source, [&](const OGRFeature& feature) {
      Row row;
      std::size_t i = 0;
      for (const Column<Row>& column : columns<Row>()) {
        const int number = numbers[i++];
        if (column.set_value == nullptr) continue;
        column.set_value(row, gpkg::value(feature, number, column.type));
      }
      if constexpr (requires { row.place; }) {
        if (const std::optional<Geodetic> place = gpkg::point(feature)) row.place = *place;
      }
      if constexpr (requires { row.line; }) row.line = gpkg::line(feature);
      visit(row);
    });
  }

  // Rows outside the span are filtered before features are made of them.
  template <class Row, class Visit>
  void for_each_row(const TimeSpan& within, Visit visit) const {
    constexpr double rounding_s = 5e-7;  // half of the unit in which times are counted
    const Filter filter(layer(spec(layer_name<Row>)),
                        fmt::format("time_s BETWEEN {} AND {}", seconds(within.from) - rounding_s,
                                    seconds(within.to) + rounding_s));
    for_each_row<Row>(visit);
  }

  template <class Row>
  std::vector<Row> rows() const {
    std::vector<Row> rows;
    for_each_row<Row>([&](const Row& row) { rows.push_back(row); });
    return rows;
  }
};

LogReader::LogReader(const std::string& file) : impl_(std::make_unique<Impl>()) {
  impl_->file = file;
  const gpkg::QuietErrors errors;
  std::error_code unreadable;
  if (!std::filesystem::exists(file, unreadable) && !unreadable)
    throw InputError({file}, "no such file: no run has written it");
  impl_->dataset = gpkg::open_to_read(file);
  if (impl_->dataset == nullptr) {
    throw InputError({file}, "no log of lsos-host: " + errors.message());
  }
  for (const LayerSpec& spec : contract_layers()) field_numbers(impl_->layer(spec), spec, file);
}

LogReader::~LogReader() = default;

std::vector<SampleRow> LogReader::samples() const { return impl_->rows<SampleRow>(); }
std::vector<JointRow> LogReader::joints() const { return impl_->rows<JointRow>(); }
std::vector<PairRow> LogReader::pairs() const { return impl_->rows<PairRow>(); }
std::vector<SightIntervalRow> LogReader::sight_intervals() const {
  return impl_->rows<SightIntervalRow>();
}
std::vector<PanelRow> LogReader::panels() const { return impl_->rows<PanelRow>(); }
std::vector<ResourceRow> LogReader::resources() const { return impl_->rows<ResourceRow>(); }
std::vector<EventRow> LogReader::events() const { return impl_->rows<EventRow>(); }
std::vector<PhaseRow> LogReader::phases() const { return impl_->rows<PhaseRow>(); }
std::vector<PlannedPathRow> LogReader::planned_paths() const {
  return impl_->rows<PlannedPathRow>();
}
std::vector<NoteRow> LogReader::notes() const { return impl_->rows<NoteRow>(); }
std::vector<OrderRow> LogReader::orders() const {
  const std::string name(layer_name<OrderRow>);
  if (impl_->dataset->GetLayerByName(name.c_str()) == nullptr) return {};
  return impl_->rows<OrderRow>();
}

void LogReader::for_each_sample(const std::function<void(const SampleRow&)>& visit) const {
  impl_->for_each_row<SampleRow>(visit);
}

void LogReader::for_each_joint(const std::function<void(const JointRow&)>& visit,
                               const TimeSpan& within) const {
  impl_->for_each_row<JointRow>(within, visit);
}
void LogReader::for_each_panel(const std::function<void(const PanelRow&)>& visit,
                               const TimeSpan& within) const {
  impl_->for_each_row<PanelRow>(within, visit);
}
void LogReader::for_each_pair(const std::function<void(const PairRow&)>& visit) const {
  impl_->for_each_row<PairRow>(visit);
}
void LogReader::for_each_sight_interval(
    const std::function<void(const SightIntervalRow&)>& visit) const {
  impl_->for_each_row<SightIntervalRow>(visit);
}
void LogReader::for_each_resource(const std::function<void(const ResourceRow&)>& visit,
                                  const TimeSpan& within) const {
  impl_->for_each_row<ResourceRow>(within, visit);
}
void LogReader::for_each_planned_path(
    const std::function<void(const PlannedPathRow&)>& visit) const {
  impl_->for_each_row<PlannedPathRow>(visit);
}
void LogReader::for_each_note(const std::function<void(const NoteRow&)>& visit) const {
  impl_->for_each_row<NoteRow>(visit);
}

std::vector<LogRow> LogReader::rows_after(std::string_view layer, std::int64_t fid,
                                          std::size_t count) const {
  const LayerSpec& spec = impl_->spec(layer);
  OGRLayer& source = impl_->layer(spec);
  const std::vector<int> numbers = field_numbers(source, spec, impl_->file);
  const gpkg::QuietErrors errors;
  const Filter filter(source, fmt::format("{} > {}", source.GetFIDColumn(), fid));
  source.ResetReading();
  constexpr std::size_t bytes_max = std::size_t{16} << 20;
  std::size_t bytes = 0;
  std::vector<LogRow> rows;
  while (rows.size() < count && bytes < bytes_max) {
    const gpkg::Feature feature{source.GetNextFeature()};
    if (feature == nullptr) break;
    LogRow& row = rows.emplace_back(LogRow{feature->GetFID(), {}, {}});
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      row.values.push_back(gpkg::value(*feature, numbers[i], spec.columns[i].type));
    }
    if (spec.geometry != LayerGeometry::none) row.geometry = geometry_wkb(*feature);
    bytes += size_of(row);
  }
  if (errors.has_failed()) throw InputError({impl_->file}, "cannot be read: " + errors.message());
  return rows;
}

bool LogReader::has_samples() const {
  bool is_any = false;
  impl_->query("SELECT fid FROM samples LIMIT 1", [&](const OGRFeature&) { is_any = true; });
  return is_any;
}

std::map<std::string, SampleTotals> LogReader::sample_totals() const {
  std::map<std::string, SampleTotals> totals;
  const std::string sql = fmt::format(
      "SELECT rover_id, count(*), sum(speed_mps > {}), max(distance_m) FROM samples GROUP BY "
      "rover_id",
      moving_mps);
  impl_->query(sql, [&](const OGRFeature& row) {
    totals[row.GetFieldAsString(0)] = {static_cast<std::size_t>(row.GetFieldAsInteger64(1)),
                                       static_cast<std::size_t>(row.GetFieldAsInteger64(2)),
                                       row.GetFieldAsDouble(3)};
  });
  return totals;
}

std::size_t LogReader::row_count(std::string_view layer) const {
  std::size_t count = 0;
  impl_->query(
      fmt::format("SELECT count(*) FROM {}", impl_->spec(layer).name),
      [&](const OGRFeature& row) { count = static_cast<std::size_t>(row.GetFieldAsInteger64(0)); });
  return count;
}

std::size_t LogReader::pair_count() const {
  std::size_t most = 0;
  impl_->query(
      "SELECT count(*) AS n FROM pairs GROUP BY from_id, to_id ORDER BY n DESC LIMIT 1",
      [&](const OGRFeature& row) { most = static_cast<std::size_t>(row.GetFieldAsInteger64(0)); });
  return most;
}

LogReader::NoteCounts LogReader::note_counts(std::size_t kinds_max) const {
  NoteCounts counts;
  impl_->query("SELECT count(*) FROM notes", [&](const OGRFeature& row) {
    counts.in_all = static_cast<std::size_t>(row.GetFieldAsInteger64(0));
  });
  bool has_long_name = false;
  impl_->query("SELECT fid FROM notes WHERE length(name) > 200 LIMIT 1",
               [&](const OGRFeature&) { has_long_name = true; });
  if (has_long_name) return counts;
  impl_->query(
      fmt::format("SELECT rover_id, name, count(*) FROM notes GROUP BY rover_id, name LIMIT {}",
                  kinds_max + 1),
      [&](const OGRFeature& row) {
        counts.by_kind[{row.GetFieldAsString(0), row.GetFieldAsString(1)}] =
            static_cast<std::size_t>(row.GetFieldAsInteger64(2));
      });
  if (counts.by_kind.size() > kinds_max) counts.by_kind.clear();
  return counts;
}

SimTime LogReader::last_sample_time() const {
  SimTime last{};
  impl_->query("SELECT time_s FROM samples ORDER BY fid DESC LIMIT 1",
               [&](const OGRFeature& row) { last = from_seconds(row.GetFieldAsDouble(0)); });
  return last;
}

std::map<std::string, std::string> LogReader::run() const {
  std::map<std::string, std::string> values;
  impl_->for_each_row<RunRow>([&](const RunRow& row) { values[row.key] = row.value; });
  return values;
}

Instant LogReader::start() const {
  const std::map<std::string, std::string> values = run();
  const auto found = values.find(std::string(start_key));
  const auto tai_us = found == values.end() ? Parsed<std::int64_t>{} : parse_integer(found->second);
  if (!tai_us) {
    throw InputError({impl_->file},
                     fmt::format("no log of lsos-host: layer 'run' has no '{}'", start_key));
  }
  return {*tai_us.value};
}

std::vector<CheckpointEntry> LogReader::checkpoints() const {
  const gpkg::QuietErrors errors;
  std::vector<CheckpointEntry> entries = gpkg::checkpoint_entries(*impl_->dataset);
  if (errors.has_failed()) throw InputError({impl_->file}, "cannot be read: " + errors.message());
  return entries;
}

StoredCheckpoint LogReader::checkpoint(std::int64_t id) const {
  const gpkg::QuietErrors errors;
  const auto checkpoint = gpkg::read_checkpoint(*impl_->dataset, id);
  if (checkpoint && checkpoint->last_fids.size() == contract_layers().size() + 1)
    return *checkpoint;
  throw InputError({impl_->file}, fmt::format("its checkpoint {} is damaged", id));
}

std::optional<BranchOrigin> LogReader::branch() const {
  const gpkg::QuietErrors errors;
  return gpkg::read_branch(*impl_->dataset);
}

void LogReader::copy_to(const std::string& file) const {
  const gpkg::QuietErrors errors;
  gpkg::run_sql(*impl_->dataset, fmt::format("VACUUM INTO {}", gpkg::quoted(file)));
  if (errors.has_failed()) {
    throw InputError({file},
                     fmt::format("cannot be copied from {}: {}", impl_->file, errors.message()));
  }
}

std::string LogReader::sha256() const {
  Sha256 hash;
  for (const LayerSpec& spec : contract_layers()) {
    OGRLayer& layer = impl_->layer(spec);
    const std::vector<int> numbers = field_numbers(layer, spec, impl_->file);
    add_text(hash, 'L', spec.name);
    for (const ColumnSpec& column : spec.columns) add_text(hash, 'C', column.name);
    impl_->for_each_feature(layer, [&](const OGRFeature& feature) {
      hash.add("R");
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        add_value(hash, gpkg::value(feature, numbers[i], spec.columns[i].type));
      }
      if (spec.geometry != LayerGeometry::none) add_geometry(hash, feature);
    });
  }
  return hash.hex();
}

}  // namespace lsos
