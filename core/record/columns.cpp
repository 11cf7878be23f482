#include "record/columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/units.h"
#include "record/json_text.h"
#include "record/quantity_table.h"

namespace lsos {

namespace {

template <class Row, class T>
Row row_of(T Row::*);

ColumnValue from_number(double value) {
  return std::isnan(value) ? ColumnValue{} : ColumnValue{value};
}

double to_number(const ColumnValue& value) {
  const double* number = std::get_if<double>(&value);
  return number == nullptr ? not_modelled : *number;
}

ColumnValue from_string(const std::string& text) {
  return text.empty() ? ColumnValue{} : ColumnValue{text};
}

std::string to_string_or_empty(const ColumnValue& value) {
  const std::string* text = std::get_if<std::string>(&value);
  return text == nullptr ? std::string() : *text;
}

std::int64_t to_integer(const ColumnValue& value) {
  const std::int64_t* number = std::get_if<std::int64_t>(&value);
  return number == nullptr ? 0 : *number;
}

// The column of one member of the row.
constexpr ColumnLimits required{.is_required = true};
constexpr ColumnLimits flag{.least = 0, .greatest = 1, .is_required = true};
constexpr ColumnLimits moment{.least = 0, .greatest = time_max_s};
constexpr ColumnLimits required_moment{.least = 0, .greatest = time_max_s, .is_required = true};
// Farther than any rover comes, and nearer than where numbers lose their meaning.
constexpr double far_m = 1e9;
// With what rounding adds.
constexpr double longitude_max_deg = 180.000001, latitude_max_deg = 90.000001;

template <class Row>
Column<Row> limited(Column<Row> column, const ColumnLimits& limits) {
  column.limits = limits;
  return column;
}

template <auto member, class Row = decltype(row_of(member))>
Column<Row> real(std::string_view name) {
  return {name, ColumnType::real, [](const Row& row, Instant) { return from_number(row.*member); },
          [](Row& row, const ColumnValue& value) { row.*member = to_number(value); }};
}

template <auto member, class Row = decltype(row_of(member))>
Column<Row> text(std::string_view name) {
  return {name, ColumnType::text, [](const Row& row, Instant) { return from_string(row.*member); },
          [](Row& row, const ColumnValue& value) { row.*member = to_string_or_empty(value); }};
}

template <auto member, class Row = decltype(row_of(member))>
Column<Row> integer(std::string_view name) {
  return {name, ColumnType::integer,
          [](const Row& row, Instant) { return ColumnValue{row.*member}; },
          [](Row& row, const ColumnValue& value) { row.*member = to_integer(value); }};
}

template <auto member, class Row = decltype(row_of(member))>
Column<Row> time(std::string_view name) {
  return {name, ColumnType::real,
          [](const Row& row, Instant) { return ColumnValue{seconds(row.*member)}; },
          [](Row& row, const ColumnValue& value) { row.*member = from_seconds(to_number(value)); },
          required_moment};
}

template <auto member, class Row = decltype(row_of(member))>
Column<Row> optional_time(std::string_view name) {
  return {name, ColumnType::real,
          [](const Row& row, Instant) {
            const std::optional<SimTime>& time = row.*member;
            return time ? ColumnValue{seconds(*time)} : ColumnValue{};
          },
          [](Row& row, const ColumnValue& value) {
            const double* time_s = std::get_if<double>(&value);
            (row.*member).reset();
            if (time_s != nullptr) row.*member = from_seconds(*time_s);
          },
          moment};
}

// Calendar time of a member, or of the first of two that is known.
template <auto member, auto second = member, class Row = decltype(row_of(member))>
Column<Row> utc(std::string_view name) {
  return {name, ColumnType::utc,
          [](const Row& row, Instant start) {
            std::optional<SimTime> time = row.*member;
            if (!time) time = row.*second;
            return time ? ColumnValue{format_utc(start + *time)} : ColumnValue{};
          },
          nullptr};
}

// Longitude and latitude of a member that is a place.
template <auto member, class Row = decltype(row_of(member))>
Column<Row> lon(std::string_view name) {
  return {
      name,
      ColumnType::real,
      [](const Row& row, Instant) { return from_number(lon_deg(row.*member)); },
      [](Row& row, const ColumnValue& value) { (row.*member).lon_rad = radians(to_number(value)); },
      {.least = -longitude_max_deg, .greatest = longitude_max_deg}};
}

template <auto member, class Row = decltype(row_of(member))>
Column<Row> lat(std::string_view name) {
  return {
      name,
      ColumnType::real,
      [](const Row& row, Instant) { return from_number(lat_deg(row.*member)); },
      [](Row& row, const ColumnValue& value) { (row.*member).lat_rad = radians(to_number(value)); },
      {.least = -latitude_max_deg, .greatest = latitude_max_deg}};
}

template <int axis>
Column<SampleRow> coordinate(std::string_view name) {
  return {name,
          ColumnType::real,
          [](const SampleRow& row, Instant) { return from_number(row.p_S_m[axis]); },
          [](SampleRow& row, const ColumnValue& value) { row.p_S_m[axis] = to_number(value); },
          {.least = -far_m, .greatest = far_m, .is_required = true}};
}

template <std::size_t... k>
void add_quantities(std::vector<Column<SampleRow>>& columns, std::index_sequence<k...>) {
  (columns.push_back(real<quantity_table[k].value>(quantity_table[k].name)), ...);
}

constexpr std::string_view status_words[] = {"not_started", "waiting", "running",    "completed",
                                             "failed",      "skipped", "incomplete", "disabled"};
constexpr std::string_view sight_kinds[] = {"visible", "hidden", "link", "relayed"};

Column<EventRow> status() {
  return {"status",
          ColumnType::text,
          [](const EventRow& row, Instant) { return ColumnValue{to_string(row.status)}; },
          [](EventRow& row, const ColumnValue& value) {
            row.status = event_status(to_string_or_empty(value)).value_or(EventStatus::not_started);
          },
          {.is_required = true, .words = status_words}};
}

constexpr std::array<std::pair<EventStatus, const char*>, 8> status_names{{
    {EventStatus::not_started, "not_started"},
    {EventStatus::waiting, "waiting"},
    {EventStatus::running, "running"},
    {EventStatus::completed, "completed"},
    {EventStatus::failed, "failed"},
    {EventStatus::skipped, "skipped"},
    {EventStatus::incomplete, "incomplete"},
    {EventStatus::disabled, "disabled"},
}};

}  // namespace

template <>
std::span<const Column<SampleRow>> columns<SampleRow>() {
  using R = SampleRow;
  static const std::vector<Column<R>> table = [] {
    std::vector<Column<R>> all{time<&R::time>("time_s"), utc<&R::time>("utc"),
                               limited(text<&R::rover_id>("rover_id"), required),
                               lon<&R::place>("lon_deg"), lat<&R::place>("lat_deg")};
    add_quantities(all, std::make_index_sequence<quantity_table.size()>{});
    // Behind the elevation stands the position in the site's frame.
    const auto elevation = std::ranges::find(all, "elevation_m", &Column<R>::name);
    all.insert(elevation + 1, {coordinate<0>("x_m"), coordinate<1>("y_m"), coordinate<2>("z_m")});
    all.push_back(text<&R::event>("event"));
    all.push_back(text<&R::phase>("phase"));
    return all;
  }();
  return table;
}

template <>
std::span<const Column<JointRow>> columns<JointRow>() {
  using R = JointRow;
  static const Column<R> table[] = {
      time<&R::time>("time_s"),
      limited(text<&R::rover_id>("rover_id"), required),
      text<&R::joint>("joint"),
      real<&R::angle_rad>("angle_rad"),
      real<&R::extension_m>("extension_m"),
  };
  return table;
}

template <>
std::span<const Column<PairRow>> columns<PairRow>() {
  using R = PairRow;
  static const Column<R> table[] = {
      time<&R::time>("time_s"),
      limited(text<&R::from_id>("from_id"), required),
      limited(text<&R::to_id>("to_id"), required),
      real<&R::distance_m>("distance_m"),
      limited(integer<&R::visible>("visible"), flag),
      real<&R::visible_fraction>("visible_fraction"),
      limited(integer<&R::link>("link"), flag),
      text<&R::relay>("relay"),
      utc<&R::time>("utc"),
  };
  return table;
}

template <>
std::span<const Column<SightIntervalRow>> columns<SightIntervalRow>() {
  using R = SightIntervalRow;
  static const Column<R> table[] = {
      limited(text<&R::from_id>("from_id"), required),
      limited(text<&R::to_id>("to_id"), required),
      limited(text<&R::kind>("kind"), {.is_required = true, .words = sight_kinds}),
      time<&R::start>("start_s"),
      time<&R::end>("end_s"),
      real<&R::light_time_s>("light_time_s"),
      text<&R::by>("by"),
      utc<&R::start>("utc"),
      utc<&R::end>("end_utc"),
  };
  return table;
}

template <>
std::span<const Column<PanelRow>> columns<PanelRow>() {
  using R = PanelRow;
  static const Column<R> table[] = {
      time<&R::time>("time_s"),
      limited(text<&R::rover_id>("rover_id"), required),
      text<&R::panel>("panel"),
      real<&R::sun_fraction>("sun_fraction"),
      real<&R::incidence>("incidence"),
      real<&R::power_w>("power_w"),
      real<&R::azimuth_rad>("azimuth_rad"),
      real<&R::elevation_rad>("elevation_rad"),
  };
  return table;
}

template <>
std::span<const Column<ResourceRow>> columns<ResourceRow>() {
  using R = ResourceRow;
  static const Column<R> table[] = {
      time<&R::time>("time_s"),
      limited(text<&R::rover_id>("rover_id"), required),
      text<&R::resource>("resource"),
      real<&R::amount>("amount"),
  };
  return table;
}

template <>
std::span<const Column<EventRow>> columns<EventRow>() {
  using R = EventRow;
  static const Column<R> table[] = {
      limited(text<&R::rover_id>("rover_id"), required),
      limited(integer<&R::sequence>("sequence"), required),
      text<&R::type>("type"),
      text<&R::label>("label"),
      status(),
      text<&R::reason>("reason"),
      optional_time<&R::ready>("ready_s"),
      optional_time<&R::start>("start_s"),
      optional_time<&R::end>("end_s"),
      real<&R::distance_m>("distance_m"),
      real<&R::energy_used_j>("energy_used_j"),
      real<&R::solar_j>("solar_j"),
      utc<&R::start, &R::ready>("utc"),
      utc<&R::end>("end_utc"),
  };
  return table;
}

template <>
std::span<const Column<PhaseRow>> columns<PhaseRow>() {
  using R = PhaseRow;
  static const Column<R> table[] = {
      limited(text<&R::rover_id>("rover_id"), required),
      limited(integer<&R::sequence>("sequence"), required),
      text<&R::phase>("phase"),
      time<&R::start>("start_s"),
      optional_time<&R::end>("end_s"),
  };
  return table;
}

template <>
std::span<const Column<PlannedPathRow>> columns<PlannedPathRow>() {
  using R = PlannedPathRow;
  static const Column<R> table[] = {
      time<&R::time>("time_s"),
      limited(text<&R::rover_id>("rover_id"), required),
      limited(integer<&R::sequence>("sequence"), required),
      integer<&R::leg>("leg"),
      integer<&R::attempt>("attempt"),
      real<&R::length_m>("length_m"),
      real<&R::duration_s>("duration_s"),
      real<&R::energy_j>("energy_j"),
      real<&R::slope_max_rad>("slope_max_rad"),
      lon<&R::steepest>("steepest_lon_deg"),
      lat<&R::steepest>("steepest_lat_deg"),
  };
  return table;
}

template <>
std::span<const Column<NoteRow>> columns<NoteRow>() {
  using R = NoteRow;
  static const Column<R> table[] = {
      time<&R::time>("time_s"),
      limited(text<&R::rover_id>("rover_id"), required),
      limited(integer<&R::sequence>("sequence"), required),
      text<&R::name>("name"),
      limited(text<&R::fields_json>("fields"), {.is_json = true}),
  };
  return table;
}

template <>
std::span<const Column<OrderRow>> columns<OrderRow>() {
  using R = OrderRow;
  static const Column<R> table[] = {
      time<&R::time>("time_s"),
      limited(text<&R::rover_id>("rover_id"), required),
      text<&R::part>("part"),
      text<&R::name>("name"),
      text<&R::order>("standing_order"),
      real<&R::azimuth_rad>("azimuth_rad"),
      real<&R::elevation_rad>("elevation_rad"),
      real<&R::x_m>("x_m"),
      real<&R::y_m>("y_m"),
      real<&R::z_m>("z_m"),
  };
  return table;
}

bool OrderRow::orders_same(const OrderRow& other) const {
  return std::ranges::all_of(columns<OrderRow>(), [&](const Column<OrderRow>& column) {
    return column.name == "time_s" || column.value(*this, {}) == column.value(other, {});
  });
}

bool NoteRow::is_sound() const { return fields_json.empty() || is_json_object(fields_json); }

template <>
std::span<const Column<RunRow>> columns<RunRow>() {
  static const Column<RunRow> table[] = {limited(text<&RunRow::key>("key"), required),
                                         text<&RunRow::value>("value")};
  return table;
}

std::string to_text(const ColumnValue& value) {
  if (const auto* number = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *number);
  if (const auto* number = std::get_if<double>(&value)) return fmt::format("{}", *number);
  return to_string_or_empty(value);
}

const char* to_string(EventStatus status) {
  for (const auto& [known, name] : status_names) {
    if (known == status) return name;
  }
  assertion_failed("every EventStatus has a name", __FILE__, __LINE__);
}

std::optional<EventStatus> event_status(std::string_view name) {
  for (const auto& [status, known] : status_names) {
    if (known == name) return status;
  }
  return std::nullopt;
}

}  // namespace lsos
