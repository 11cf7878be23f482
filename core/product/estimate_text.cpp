#include "product/estimate_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/csv.h"
#include "planet/utc.h"

namespace lsos {

namespace {

using Json = nlohmann::ordered_json;

Json to_json(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json to_json(const std::optional<Expected>& value) {
  if (!value) return {};
  if (value->is_sure()) return value->low;
  return {{"low", value->low}, {"high", value->high}};
}

// A range where there is one, else the value.
Json to_json(const std::optional<double>& value, const std::optional<Expected>& range) {
  return range ? to_json(range) : to_json(value);
}

// More lines than this are summed up by rover and day.
constexpr std::size_t lines_max = 40;
constexpr double day_s = 86400;

std::optional<Expected> range_of(const std::optional<double>& value,
                                 const std::optional<Expected>& range) {
  if (range || !value) return range;
  return Expected::exactly(*value);
}

// A line of the table; times and shares are those of all its events together.
struct Line {
  std::string name;
  std::optional<double> distance_m, solar_j;
  std::optional<Expected> start_s, end_s, energy_used_j, charge_end, charge_min;
  int failing = 0, cut_off = 0, skipped = 0, not_begun = 0;  // events that do not complete
  double all_s = 0;                                          // time that shares are of
  Expected lit_s, seen_s;
  bool is_lit_known = false, is_seen_known = false;
};

void add(std::optional<double>& sum, const std::optional<double>& value) {
  if (value) sum = sum.value_or(0) + *value;
}

void add(std::optional<Expected>& sum, const std::optional<Expected>& value) {
  if (!value) return;
  const Expected before = sum.value_or(Expected{});
  sum = Expected{before.low + value->low, before.high + value->high};
}

void add(Expected& sum_s, double takes_s, const std::optional<Expected>& share) {
  if (!share) return;
  sum_s.low += takes_s * share->low;
  sum_s.high += takes_s * share->high;
}

void add_outcome(Line& line, EventStatus status) {
  if (status == EventStatus::failed) ++line.failing;
  if (status == EventStatus::incomplete) ++line.cut_off;
  if (status == EventStatus::skipped) ++line.skipped;
  if (status == EventStatus::not_started) ++line.not_begun;
}

void add(Line& line, const EventEstimate& event) {
  add_outcome(line, event.status);
  if (!line.start_s) line.start_s = range_of(event.start_s, event.start_range_s);
  if (!event.end_s) return;
  line.end_s = range_of(event.end_s, event.end_range_s);
  add(line.distance_m, event.distance_m);
  add(line.energy_used_j, range_of(event.energy_used_j, event.energy_range_j));
  add(line.solar_j, event.solar_j);
  line.charge_end = range_of(event.charge_end, event.charge_end_range);
  const auto least = range_of(event.charge_min, event.charge_min_range);
  if (least && (!line.charge_min || least->low < line.charge_min->low)) line.charge_min = least;
  const double takes_s = *event.end_s - *event.start_s;
  line.all_s += takes_s;
  line.is_lit_known |= event.sunlit_share.has_value();
  line.is_seen_known |= event.earth_visible_share.has_value();
  add(line.lit_s, takes_s, event.sunlit_share);
  add(line.seen_s, takes_s, event.earth_visible_share);
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

std::string clock_text(double time_s, bool has_day) {
  const auto minutes = static_cast<long long>(std::floor(time_s / 60));
  const std::string clock = fmt::format("{:02}:{:02}", minutes / 60 % 24, minutes % 60);
  return has_day ? fmt::format("{} {}", minutes / 1440 + 1, clock) : clock;
}

// "2 05:10", of a range "2 05:10-05:14".
std::string time_cell(const std::optional<Expected>& time_s) {
  if (!time_s) return "-";
  const std::string low = clock_text(time_s->low, true), high = clock_text(time_s->high, true);
  if (low == high) return low;
  const bool is_same_day = low.substr(0, low.find(' ')) == high.substr(0, high.find(' '));
  return low + "-" + clock_text(time_s->high, !is_same_day);
}

std::string number_text(const std::optional<double>& value, double unit, int digits,
                        const char* suffix = "") {
  return value ? fmt::format("{:.{}f}{}", *value / unit, digits, suffix) : "-";
}

// "3.12-3.61", of a range too narrow to be told one number.
std::string range_text(const std::optional<Expected>& value, double unit, int digits,
                       const char* suffix = "") {
  if (!value) return "-";
  const std::string low = number_text(value->low, unit, digits),
                    high = number_text(value->high, unit, digits);
  if (low == high) return number_text(value->middle(), unit, digits, suffix);
  return low + "-" + high + suffix;
}

// In kWh; of a range fewer digits, where they show it.
std::string energy_text(const std::optional<Expected>& energy_j) {
  const std::string text = range_text(energy_j, 3.6e6, 2);
  return text.find('-', 1) != std::string::npos ? text : range_text(energy_j, 3.6e6, 3);
}

// "fails"; of several events "1 fails, 3 never begin".
std::string outcome_text(const Line& line, bool is_each) {
  std::string text;
  const auto tell = [&](int count, const char* one, const char* many) {
    if (count == 0) return;
    if (!text.empty()) text += ", ";
    text += is_each ? one : fmt::format("{} {}", count, count == 1 ? one : many);
  };
  tell(line.failing, "fails", "fail");
  tell(line.cut_off, "is cut off", "are cut off");
  tell(line.skipped, "is skipped", "are skipped");
  tell(line.not_begun, "never begins", "never begin");
  return text;
}

using Cells = std::vector<std::string>;

Cells cells_of(const Line& line, bool is_each) {
  const auto share = [&](bool is_known, const Expected& of_s) -> std::optional<Expected> {
    if (!is_known || line.all_s <= 0) return {};
    return Expected{of_s.low / line.all_s, of_s.high / line.all_s};
  };
  return {line.name,
          time_cell(line.start_s),
          time_cell(line.end_s),
          number_text(line.distance_m, 1000, 3),
          energy_text(line.energy_used_j),
          number_text(line.solar_j, 3.6e6, 3),
          range_text(line.charge_end, 0.01, 1, "%"),
          range_text(line.charge_min, 0.01, 1, "%"),
          range_text(share(line.is_lit_known, line.lit_s), 0.01, 0, "%"),
          range_text(share(line.is_seen_known, line.seen_s), 0.01, 0, "%"),
          outcome_text(line, is_each)};
}

// The first column and the last, of words, on the left, all others on the right.
std::string table_text(const std::vector<Cells>& rows) {
  std::vector<std::size_t> widths;
  for (const Cells& row : rows) {
    widths.resize(row.size());
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
  }
  std::string text;
  for (const Cells& row : rows) {
    text += fmt::format("  {:<{}}", row[0], widths[0]);
    for (std::size_t k = 1; k + 1 < row.size(); ++k) {
      text += fmt::format("  {:>{}}", row[k], widths[k]);
    }
    text += (row.back().empty() ? "" : "  " + row.back()) + "\n";
  }
  return text;
}

}  // namespace

Json estimate_json(const MissionEstimate& estimate) {
  Json events = Json::array();
  for (const EventEstimate& event : estimate.events) {
    events.push_back({{"rover_id", event.rover_id},
                      {"sequence", event.sequence},
                      {"label", event.label},
                      {"status", to_string(event.status)},
                      {"reason", event.reason},
                      {"start_s", to_json(event.start_s, event.start_range_s)},
                      {"end_s", to_json(event.end_s, event.end_range_s)},
                      {"distance_m", to_json(event.distance_m)},
                      {"energy_used_j", to_json(event.energy_used_j, event.energy_range_j)},
                      {"solar_j", to_json(event.solar_j)},
                      {"charge_end", to_json(event.charge_end, event.charge_end_range)},
                      {"charge_min", to_json(event.charge_min, event.charge_min_range)},
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
                    {"energy_used_j", to_json(day.energy_used_j, day.energy_range_j)},
                    {"solar_j", to_json(day.solar_j)},
                    {"charge_min", to_json(day.charge_min, day.charge_min_range)},
                    {"charge_end", to_json(day.charge_end, day.charge_end_range)}});
  }
  const Json whole{
      {"events", estimate_json(estimate)}, {"days", days}, {"cut_short", estimate.cut_short}};
  return whole.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string estimate_csv(const MissionEstimate& estimate, Instant mission_start) {
  const auto utc = [&](const std::optional<double>& time_s) {
    return time_s ? format_utc(mission_start + from_seconds(*time_s)) : "";
  };
  // New columns stand last, as some readers count them.
  std::string text =
      "rover_id,sequence,type,label,start_s,end_s,distance_m,energy_used_j,solar_j,charge_end,"
      "charge_min,sunlit_share_low,sunlit_share_high,earth_visible_share_low,"
      "earth_visible_share_high,end_s_low,end_s_high,energy_used_j_low,energy_used_j_high,"
      "charge_end_low,charge_end_high,charge_min_low,charge_min_high,status,reason,"
      "start_utc,end_utc,start_s_low,start_s_high\n";
  const auto range_cells = [](const std::optional<Expected>& range) {
    return range ? fmt::format(",{},{}", range->low, range->high) : ",,";
  };
  for (const EventEstimate& event : estimate.events) {
    text += fmt::format("{},{},{},{}", csv_cell(event.rover_id), event.sequence,
                        csv_cell(event.type), csv_cell(event.label));
    for (const auto& value : {event.start_s, event.end_s, event.distance_m, event.energy_used_j,
                              event.solar_j, event.charge_end, event.charge_min}) {
      text += value ? fmt::format(",{}", *value) : ",";
    }
    for (const auto& range :
         {event.sunlit_share, event.earth_visible_share, range_of(event.end_s, event.end_range_s),
          range_of(event.energy_used_j, event.energy_range_j),
          range_of(event.charge_end, event.charge_end_range),
          range_of(event.charge_min, event.charge_min_range)}) {
      text += range_cells(range);
    }
    text += fmt::format(",{},{},{},{}", to_string(event.status), csv_cell(event.reason),
                        utc(event.start_s), utc(event.end_s));
    text += range_cells(range_of(event.start_s, event.start_range_s)) + "\n";
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
  std::vector<Cells> rows{{"estimate", "start", "end", "km", "used kWh", "sun kWh", "charge",
                           "least", "lit", "Earth", ""}};
  for (const Line& line : lines) rows.push_back(cells_of(line, is_each));
  std::string text =
      "  estimated: start and end as day and hh:mm since the mission's start; used by events "
      "alone, "
      "not while waiting between them\n" +
      table_text(rows);
  if (!is_each) {
    text += fmt::format("  {} events in all: --verbose lists them\n", estimate.events.size());
  }
  if (!estimate.cut_short.empty()) {
    text += fmt::format("  the estimate is cut short, {}\n", estimate.cut_short);
  }
  return text;
}

}  // namespace lsos
