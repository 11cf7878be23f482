#include "lua/check/check_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/text.h"

namespace lsos {

namespace {

std::string verdict(const MissionModel& files, std::size_t warnings) {
  const Plan& plan = files.plan;
  std::string text =
      fmt::format("{} can be run{}: {}, {}", plan.file,
                  warnings == 0 ? ", nothing is wrong with it"
                                : fmt::format(", with {}", counted(warnings, "warning")),
                  counted(plan.rovers.size(), "rover"), counted(plan.events.size(), "event"));
  if (!plan.assets.empty()) text += ", " + counted(plan.assets.size(), "asset");
  if (plan.decoration_count > 0) {
    text += fmt::format("; {} left alone", counted(static_cast<std::size_t>(plan.decoration_count),
                                                   "other Placemark"));
  }
  return text + "\n";
}

std::string leg_text(const PlannedLegLine& leg) {
  const std::string name =
      fmt::format("  planned: {} '{}' to waypoint {}", leg.rover_id, leg.label, leg.waypoint);
  if (leg.is_passed) return name + ": already there\n";
  const std::string backing =
      leg.gear_changes == 0
          ? ""
          : fmt::format(", backs up with {}", counted(leg.gear_changes, "gear change"));
  return fmt::format("{}: {:.1f} m, {:.0f} s, {:.1f} Wh, steepest {:.1f} deg at {:.6f},{:.6f}{}\n",
                     name, leg.length_m, leg.duration_s, leg.energy_j / 3600, leg.slope_max_deg,
                     leg.steepest_lon_deg, leg.steepest_lat_deg, backing);
}

// Many legs make a line a rover.
constexpr std::size_t legs_listed_max = 30;

std::string rover_text(const std::string& rover_id, const std::vector<PlannedLegLine>& legs) {
  std::size_t count = 0, backing = 0;
  double length_m = 0, duration_s = 0, energy_j = 0;
  const PlannedLegLine* steepest = nullptr;
  for (const PlannedLegLine& leg : legs) {
    if (leg.rover_id != rover_id || leg.is_passed) continue;
    ++count;
    length_m += leg.length_m;
    duration_s += leg.duration_s;
    energy_j += leg.energy_j;
    backing += leg.gear_changes == 0 ? 0 : 1;
    if (steepest == nullptr || leg.slope_max_deg > steepest->slope_max_deg) steepest = &leg;
  }
  if (steepest == nullptr) return "";
  return fmt::format(
      "  planned: {}: {}, {:.1f} km, {:.1f} h of driving, {:.1f} kWh, steepest {:.1f} deg at "
      "{:.6f},{:.6f} on '{}'{}\n",
      rover_id, counted(count, "leg"), length_m / 1000, duration_s / 3600, energy_j / 3.6e6,
      steepest->slope_max_deg, steepest->steepest_lon_deg, steepest->steepest_lat_deg,
      steepest->label,
      backing == 0 ? "" : fmt::format("; on {} it backs up", counted(backing, "leg")));
}

std::string legs_text(const Plan& plan, const std::vector<PlannedLegLine>& legs, bool is_verbose) {
  std::string text;
  if (is_verbose || legs.size() <= legs_listed_max) {
    for (const PlannedLegLine& leg : legs) text += leg_text(leg);
    return text;
  }
  for (const PlanRover& rover : plan.rovers) text += rover_text(rover.id, legs);
  return text + fmt::format("  {} in all: --verbose lists them\n", counted(legs.size(), "leg"));
}

std::string line_text(const DrawnEventLine& line) {
  std::vector<std::string> parts;
  if (line.drawn.to_first_m) {
    parts.push_back(fmt::format("{:.1f} m to its first waypoint", *line.drawn.to_first_m));
  }
  if (line.drawn.along_m > 0) parts.push_back(fmt::format("{:.1f} m along it", line.drawn.along_m));
  if (parts.empty()) return "";
  return fmt::format("  drawn: {} '{}': {}\n", line.rover_id, line.label,
                     fmt::join(parts, ", then "));
}

std::string timed_text(const Plan& plan) {
  std::string text;
  for (const PlanEvent& event : plan.events) {
    if (!event.at || !event.is_enabled) continue;
    text +=
        fmt::format("  at a time: {} '{}' at {}, {:g} s after the start, whatever it does then\n",
                    event.rover_id, event.label, format_utc(plan.mission.start_time + *event.at),
                    seconds(*event.at));
  }
  return text;
}

// Splits "Route 'leg 2': Speed = 1 m/s" into "Route" and "Speed = 1 m/s". Defaults of fields that
// all events have belong to "events".
std::pair<std::string, std::string> kind_and_default(const std::string& line) {
  const std::size_t value = line.rfind(": ", line.find(" = "));
  if (value == std::string::npos) return {"events", line.substr(0, line.find(" ("))};
  return {line.substr(0, std::min(value, line.find(" '"))), line.substr(value + 2)};
}

std::string defaults_text(const std::vector<std::string>& defaults) {
  // Kinds and values in order of first occurrence, each value with its number of occurrences.
  std::vector<std::pair<std::string, std::vector<std::pair<std::string, int>>>> kinds;
  const auto find = [](auto& list, const std::string& name) {
    const auto found = std::ranges::find(list, name, [](const auto& entry) { return entry.first; });
    if (found != list.end()) return found;
    list.push_back({name, {}});
    return std::prev(list.end());
  };
  for (const std::string& line : defaults) {
    const auto [kind, value] = kind_and_default(line);
    ++find(find(kinds, kind)->second, value)->second;
  }
  std::string text;
  for (const auto& [kind, values] : kinds) {
    std::vector<std::string> words;
    for (const auto& [value, count] : values) {
      words.push_back(count == 1 ? value : fmt::format("{} ({} times)", value, count));
    }
    text += fmt::format("  defaults of {}: {}\n", kind, fmt::join(words, "; "));
  }
  return text;
}

// Groups assumptions by owner: "SEV: a battery of ..." belongs to SEV.
std::string assumptions_text(const std::vector<std::string>& assumptions) {
  std::vector<std::string> owners;
  for (const std::string& line : assumptions) {
    const std::string owner = line.substr(0, line.find(": "));
    if (std::ranges::find(owners, owner) == owners.end()) owners.push_back(owner);
  }
  if (owners.empty()) return "";
  return fmt::format("  {} of {}: --verbose lists them, and each default\n",
                     counted(assumptions.size(), "assumption"), fmt::join(owners, ", "));
}

}  // namespace

std::string check_text(const MissionModel& files, const RoutesAhead& routes, bool is_verbose) {
  const std::vector<Fault> faults = files.faults.sorted();
  std::string text = files.faults.has_errors() ? "" : verdict(files, faults.size());
  for (const Fault& fault : faults) text += to_string(fault) + "\n";
  if (files.faults.has_errors()) {
    if (files.plan.events.empty()) return text;
    return text + "the plan has errors: it is not estimated what its events take\n";
  }
  text += legs_text(files.plan, routes.planned, is_verbose);
  for (const DrawnEventLine& line : routes.drawn) text += line_text(line);
  text += timed_text(files.plan);
  if (!is_verbose) {
    return text + defaults_text(files.plan.defaults) + assumptions_text(files.assumptions);
  }
  for (const std::string& line : files.plan.defaults) text += fmt::format("  default: {}\n", line);
  for (const std::string& line : files.assumptions) text += fmt::format("  assumption: {}\n", line);
  return text;
}

}  // namespace lsos
