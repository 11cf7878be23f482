#include "product/balloon.h"

#include <fmt/format.h>

#include <cmath>

#include "product/quantity_text.h"

namespace lsos {

namespace {

double to_three_digits(double value) {
  if (value == 0 || !std::isfinite(value)) return value;
  const double unit = std::pow(10, std::floor(std::log10(std::abs(value))) - 2);
  return std::round(value / unit) * unit;
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
    html_ += fmt::format("<tr><td>{}<td>{}", what, quantity_text(name, to_three_digits(value), 4));
  }
  void add_share(const std::string& what, double share) {
    if (!std::isnan(share)) html_ += fmt::format("<tr><td>{}<td>{:.3g} %", what, 100 * share);
  }
  std::string html() const { return "<table>" + html_ + "</table>"; }

 private:
  std::string html_;
};

double value_of(const std::optional<double>& value) { return value.value_or(not_modelled); }

// "40 %", "20 to 40 %".
std::string share_text(const std::optional<Expected>& share) {
  if (!share) return "";
  if (share->is_sure()) return fmt::format("{:.3g} %", 100 * share->low);
  return fmt::format("{:.3g} to {:.3g} %", 100 * share->low, 100 * share->high);
}

// "2026-07-01 12:00:00 UTC": a balloon needs no fractions of a second.
std::string day_time(Instant instant) {
  const std::string utc = format_utc(instant);
  return utc.substr(0, 10) + " " + utc.substr(11, 8) + " UTC";
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
  if (row.start && row.end) table.add("Took", "took_s", seconds(*row.end - *row.start));
  if (row.distance_m > 0) table.add("Driven", "distance_m", row.distance_m);
  table.add("Energy used", "energy_used_j", row.energy_used_j);
  table.add("Solar energy", "solar_j", row.solar_j);
  return table.html();
}

std::string balloon(const PlannedPathRow& row) {
  Table table;
  table.add("Length", "length_m", row.length_m);
  table.add("Time", "duration_s", row.duration_s);
  table.add("Energy", "energy_j", row.energy_j);
  table.add("Steepest", "slope_rad", row.slope_max_rad);
  return table.html();
}

std::string balloon(const EventEstimate& event, Instant start) {
  Table table;
  table.add("Expected to fail", event.reason);
  if (event.start_s) table.add("Begins", day_time(start + from_seconds(*event.start_s)));
  if (event.end_s) table.add("Ends", day_time(start + from_seconds(*event.end_s)));
  if (event.start_s && event.end_s) table.add("Takes", "takes_s", *event.end_s - *event.start_s);
  if (event.distance_m > 0.0) table.add("Drives", "distance_m", *event.distance_m);
  table.add("Energy used", "energy_used_j", value_of(event.energy_used_j));
  table.add("Solar energy", "solar_j", value_of(event.solar_j));
  table.add_share("Charge at its end", value_of(event.charge_end));
  table.add_share("Lowest charge", value_of(event.charge_min));
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
