// Reasons of events that the mission's end cuts short: what each waited for.
#include <fmt/format.h>

#include "mission/events/event_sequence.h"

namespace lsos {

namespace {

// Why an awaited event is not over; "" when it is. An event of an earlier rover may have been
// stopped at this very exchange.
std::string pending_text(const EventRecord& record) {
  switch (record.status) {
    case EventStatus::completed:
    case EventStatus::failed:
    case EventStatus::skipped:
    case EventStatus::disabled:
      return "";
    case EventStatus::running:
    case EventStatus::incomplete:
      return "is still under way";
    default:
      return record.ready ? "waits itself" : "has not had its turn";
  }
}

}  // namespace

std::string EventSequence::waits_for(SimTime now, const RoverAgent& agent, ScriptHost& host,
                                     const EventLookup& others) const {
  const PlanEvent& event = this->event();
  for (const PlanEvent::Reference& awaited : event.start_after) {
    const std::string held_up = pending_text(others.record(awaited));
    if (held_up.empty()) continue;
    return fmt::format("StartAfter: {}/{} {}", awaited.rover_id, awaited.sequence, held_up);
  }
  const SampleRow row = agent.condition_sample(now, "", "");  // as the condition saw it
  if (waits_for_charge_) {
    return fmt::format("charge above the reserve, as the battery was empty; charge was {:.4g}",
                       row.charge);
  }
  if (event.start_time && *event.start_time - mission_.start_time > now) {
    return fmt::format("StartTime: {}", format_utc(*event.start_time));
  }
  if (event.start_when.text.empty()) return "";
  std::string text = fmt::format("StartWhen: {}, which did not hold", event.start_when.text);
  const std::string values = host.values_in(event.start_when.text, row, agent);
  return values.empty() ? text : text + "; " + values;
}

std::string EventSequence::progress_until(SimTime now, RoverAgent& agent, ScriptHost& host) {
  std::string text = fmt::format("in phase '{}' since {:.0f} s", running_->phase(),
                                 seconds(running_->phase_start()));
  const DriveState drive = agent.drive();
  std::string state = abort(now, agent, host);
  if (state.empty() && drive.status == DriveState::Status::driving) {
    state = fmt::format("{:.0f} m are left to drive", drive.remaining_m);
  }
  return state.empty() ? text : text + "; " + state;
}

void EventSequence::stop(SimTime now, RoverAgent& agent, ScriptHost& host,
                         const EventLookup& others, const std::string& why, bool is_failure) {
  std::string reason = why, of_the_rest = why;
  if (has_turn_ && !is_failure) {
    of_the_rest += fmt::format("; its turn did not come, '{}' {}", event().label,
                               running_ ? "was under way" : "waited to start");
  }
  if (running_ && is_failure) {
    abort(now, agent, host);
  } else if (running_) {
    reason += ", " + progress_until(now, agent, host);
  } else if (has_turn_ && !is_failure) {
    const std::string awaited = waits_for(now, agent, host, others);
    if (!awaited.empty()) reason += "; it waited for " + awaited;
  }
  if (has_turn_) {
    const bool has_started = current().start.has_value();
    current().is_prevented = is_failure && !has_started;
    end(has_started ? EventStatus::incomplete : EventStatus::not_started, reason, now, agent);
  }
  finish(now, of_the_rest, is_failure);
}

}  // namespace lsos
