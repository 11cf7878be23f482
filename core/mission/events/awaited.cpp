#include "mission/events/awaited.h"

#include <fmt/format.h>

#include "mission/rover/rover_rows.h"

namespace lsos {

namespace {

// Why an awaited event is not over; "" when it is. An event of an earlier rover may have been
// stopped at this very exchange.
std::string pending_text(const EventRecord& record) {
  if (record.has_ended()) return "";
  switch (record.status) {
    case EventStatus::running:
    case EventStatus::incomplete:
      return "is still under way";
    default:
      return record.ready ? "waits itself" : "has not had its turn";
  }
}

}  // namespace

bool holds(const char* name, const PlanEvent::Condition& condition, const PlanEvent& event,
           const std::string& phase, const Turn& turn, std::string& fault) {
  const std::string running = phase.empty() ? "" : event.label;
  try {
    return turn.host.holds(condition.text, condition_row(turn.agent, turn.now, running, phase),
                           turn.agent);
  } catch (const ScriptError& error) {
    fault = to_string({Severity::error,
                       {event.place.file, condition.line},
                       fmt::format("{} '{}' at {} s: {} = {}: {}", event.type, event.label,
                                   seconds(turn.now), name, condition.text, error.what())});
    return false;
  }
}

std::string awaited_text(const PlanEvent& event, bool waits_for_charge, const Turn& turn) {
  for (const PlanEvent::Reference& awaited : event.start_after) {
    const std::string held_up = pending_text(turn.others.record(awaited));
    if (held_up.empty()) continue;
    return fmt::format("StartAfter: {}/{} {}", awaited.rover_id, awaited.sequence, held_up);
  }
  const SampleRow row = condition_row(turn.agent, turn.now, "", "");  // as the condition saw it
  if (waits_for_charge) {
    const RoverPower& power = turn.agent.power();
    if (power.waits_for_reserve()) {
      return fmt::format("charge above the reserve, as the battery was empty; charge was {:.4g}",
                         row.charge);
    }
    return fmt::format(
        "a charge of {:.4g} to drive with, as it was below the reserve; charge was "
        "{:.4g}",
        power.drives_again_at(), row.charge);
  }
  if (event.start_time && *event.start_time - turn.mission.start_time > turn.now) {
    return fmt::format("StartTime: {}", format_utc(*event.start_time));
  }
  if (event.start_when.text.empty()) return "";
  std::string text = fmt::format("StartWhen: {}, which did not hold", event.start_when.text);
  const std::string values = turn.host.values_in(event.start_when.text, row, turn.agent);
  return values.empty() ? text : text + "; " + values;
}

}  // namespace lsos
