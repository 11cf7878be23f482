#include "lua/check/timeline_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/sim_time.h"
#include "base/utf8.h"
namespace lsos {

namespace {

constexpr double cell_s = 1200;
constexpr int cells_a_day = 72, cells_a_label = 9;  // a label each three hours

struct Bar {
  ShadeSpan time;
  char letter = '?';
};

struct Lane {
  RoverShade shade;
  std::vector<Bar> bars;
};

char letter_of(Activity activity) {
  switch (activity) {
    case Activity::driving:
      return 'D';
    case Activity::crew:
      return 'E';
    case Activity::science:
      return 'S';
    case Activity::energy:
      return 'C';
    case Activity::communication:
      return 'A';
    case Activity::waiting:
      return 'W';
    case Activity::none:
      break;
  }
  return 'O';
}

std::vector<Lane> lanes_of(const MissionEstimate& estimate,
                           const std::map<std::string, Activity>& activities) {
  std::vector<Lane> lanes;
  for (const RoverShade& shade : estimate.shades) lanes.push_back({shade, {}});
  for (const EventEstimate& event : estimate.events) {
    const auto lane = std::ranges::find_if(
        lanes, [&](const Lane& each) { return each.shade.rover_id == event.rover_id; });
    if (lane == lanes.end() || !event.start_s) continue;
    const auto activity = activities.find(event.type);
    lane->bars.push_back(
        {{*event.start_s, event.end_s.value_or(estimate.end_s)},
         letter_of(activity == activities.end() ? Activity::none : activity->second)});
  }
  return lanes;
}

double overlap_s(const ShadeSpan& span, double begin_s) {
  return std::min(span.end_s, begin_s + cell_s) - std::max(span.begin_s, begin_s);
}

// The letter that takes most of a cell; an event that is over at once counts where nothing else is.
char letter_at(const Lane& lane, double begin_s) {
  std::map<char, double> taken_s;
  for (const Bar& bar : lane.bars) {
    const double share_s = overlap_s(bar.time, begin_s);
    if (share_s >= 0 && bar.time.begin_s < begin_s + cell_s) taken_s[bar.letter] += share_s;
  }
  const auto most =
      std::ranges::max_element(taken_s, {}, [](const auto& entry) { return entry.second; });
  return most == taken_s.end() ? '.' : most->first;
}

// The letters of all cells. Drives are what a planner looks for, so that each has one.
std::string letters_of(const Lane& lane, int cells) {
  std::string letters;
  for (int cell = 0; cell < cells; ++cell) letters += letter_at(lane, cell * cell_s);
  for (const Bar& bar : lane.bars) {
    if (bar.letter != 'D' || letters.empty()) continue;
    const auto cell_of = [&](double time_s) {
      return std::min(letters.size() - 1, static_cast<std::size_t>(time_s / cell_s));
    };
    const std::size_t first = cell_of(bar.time.begin_s), last = cell_of(bar.time.end_s);
    if (letters.substr(first, last + 1 - first).find('D') != std::string::npos) continue;
    letters[cell_of((bar.time.begin_s + bar.time.end_s) / 2)] = 'D';
  }
  return letters;
}

// Whether the spans take more than half of a cell.
bool covers(const std::vector<ShadeSpan>& spans, double begin_s) {
  double sum_s = 0;
  for (const ShadeSpan& span : spans) sum_s += std::max(0.0, overlap_s(span, begin_s));
  return sum_s > cell_s / 2;
}

char shade_at(const Lane& lane, double begin_s) {
  const bool is_dark = covers(lane.shade.dark, begin_s),
             is_stowed = covers(lane.shade.stowed, begin_s),
             is_unseen = covers(lane.shade.unseen, begin_s);
  if ((is_dark || is_stowed) && is_unseen) return 'b';
  return is_dark ? 'n' : is_stowed ? 's' : is_unseen ? 'e' : ' ';
}

// "06:00    09:00    ...", the clock at the beginning of each label's cells.
std::string clock_line(Instant start, double day_begin_s) {
  std::string line;
  for (int cell = 0; cell < cells_a_day; cell += cells_a_label) {
    const Instant at = start + from_seconds(day_begin_s + cell * cell_s);
    line += fmt::format("{:<{}}", format_utc(at).substr(11, 5), cells_a_label);
  }
  return line;
}

std::string without_end_blanks(std::string line) {
  line.resize(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

}  // namespace

std::string timeline_text(const MissionEstimate& estimate,
                          const std::map<std::string, Activity>& activities, Instant start) {
  const std::vector<Lane> lanes = lanes_of(estimate, activities);
  std::size_t width = 5;
  for (const Lane& lane : lanes) {
    width = std::max(width, std::min<std::size_t>(lane.shade.rover_id.size(), 12));
  }
  const int cells = static_cast<int>(std::ceil(estimate.end_s / cell_s - 1e-9));
  std::vector<std::string> letters;
  for (const Lane& lane : lanes) letters.push_back(letters_of(lane, cells));
  std::string text;
  const int days = std::max(1, static_cast<int>(std::ceil(estimate.end_s / day_length_s - 1e-9)));
  for (int day = 0; day < days; ++day) {
    const double begin_s = day * day_length_s;
    text += fmt::format("day {}, {}\n", day + 1,
                        format_utc(start + from_seconds(begin_s)).substr(0, 10));
    text +=
        without_end_blanks(fmt::format("  {:<{}} {}", "UTC", width, clock_line(start, begin_s)));
    for (std::size_t k = 0; k < lanes.size(); ++k) {
      const Lane& lane = lanes[k];
      const auto first = static_cast<std::size_t>(day * cells_a_day);
      const std::string events =
          letters[k].size() > first ? letters[k].substr(first, cells_a_day) : "";
      std::string shades;
      for (int cell = 0; cell < cells_a_day; ++cell) {
        const double at_s = begin_s + cell * cell_s;
        shades += at_s < estimate.end_s ? shade_at(lane, at_s) : ' ';
      }
      const std::string id = beginning(lane.shade.rover_id, width);
      text += without_end_blanks(fmt::format("  {:<{}} {}", id, width, events));
      if (shades.find_first_not_of(' ') == std::string::npos) continue;
      text += without_end_blanks(fmt::format("  {:<{}} {}", "", width, shades));
    }
  }
  return text;
}

}  // namespace lsos
