#include "mission/estimate/estimate_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "planet/utc.h"

namespace lsos {

namespace {

// A charge this low is none.
constexpr double empty = 1e-6;

bool is_known(const PlanEvent& event, const std::vector<Fault>& known) {
  const std::string name = fmt::format("'{}'", event.label);
  return std::ranges::any_of(known, [&](const Fault& fault) {
    const bool is_there =
        fault.place.line == event.place.line || fault.place.line == event.geometry.line;
    return fault.place.file == event.place.file && is_there &&
           fault.what.find(name) != std::string::npos;
  });
}

}  // namespace

std::vector<Fault> estimate_warnings(const std::vector<EventEstimate>& events, const Plan& plan,
                                     const std::vector<Fault>& known) {
  std::vector<Fault> warnings;
  std::string rover_id;
  bool was_empty = false;
  for (const EventEstimate& event : events) {
    if (event.rover_id != rover_id) was_empty = false;
    rover_id = event.rover_id;
    const auto planned = std::ranges::find_if(plan.events, [&](const PlanEvent& other) {
      return other.rover_id == event.rover_id && other.sequence == event.sequence;
    });
    const bool is_empty = event.charge_min && *event.charge_min <= empty;
    // A condition that the plan has for ending it says what is meant.
    const bool is_meant = event.reason.starts_with("StopWhen: ");
    const bool has_failed = event.status == EventStatus::failed && event.end_s && !is_meant;
    const bool never_starts = event.status == EventStatus::not_started && event.ready_s &&
                              event.reason.find("; it waited for ") != std::string::npos;
    const bool meets = !event.meets.empty() && !has_failed;
    const bool is_news = has_failed || never_starts || meets || (is_empty && !was_empty);
    was_empty = is_empty;
    if (!is_news || planned == plan.events.end() || is_known(*planned, known)) continue;
    std::string what = fmt::format("{} '{}': ", event.type, event.label);
    if (never_starts) {
      what += fmt::format("by the estimate its turn comes at {} and it never starts: {}",
                          format_utc(plan.mission.start_time + from_seconds(*event.ready_s)),
                          event.reason);
    } else if (meets) {
      what += fmt::format(
          "by the estimate {} stands where it ends at {}: a run ends it before they touch; give "
          "each a place of its own, some metres apart",
          event.meets, format_utc(plan.mission.start_time + from_seconds(*event.end_s)));
    } else if (has_failed) {
      what += fmt::format("by the estimate it fails at {}: {}",
                          format_utc(plan.mission.start_time + from_seconds(*event.end_s)),
                          event.reason);
      if (event.distance_m && *event.distance_m > 0) {
        what += fmt::format(", having driven {:.1f} km", *event.distance_m / 1000);
      }
    } else {
      what += fmt::format("by the estimate the battery of {} is empty in the course of it",
                          event.rover_id);
    }
    warnings.push_back({Severity::warning, planned->place, what});
  }
  return warnings;
}

}  // namespace lsos
