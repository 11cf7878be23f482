#include "plan/timed_events.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "plan/suggestions.h"

namespace lsos {

namespace {

// What suppose a turn, of the fields that it has: "StartTime, StartWhen".
std::vector<std::string> fields_of_turns(const PlanEvent& event) {
  std::vector<std::string> fields;
  if (event.start_time) fields.emplace_back("StartTime");
  if (!event.start_after.empty()) fields.emplace_back("StartAfter");
  if (!event.start_when.text.empty()) fields.emplace_back("StartWhen");
  if (!event.stop_when.text.empty()) fields.emplace_back("StopWhen");
  if (!event.warn_when.text.empty()) fields.emplace_back("WarnWhen");
  if (event.timeout) fields.emplace_back("Timeout");
  return fields;
}

}  // namespace

void set_times(std::vector<DraftEvent>& drafts, const Declarations& declarations,
               const MissionInfo& mission, const PlanGaps& gaps) {
  for (DraftEvent& draft : drafts) {
    if (!draft.is_read) continue;
    const std::string& key = declarations.events.at(draft.event.type).at;
    const auto value = draft.event.params.find(key);
    if (key.empty() || value == draft.event.params.end()) continue;
    if (const auto* time = std::get_if<Instant>(&value->second)) {
      draft.event.at = gaps.start_time ? SimTime{} : *time - mission.start_time;
    } else {
      draft.event.at = from_seconds(std::get<double>(value->second));
    }
  }
}

void check_timed_events(const std::vector<DraftEvent>& drafts, const Declarations& declarations,
                        Faults& faults) {
  std::map<PlanEvent::Reference, const PlanEvent*> timed;
  for (const DraftEvent& draft : drafts) {
    const PlanEvent& event = draft.event;
    if (event.at && draft.is_placed) timed[{event.rover_id, event.sequence}] = &event;
  }
  for (const DraftEvent& draft : drafts) {
    const PlanEvent& event = draft.event;
    const auto report = [&](const std::string& what) {
      faults.error(event.place, fmt::format("{}: {}", draft.subject, what));
    };
    const bool goes = event.on_failure == OnFailure::go_to;
    if (event.at) {
      const auto& fields = declarations.events.at(event.type).fields;
      const auto at =
          std::ranges::find(fields, declarations.events.at(event.type).at, &FieldDeclaration::key);
      const std::vector<std::string> turns = fields_of_turns(event);
      if (!turns.empty()) {
        report(fmt::format("{} cannot be given with {}, at which it takes effect without a turn",
                           fmt::join(turns, ", "), at->name));
      }
      if (goes) {
        report(fmt::format("OnFailure: goto cannot be given with {}: it has no turn to go on from",
                           at->name));
      }
    } else if (const auto to = timed.find({event.rover_id, event.go_to_sequence});
               goes && to != timed.end()) {
      report(fmt::format("OnFailure: goto {}: it takes effect at a time of its own, without a turn",
                         quoted(to->second->label)));
    }
  }
}

}  // namespace lsos
