#include <fmt/format.h>

#include <cstring>
#include <filesystem>

#include "base/error.h"
#include "base/quantity.h"
#include "base/sha256.h"
#include "record/checkpoint_table.h"
#include "record/log.h"
#include "record/log_cells.h"

namespace lsos {

namespace {

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

// Condition for rows of a span, and for those whose time is none, which are then refused.
std::string condition(const TimeSpan& within) {
  constexpr double rounding_s = 5e-7;  // half of the unit in which times are counted
  return fmt::format("time_s BETWEEN {} AND {} OR typeof(time_s) NOT IN ('real', 'integer')",
                     seconds(within.from) - rounding_s, seconds(within.to) + rounding_s);
}

std::size_t size_of(const LogRow& row) {
  std::size_t bytes = row.geometry.size();
  for (const ColumnValue& value : row.values) {
    const auto* text = std::get_if<std::string>(&value);
    bytes += sizeof value + (text == nullptr ? 0 : text->size());
  }
  return bytes;
}

// Whether rows of this layer come in the order of their times.
template <class Row>
constexpr bool is_in_order = std::is_same_v<Row, SampleRow> || std::is_same_v<Row, JointRow> ||
                             std::is_same_v<Row, PanelRow> || std::is_same_v<Row, PairRow> ||
                             std::is_same_v<Row, ResourceRow>;

}  // namespace

struct LogReader::Impl {
  explicit Impl(const std::string& file) : database(file) {}

  sqlite::Database database;

  template <class Row, class Visit>
  void for_each_row(const std::string& where, Visit visit) const {
    LayerRows rows(database, layer_spec(layer_name<Row>), where);
    [[maybe_unused]] SimTime last = SimTime::min();
    while (rows.next()) {
      Row row;
      std::size_t number = 0;
      for (const Column<Row>& column : columns<Row>()) {
        const std::size_t at = number++;
        if (column.set_value != nullptr) column.set_value(row, rows.value(at));
      }
      if constexpr (is_in_order<Row>) {
        if (row.time < last) rows.refuse("time_s", "is less than in the row before");
        last = row.time;
      }
      if constexpr (requires { row.place; }) {
        const std::vector<Geodetic> places = rows.places();
        if (!places.empty()) row.place = places.front();
      }
      if constexpr (requires { row.line; }) row.line = rows.places();
      visit(row);
    }
  }

  template <class Row>
  std::vector<Row> rows() const {
    std::vector<Row> rows;
    for_each_row<Row>("", [&](const Row& row) { rows.push_back(row); });
    return rows;
  }
};

LogReader::LogReader(const std::string& file) {
  std::error_code unreadable;
  if (!std::filesystem::exists(file, unreadable) && !unreadable)
    throw InputError({file}, "no such file: no run has written it");
  impl_ = std::make_unique<Impl>(file);
  check_layers(impl_->database);
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
  if (!has_table(impl_->database, layer_name<OrderRow>)) return {};
  check_layer(impl_->database, order_layer());
  return impl_->rows<OrderRow>();
}

void LogReader::for_each_sample(const std::function<void(const SampleRow&)>& visit) const {
  impl_->for_each_row<SampleRow>("", visit);
}

void LogReader::for_each_joint(const std::function<void(const JointRow&)>& visit,
                               const TimeSpan& within) const {
  impl_->for_each_row<JointRow>(condition(within), visit);
}
void LogReader::for_each_panel(const std::function<void(const PanelRow&)>& visit,
                               const TimeSpan& within) const {
  impl_->for_each_row<PanelRow>(condition(within), visit);
}
void LogReader::for_each_pair(const std::function<void(const PairRow&)>& visit) const {
  impl_->for_each_row<PairRow>("", visit);
}
void LogReader::for_each_sight_interval(
    const std::function<void(const SightIntervalRow&)>& visit) const {
  impl_->for_each_row<SightIntervalRow>("", visit);
}
void LogReader::for_each_resource(const std::function<void(const ResourceRow&)>& visit,
                                  const TimeSpan& within) const {
  impl_->for_each_row<ResourceRow>(condition(within), visit);
}
void LogReader::for_each_planned_path(
    const std::function<void(const PlannedPathRow&)>& visit) const {
  impl_->for_each_row<PlannedPathRow>("", visit);
}
void LogReader::for_each_note(const std::function<void(const NoteRow&)>& visit) const {
  impl_->for_each_row<NoteRow>("", visit);
}

std::vector<LogRow> LogReader::rows_after(std::string_view layer, std::int64_t fid,
                                          std::size_t count) const {
  const LayerSpec& spec = layer_spec(layer);
  LayerRows source(impl_->database, spec, fmt::format("fid > {}", fid));
  constexpr std::size_t bytes_max = std::size_t{16} << 20;
  std::size_t bytes = 0;
  std::vector<LogRow> rows;
  while (rows.size() < count && bytes < bytes_max && source.next()) {
    LogRow& row = rows.emplace_back(LogRow{source.fid(), {}, {}});
    for (std::size_t i = 0; i < spec.columns.size(); ++i) row.values.push_back(source.value(i));
    if (spec.geometry != LayerGeometry::none) row.geometry = source.geometry_wkb();
    bytes += size_of(row);
  }
  return rows;
}

bool LogReader::has_samples() const {
  return sqlite::Query(impl_->database, "SELECT fid FROM samples LIMIT 1").next();
}

std::map<std::string, SampleTotals> LogReader::sample_totals() const {
  std::map<std::string, SampleTotals> totals;
  sqlite::Query query(
      impl_->database,
      fmt::format("SELECT rover_id, count(*), sum(speed_mps > {}), max(distance_m) FROM samples "
                  "NOT INDEXED GROUP BY rover_id",
                  moving_mps));
  while (query.next()) {
    totals[std::string(query.text(0))] = {static_cast<std::size_t>(query.integer(1)),
                                          static_cast<std::size_t>(query.integer(2)),
                                          query.real(3)};
  }
  return totals;
}

std::size_t LogReader::row_count(std::string_view layer) const {
  sqlite::Query query(impl_->database,
                      fmt::format("SELECT count(*) FROM {} NOT INDEXED", layer_spec(layer).name));
  return query.next() ? static_cast<std::size_t>(query.integer(0)) : 0;
}

std::size_t LogReader::pair_count() const {
  sqlite::Query query(impl_->database,
                      "SELECT count(*) AS n FROM pairs NOT INDEXED GROUP BY from_id, to_id ORDER "
                      "BY n DESC LIMIT 1");
  return query.next() ? static_cast<std::size_t>(query.integer(0)) : 0;
}

LogReader::NoteCounts LogReader::note_counts(std::size_t kinds_max) const {
  NoteCounts counts;
  sqlite::Query all(impl_->database, "SELECT count(*) FROM notes NOT INDEXED");
  if (all.next()) counts.in_all = static_cast<std::size_t>(all.integer(0));
  {
    sqlite::Query long_name(impl_->database,
                            "SELECT 1 FROM notes NOT INDEXED WHERE length(name) > 200 LIMIT 1");
    if (long_name.next()) return counts;
  }
  sqlite::Query kinds(impl_->database,
                      fmt::format("SELECT rover_id, name, count(*) FROM notes NOT INDEXED GROUP BY "
                                  "rover_id, name LIMIT {}",
                                  kinds_max + 1));
  while (kinds.next()) {
    counts.by_kind[{std::string(kinds.text(0)), std::string(kinds.text(1))}] =
        static_cast<std::size_t>(kinds.integer(2));
  }
  if (counts.by_kind.size() > kinds_max) counts.by_kind.clear();
  return counts;
}

SimTime LogReader::last_sample_time() const {
  LayerRows rows(impl_->database, layer_spec(layer_name<SampleRow>),
                 "fid = (SELECT max(fid) FROM samples)");
  if (!rows.next()) return {};
  constexpr std::size_t time_s = 0;
  return from_seconds(std::get<double>(rows.value(time_s)));
}

std::map<std::string, std::string> LogReader::run() const {
  std::map<std::string, std::string> values;
  impl_->for_each_row<RunRow>("", [&](const RunRow& row) { values[row.key] = row.value; });
  return values;
}

Instant LogReader::start() const {
  const std::map<std::string, std::string> values = run();
  const auto found = values.find(std::string(start_key));
  const auto tai_us = found == values.end() ? Parsed<std::int64_t>{} : parse_integer(found->second);
  const auto fail = [&](const std::string& what) {
    throw InputError({impl_->database.file()}, "no log of lsos-host: layer 'run' " + what);
  };
  if (!tai_us) fail(fmt::format("has no '{}'", start_key));
  const Instant start{*tai_us.value};
  // Calendar times can then be told of all moments of the log.
  const Instant first = *parse_utc("1960-01-02").value, last = *parse_utc("2100-12-31").value;
  if (start < first || last < start) {
    fail(fmt::format("has {} = {}: no time between {} and {}", start_key, start.tai_us,
                     format_utc(first), format_utc(last)));
  }
  return start;
}

std::vector<CheckpointEntry> LogReader::checkpoints() const {
  return gpkg::checkpoint_entries(impl_->database);
}

StoredCheckpoint LogReader::checkpoint(std::int64_t id) const {
  const auto checkpoint = gpkg::read_checkpoint(impl_->database, id);
  if (checkpoint && checkpoint->last_fids.size() == contract_layers().size() + 1)
    return *checkpoint;
  throw InputError({impl_->database.file()}, fmt::format("its checkpoint {} is damaged", id));
}

std::optional<BranchOrigin> LogReader::branch() const { return gpkg::read_branch(impl_->database); }

void LogReader::copy_to(const std::string& file) const {
  try {
    impl_->database.run(fmt::format("VACUUM INTO {}", gpkg::quoted(file)));
  } catch (const InputError& error) {
    throw InputError({file}, fmt::format("cannot be copied: {}", error.what()));
  }
}

std::string LogReader::sha256() const {
  Sha256 hash;
  for (const LayerSpec& spec : contract_layers()) {
    add_text(hash, 'L', spec.name);
    for (const ColumnSpec& column : spec.columns) add_text(hash, 'C', column.name);
    LayerRows rows(impl_->database, spec);
    while (rows.next()) {
      hash.add("R");
      for (std::size_t i = 0; i < spec.columns.size(); ++i) add_value(hash, rows.value(i));
      if (spec.geometry == LayerGeometry::none) continue;
      const std::string wkb = rows.geometry_wkb();
      if (wkb.empty()) {
        hash.add("n");
      } else {
        add_text(hash, 'g', wkb);
      }
    }
  }
  return hash.hex();
}

}  // namespace lsos
