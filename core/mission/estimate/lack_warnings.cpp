#include "mission/estimate/lack_warnings.h"

#include <fmt/format.h>

#include <algorithm>

#include "planet/utc.h"

namespace lsos {

namespace {

std::string utc_text(const Plan& plan, double time_s) {
  return format_utc(plan.mission.start_time + from_seconds(time_s));
}

std::string takes_text(double takes_s) {
  if (takes_s < 120) return fmt::format("{:.0f} s", takes_s);
  if (takes_s < 7200) return fmt::format("{:.0f} min", takes_s / 60);
  return fmt::format("{:.1f} h", takes_s / 3600);
}

const PlanEvent* event_at(const Plan& plan, const std::string& rover_id, std::int64_t sequence) {
  const auto event = std::ranges::find_if(plan.events, [&](const PlanEvent& other) {
    return other.rover_id == rover_id && other.sequence == sequence;
  });
  return event == plan.events.end() ? nullptr : &*event;
}

// " at 2026-..., with or after 'EVA 2'", where that is not the event of the beginning.
std::string below_text(const Lack& lack, const Plan& plan) {
  std::string text = " at " + utc_text(plan, *lack.below_s);
  if (lack.below_sequence == lack.sequence) return text;
  const PlanEvent* event = event_at(plan, lack.rover_id, lack.below_sequence);
  return event == nullptr ? text : text + fmt::format(", with or after '{}'", event->label);
}

std::string sunlight_text(const Lack& lack, const Plan& plan) {
  const std::string below = lack.below_s ? fmt::format(", below its reserve of {:.0f} %{}",
                                                       100 * lack.reserve, below_text(lack, plan))
                                         : "";
  return fmt::format(
      "no Sun reaches the panels of {} from {} to {}, and its charge falls from {:.0f} % to {:.0f} "
      "%{}; {}",
      lack.rover_id, utc_text(plan, lack.begin_s), utc_text(plan, lack.end_s),
      100 * lack.charge_begin, 100 * lack.charge_min, below,
      lack.is_stowed ? "all its panels are stowed: a DeploySP before, a Recharge or less load helps"
                     : "a place or time in the Sun, a Recharge or less load helps");
}

std::string energy_text(const Lack& lack, const Plan& plan) {
  const std::string when = !lack.is_idle       ? " in the course of it"
                           : lack.next.empty() ? ", after its last event"
                                               : fmt::format(", before '{}' begins", lack.next);
  return fmt::format("the battery of {} is empty at {}{}; a Recharge before or less load helps",
                     lack.rover_id, utc_text(plan, lack.begin_s), when);
}

std::string contact_text(const Lack& lack, const Plan& plan) {
  return fmt::format(
      "antenna '{}' of {} is up from {} to {} and sees neither Earth nor another end that it "
      "reaches; a higher place, another time or an asset that relays helps",
      lack.what, lack.rover_id, utc_text(plan, lack.begin_s), utc_text(plan, lack.end_s));
}

std::string condition_text(const Lack& lack, const Plan& plan) {
  const bool is_sight =
      lack.what.find("sees") != std::string::npos || lack.what.find("linked") != std::string::npos;
  return fmt::format(
      "WarnWhen holds from {} on for {}: {}{}", utc_text(plan, lack.begin_s),
      takes_text(lack.end_s - lack.begin_s), lack.what,
      is_sight ? "; another place or time, a DeployCA or an asset that relays helps" : "");
}

std::string text_of(const Lack& lack, const Plan& plan) {
  switch (lack.kind) {
    case LackKind::sunlight:
      return sunlight_text(lack, plan);
    case LackKind::contact:
      return contact_text(lack, plan);
    case LackKind::energy:
      return energy_text(lack, plan);
    case LackKind::condition:
      break;
  }
  return condition_text(lack, plan);
}

bool are_alike(const Lack& one, const Lack& other) {
  return one.rover_id == other.rover_id && one.kind == other.kind && one.what == other.what;
}

}  // namespace

std::vector<Fault> lack_warnings(const std::vector<Lack>& lacks, const Plan& plan) {
  std::vector<Fault> warnings;
  for (auto lack = lacks.begin(); lack != lacks.end(); ++lack) {
    const auto is_like = [&](const Lack& other) { return are_alike(*lack, other); };
    if (std::any_of(lacks.begin(), lack, is_like)) continue;
    const PlanEvent* event = event_at(plan, lack->rover_id, lack->sequence);
    if (event == nullptr) continue;
    std::string what =
        fmt::format("{} '{}': by the estimate {}", event->type, event->label, text_of(*lack, plan));
    const auto more = std::count_if(lack + 1, lacks.end(), is_like);
    if (more > 0) {
      double last_s = lack->end_s;
      for (const Lack& other : lacks) {
        if (is_like(other)) last_s = std::max(last_s, other.end_s);
      }
      what += fmt::format("; so it is {} until {}",
                          more == 1 ? "once more" : fmt::format("{} times more", more),
                          utc_text(plan, last_s));
    }
    warnings.push_back({Severity::warning, event->place, what});
  }
  return warnings;
}

std::vector<Fault> doubt_warnings(const std::vector<EventEstimate>& events,
                                  const std::vector<Lack>& lacks, const Plan& plan) {
  std::vector<Fault> warnings;
  for (const EventEstimate& event : events) {
    const std::optional<Expected>& seen = event.earth_visible_share;
    const PlanEvent* planned = event_at(plan, event.rover_id, event.sequence);
    if (planned == nullptr || !seen || seen->is_sure() || !event.start_s || !event.end_s) continue;
    const std::string& asked = planned->warn_when.text;
    if (asked.find("'Earth'") == std::string::npos && asked.find("\"Earth\"") == std::string::npos)
      continue;
    const bool is_told = std::ranges::any_of(lacks, [&](const Lack& lack) {
      return lack.kind == LackKind::condition && lack.rover_id == event.rover_id &&
             lack.begin_s <= *event.end_s && lack.end_s >= *event.start_s;
    });
    if (is_told) continue;
    warnings.push_back(
        {Severity::warning, planned->place,
         fmt::format("{} '{}': by the estimate WarnWhen may hold: {}; Earth is in view for {:.0f} "
                     "to {:.0f} % "
                     "of its time",
                     event.type, event.label, asked, 100 * seen->low, 100 * seen->high)});
  }
  return warnings;
}

}  // namespace lsos
