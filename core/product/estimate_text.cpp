#include "product/estimate_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

namespace lsos {

namespace {

using Json = nlohmann::ordered_json;

Json to_json(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json to_json(const std::optional<Expected>& value) {
  if (!value) return {};
  if (value->is_sure()) return value->low;
  return {{"low", value->low}, {"high", value->high}};
}

// More lines than this are summed up by rover and day.
constexpr std::size_t lines_max = 40;
constexpr double day_s = 86400;

// A line of the table; times and shares are those of all its events together.
struct Line {
  std::string name;
  std::optional<double> start_s, end_s;
  std::optional<double> distance_m, energy_used_j, solar_j, charge_end, charge_min;
  double all_s = 0, lit_s = 0, seen_s = 0;  // time that shares are of
  bool is_lit_known = false, is_seen_known = false;
};

void add(std::optional<double>& sum, const std::optional<double>& value) {
  if (value) sum = sum.value_or(0) + *value;
}

void add(Line& line, const EventEstimate& event) {
  if (event.start_s && !line.start_s) line.start_s = event.start_s;
  if (!event.end_s) return;
  line.end_s = event.end_s;
  add(line.distance_m, event.distance_m);
  add(line.energy_used_j, event.energy_used_j);
  add(line.solar_j, event.solar_j);
  line.charge_end = event.charge_end;
  if (event.charge_min) {
    line.charge_min = std::min(line.charge_min.value_or(*event.charge_min), *event.charge_min);
  }
  const double takes_s = *event.end_s - *event.start_s;
  line.all_s += takes_s;
  line.is_lit_known |= event.sunlit_share.has_value();
  line.is_seen_known |= event.earth_visible_share.has_value();
  if (event.sunlit_share) line.lit_s += takes_s * event.sunlit_share->middle();
  if (event.earth_visible_share) line.seen_s += takes_s * event.earth_visible_share->middle();
}

Line line_of(const EventEstimate& event) {
  Line line;
  line.name = fmt::format("{} {} '{}'", event.rover_id, event.sequence, event.label);
  add(line, event);
  return line;
}

// Events that do not start belong to the day of the one before them.
std::vector<Line> lines_by_days(const std::vector<EventEstimate>& events) {
  for (int days = 1;; ++days) {
    std::vector<Line> lines;
    std::string rover_id;
    int span = -1;
    for (const EventEstimate& event : events) {
      const bool is_new_rover = event.rover_id != rover_id;
      const int its = event.start_s  ? static_cast<int>(*event.start_s / day_s) / days
                      : is_new_rover ? 0
                                     : span;
      if (is_new_rover || its != span) {
        const int first = its * days + 1;
        lines.emplace_back().name =
            days == 1 ? fmt::format("{} day {}", event.rover_id, first)
                      : fmt::format("{} days {} to {}", event.rover_id, first, first + days - 1);
        rover_id = event.rover_id;
        span = its;
      }
      add(lines.back(), event);
    }
    if (lines.size() <= lines_max || days > 366) return lines;
  }
}

std::string time_text(const std::optional<double>& time_s) {
  if (!time_s) return "-";
  const auto minutes = static_cast<long long>(std::floor(*time_s / 60));
  return fmt::format("{} {:02}:{:02}", minutes / 1440 + 1, minutes / 60 % 24, minutes % 60);
}

std::string number_text(const std::optional<double>& value, double unit, int digits,
                        const char* suffix = "") {
  return value ? fmt::format("{:.{}f}{}", *value / unit, digits, suffix) : "-";
}

// In quotes where the text has a separator, a quote or a line end.
std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string row_text(const Line& line, std::size_t width) {
  const auto share = [&](bool is_known, double of_s) -> std::optional<double> {
    if (!is_known || line.all_s <= 0) return {};
    return of_s / line.all_s;
  };
  return fmt::format(
      "  {:<{}}  {:>9}  {:>9} {:>8} {:>8} {:>8} {:>7} {:>7} {:>6} {:>6}\n", line.name, width,
      time_text(line.start_s), time_text(line.end_s), number_text(line.distance_m, 1000, 3),
      number_text(line.energy_used_j, 3.6e6, 3), number_text(line.solar_j, 3.6e6, 3),
      number_text(line.charge_end, 0.01, 1, "%"), number_text(line.charge_min, 0.01, 1, "%"),
      number_text(share(line.is_lit_known, line.lit_s), 0.01, 0, "%"),
      number_text(share(line.is_seen_known, line.seen_s), 0.01, 0, "%"));
}

}  // namespace

Json estimate_json(const MissionEstimate& estimate) {
  Json events = Json::array();
  for (const EventEstimate& event : estimate.events) {
    events.push_back({{"rover_id", event.rover_id},
                      {"sequence", event.sequence},
                      {"label", event.label},
                      {"start_s", to_json(event.start_s)},
                      {"end_s", to_json(event.end_s)},
                      {"distance_m", to_json(event.distance_m)},
                      {"energy_used_j", to_json(event.energy_used_j)},
                      {"solar_j", to_json(event.solar_j)},
                      {"charge_end", to_json(event.charge_end)},
                      {"charge_min", to_json(event.charge_min)},
                      {"sunlit_share", to_json(event.sunlit_share)},
                      {"earth_visible_share", to_json(event.earth_visible_share)}});
  }
  return events;
}

std::string estimate_file_text(const MissionEstimate& estimate) {
  Json days = Json::array();
  for (const DayEstimate& day : estimate.days) {
    days.push_back({{"rover_id", day.rover_id},
                    {"day", day.day},
                    {"distance_m", day.distance_m},
                    {"energy_used_j", to_json(day.energy_used_j)},
                    {"solar_j", to_json(day.solar_j)},
                    {"charge_min", to_json(day.charge_min)},
                    {"charge_end", to_json(day.charge_end)}});
  }
  const Json whole{
      {"events", estimate_json(estimate)}, {"days", days}, {"cut_short", estimate.cut_short}};
  return whole.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string estimate_csv(const MissionEstimate& estimate) {
  std::string text =
      "rover_id,sequence,type,label,start_s,end_s,distance_m,energy_used_j,solar_j,charge_end,"
      "charge_min,sunlit_share_low,sunlit_share_high,earth_visible_share_low,"
      "earth_visible_share_high\n";
  for (const EventEstimate& event : estimate.events) {
    text += fmt::format("{},{},{},{}", cell(event.rover_id), event.sequence, cell(event.type),
                        cell(event.label));
    for (const auto& value : {event.start_s, event.end_s, event.distance_m, event.energy_used_j,
                              event.solar_j, event.charge_end, event.charge_min}) {
      text += value ? fmt::format(",{}", *value) : ",";
    }
    for (const auto& share : {event.sunlit_share, event.earth_visible_share}) {
      text += share ? fmt::format(",{},{}", share->low, share->high) : ",,";
    }
    text += "\n";
  }
  return text;
}

std::string estimate_text(const MissionEstimate& estimate, bool is_verbose) {
  if (estimate.events.empty()) return "";
  const bool is_each = is_verbose || estimate.events.size() <= lines_max;
  std::vector<Line> lines;
  if (is_each) {
    for (const EventEstimate& event : estimate.events) lines.push_back(line_of(event));
  } else {
    lines = lines_by_days(estimate.events);
  }
  std::size_t width = 0;
  for (const Line& line : lines) width = std::max(width, line.name.size());
  std::string text = fmt::format(
      "  {:<{}}  {:>9}  {:>9} {:>8} {:>8} {:>8} {:>7} {:>7} {:>6} {:>6}\n", "estimate", width,
      "start", "end", "km", "used kWh", "sun kWh", "charge", "least", "lit", "Earth");
  for (const Line& line : lines) text += row_text(line, width);
  if (!is_each) {
    text += fmt::format("  {} events in all: --verbose lists them\n", estimate.events.size());
  }
  if (!estimate.cut_short.empty()) {
    text += fmt::format("  the estimate is cut short, {}\n", estimate.cut_short);
  }
  return text;
}

}  // namespace lsos
