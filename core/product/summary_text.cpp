#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "product/summary.h"

namespace lsos {

namespace {

// A screen of 24 rows minus the lines around the events.
constexpr std::size_t events_on_a_screen = 16;

// Examples: "2 d 03 h", "3 h 05 min", "5 min 07 s", "7.5 s".
std::string span_text(double time_s) {
  if (!std::isfinite(time_s)) return "-";
  if (time_s < 60) return fmt::format("{:.1f} s", time_s);
  const auto whole_s = std::llround(time_s);
  const long long minutes = whole_s / 60, hours = minutes / 60, days = hours / 24;
  if (minutes < 60) return fmt::format("{} min {:02} s", minutes, whole_s % 60);
  if (hours < 24) return fmt::format("{} h {:02} min", hours, minutes % 60);
  return fmt::format("{} d {:02} h", days, hours % 24);
}

std::string distance_text(double distance_m) {
  if (!std::isfinite(distance_m)) return "-";
  return fmt::format("{:.1f} m", distance_m);
}

std::string rover_lines(const RunSummary& summary) {
  std::string text =
      fmt::format("\n{:<16} {:>12} {:>14} {:>14}\n", "rover", "distance", "duration", "driving");
  for (const auto& [id, rover] : summary.rovers) {
    text += fmt::format("{:<16} {:>12} {:>14} {:>14}\n", id, distance_text(rover.distance_m),
                        span_text(rover.duration_s), span_text(rover.drive_s));
  }
  return text;
}

std::string event_line(const EventRow& event) {
  const std::string took =
      event.start && event.end ? span_text(seconds(*event.end - *event.start)) : "";
  std::string line = fmt::format("{:<16} {:<24} {:<12} {:>12}",
                                 fmt::format("{}/{}", event.rover_id, event.sequence), event.label,
                                 to_string(event.status), took);
  if (!event.reason.empty()) line += "  " + event.reason;
  line.erase(line.find_last_not_of(' ') + 1);
  return line + '\n';
}

std::string event_lines(const RunSummary& summary) {
  const bool has_room = summary.events.size() <= events_on_a_screen;
  const auto is_shown = [&](const EventRow& event) {
    return has_room || event.status != EventStatus::completed;
  };
  std::string text = "\n";
  std::size_t shown = 0;
  for (const EventRow& event : summary.events) {
    if (!is_shown(event) || shown == events_on_a_screen) continue;
    text += event_line(event);
    ++shown;
  }
  const auto completed =
      std::ranges::count(summary.events, EventStatus::completed, &EventRow::status);
  text += fmt::format("{} of {} events completed", completed, summary.events.size());
  const std::size_t hidden = summary.events.size() - static_cast<std::size_t>(completed);
  if (!has_room && hidden > shown) text += fmt::format("; {} more did not", hidden - shown);
  return text + '\n';
}

}  // namespace

std::string to_text(const RunSummary& summary) {
  std::string text = fmt::format("{}: {}\n", summary.plan, to_string(summary.status));
  if (!summary.from.empty()) text += fmt::format("begins as {} ended\n", summary.from);
  text += fmt::format("simulated {} in {}", span_text(summary.sim_s), span_text(summary.wall_s));
  if (summary.wall_s > 0) {
    text += fmt::format(", {:.0f} x real time", summary.sim_s / summary.wall_s);
  }
  text += '\n';
  if (summary.branch) {
    const std::string& changes = summary.branch->changes;
    text += fmt::format("a branch of {} from {} on, {}\n", summary.branch->folder,
                        span_text(seconds(summary.branch->time)),
                        changes.empty() ? "with nothing changed" : changes);
  }
  if (!summary.rovers.empty()) text += rover_lines(summary);
  text += event_lines(summary);
  const std::size_t warnings = summary.warnings.size();
  if (warnings > 0) text += fmt::format("{} warning{}\n", warnings, warnings == 1 ? "" : "s");
  return text;
}

}  // namespace lsos
