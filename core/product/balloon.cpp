#include "product/balloon.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/replaced.h"
#include "product/quantity_text.h"

namespace lsos {

namespace {

// "8 min 46 s", "2 h 05 min", "3 d 04 h"; below a minute "12.3 s".
std::string duration_text(double duration_s) {
  if (duration_s < 59.95) return fmt::format("{:.3g} s", duration_s);
  const auto whole_s = std::llround(duration_s);
  if (whole_s < 3600) return fmt::format("{} min {:02} s", whole_s / 60, whole_s % 60);
  const auto minutes = std::llround(duration_s / 60);
  if (minutes < 1440) return fmt::format("{} h {:02} min", minutes / 60, minutes % 60);
  const auto hours = std::llround(duration_s / 3600);
  return fmt::format("{} d {:02} h", hours / 24, hours % 24);
}

// "2.84 kWh", "2.84 to 3.01 kWh".
std::string quantity_range_text(const std::string& name, const Expected& range) {
  std::string low = quantity_text(name, range.low, 3);
  const std::string high = quantity_text(name, range.high, 3);
  if (low == high) return low;
  const std::size_t unit = low.rfind(' ');
  if (unit != std::string::npos && high.ends_with(low.substr(unit))) low.resize(unit);
  return low + " to " + high;
}

// Rows of one table.
class Table {
 public:
  void add(const std::string& what, const std::string& value) {
    if (!value.empty()) html_ += fmt::format("<tr><td>{}<td>{}", what, html_text(value));
  }
  // The suffix of `name` gives the unit, as in the log.
  void add(const std::string& what, const std::string& name, double value) {
    if (std::isnan(value)) return;
    html_ += fmt::format("<tr><td>{}<td>{}", what, quantity_text(name, value, 3));
  }
  // The range where there is one, else the value.
  void add(const std::string& what, const std::string& name, const std::optional<double>& value,
           const std::optional<Expected>& range) {
    if (value) add(what, quantity_range_text(name, range.value_or(Expected::exactly(*value))));
  }
  void add_share(const std::string& what, double share) {
    if (!std::isnan(share)) html_ += fmt::format("<tr><td>{}<td>{:.3g} %", what, 100 * share);
  }
  std::string html() const { return "<table>" + html_ + "</table>"; }

 private:
  std::string html_;
};

// "40 %", "20 to 40 %".
std::string share_text(const std::optional<Expected>& share) {
  return share ? quantity_range_text("_share", *share) : "";
}

// "2026-07-01 12:00:00 UTC": a balloon needs no fractions of a second.
std::string day_time(Instant instant) {
  const std::string utc = format_utc(instant);
  return utc.substr(0, 10) + " " + utc.substr(11, 8) + " UTC";
}

// "2026-07-01 12:00:00 UTC", of a range "2026-07-01 12:00:00 to 12:08:30 UTC".
std::string time_text(double expected_s, const std::optional<Expected>& range_s, Instant start) {
  const auto at = [&](double time_s) { return day_time(start + from_seconds(time_s)); };
  if (!range_s) return at(expected_s);
  const std::string low = at(range_s->low), high = at(range_s->high);
  const bool is_same_day = low.substr(0, 10) == high.substr(0, 10);
  return low.substr(0, 19) + " to " + (is_same_day ? high.substr(11) : high);
}

}  // namespace

std::string balloon(const SampleRow& row, Instant start) {
  Table table;
  table.add("Time", day_time(start + row.time));
  table.add("Event", row.event + (row.phase.empty() ? "" : ", " + row.phase));
  table.add("Driven", "distance_m", row.distance_m);
  if (!std::isnan(row.speed_mps)) table.add("Speed", fmt::format("{:.3g} m/s", row.speed_mps));
  table.add("Slope", "slope_rad", row.slope_rad);
  table.add_share("Slip", row.slip);
  table.add("Elevation", "elevation_m", row.elevation_m);
  table.add_share("Charge", row.charge);
  table.add("Energy rate", "energy_rate_w", row.energy_rate_w);
  table.add("Solar power", "solar_w", row.solar_w);
  table.add("Loads", "load_w", row.load_w);
  table.add("Driving", "drive_w", row.drive_w);
  table.add_share("Sun on panels", row.sun_fraction);
  return table.html();
}

std::string balloon(const EventRow& row, Instant start) {
  Table table;
  table.add("Status", to_string(row.status));
  table.add("Why", row.reason);
  table.add("Event", fmt::format("{} {}/{}", row.type, row.rover_id, row.sequence));
  if (row.start) table.add("Began", day_time(start + *row.start));
  if (row.end) table.add("Ended", day_time(start + *row.end));
  if (row.start && row.end) {
    table.add("Took", duration_text(seconds(*row.end - *row.start)));
  }
  if (row.distance_m > 0) table.add("Driven", "distance_m", row.distance_m);
  table.add("Energy used", "energy_used_j", row.energy_used_j);
  table.add("Solar energy", "solar_j", row.solar_j);
  return table.html();
}

std::string balloon(const PlannedPathRow& row) {
  Table table;
  table.add("Length", "length_m", row.length_m);
  table.add("Time", duration_text(row.duration_s));
  table.add("Energy", "energy_j", row.energy_j);
  table.add("Steepest", "slope_rad", row.slope_max_rad);
  return table.html();
}

std::string balloon(const NoteRow& note, Instant start) {
  Table table;
  table.add("Rover", note.rover_id);
  table.add("Time", day_time(start + note.time));
  const auto fields = nlohmann::ordered_json::parse(note.fields_json, nullptr, false);
  if (!fields.is_object()) return table.html();
  for (const auto& [name, value] : fields.items()) {
    std::string label = replaced(name, "_", " ");
    if (!label.empty() && label[0] >= 'a' && label[0] <= 'z') {
      label[0] = static_cast<char>(label[0] - 'a' + 'A');
    }
    table.add(html_text(label), value.is_string() ? value.get<std::string>() : value.dump());
  }
  return table.html();
}

std::string balloon(const EventEstimate& event, Instant start) {
  Table table;
  if (event.status != EventStatus::completed) table.add("Expected", to_string(event.status));
  table.add("Why", event.reason);
  if (event.start_s) {
    table.add("Begins", time_text(*event.start_s, event.start_range_s, start));
  }
  if (event.end_s) table.add("Ends", time_text(*event.end_s, event.end_range_s, start));
  if (event.start_s && event.end_s) {
    table.add("Takes", duration_text(*event.end_s - *event.start_s));
  }
  if (event.distance_m > 0.0) table.add("Drives", "distance_m", *event.distance_m);
  table.add("Energy used", "energy_used_j", event.energy_used_j, event.energy_range_j);
  table.add("Solar energy", "solar_j", event.solar_j, {});
  table.add("Charge at its end", "charge_share", event.charge_end, event.charge_end_range);
  table.add("Lowest charge", "charge_share", event.charge_min, event.charge_min_range);
  table.add("Panels in the Sun", share_text(event.sunlit_share));
  table.add("Earth in view", share_text(event.earth_visible_share));
  return table.html();
}

std::string html_text(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    escaped += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  }
  return escaped;
}

}  // namespace lsos
