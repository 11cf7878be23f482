#include "product/balloon.h"

#include <fmt/format.h>

#include <cmath>

#include "product/quantity_text.h"

namespace lsos {

namespace {

std::string html_text(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    escaped += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  }
  return escaped;
}

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
    html_ += fmt::format("<tr><td>{}<td>{}", what, quantity_text(name, to_three_digits(value)));
  }
  void add_share(const std::string& what, double share) {
    if (!std::isnan(share)) html_ += fmt::format("<tr><td>{}<td>{:.3g} %", what, 100 * share);
  }
  std::string html() const { return "<table>" + html_ + "</table>"; }

 private:
  std::string html_;
};

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

}  // namespace lsos
