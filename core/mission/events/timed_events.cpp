#include "mission/events/timed_events.h"

#include <fmt/format.h>

#include <utility>

#include "mission/events/running_event.h"

namespace lsos {

namespace {

void go_through(RunningEvent& running, const Turn& turn, TimedOutcome& outcome) {
  outcome.status = EventStatus::failed;
  RunningEvent::Progress progress = RunningEvent::Progress::goes_on;
  for (int changes = 0; changes < RunningEvent::phase_changes_max; ++changes) {
    progress = running.call(turn);
    if (progress != RunningEvent::Progress::goes_on) break;
  }
  switch (progress) {
    case RunningEvent::Progress::completed:
      outcome = {};
      return;
    case RunningEvent::Progress::failed:
      outcome.reason = running.reason();
      return;
    case RunningEvent::Progress::goes_on:
      outcome.reason = running.endless_text(turn.host);
      break;
    case RunningEvent::Progress::waits:
      outcome.reason =
          fmt::format("it takes effect without a turn, and must end at once; phase '{}' does not",
                      running.phase());
      break;
  }
  outcome.warnings = running.abort(turn).faults;
}

}  // namespace

SimTime time_of_effect(const PlanEvent& event) {
  return std::max(SimTime{}, round_up_to_exchange(*event.at));
}

std::optional<std::size_t> next_timed_event(const std::vector<EventMachine>& events,
                                            const EventRecords& records) {
  std::optional<std::size_t> next;
  for (std::size_t i = 0; i < events.size(); ++i) {
    const bool is_left =
        events[i].event.at && records[i].status == EventStatus::not_started && !records[i].end;
    if (is_left && (!next || *events[i].event.at < *events[*next].event.at)) next = i;
  }
  return next;
}

TimedOutcome run_timed_event(const PlanEvent& event, const EventArguments& arguments,
                             const Turn& turn) {
  RoverJournal& journal = turn.agent.journal();
  const std::int64_t sequence_before = journal.sequence();
  TimedOutcome outcome;
  RunningEvent running(event, arguments, turn, true);
  go_through(running, turn, outcome);
  outcome.phases = running.take_phases();
  journal.set_sequence(sequence_before);
  return outcome;
}

}  // namespace lsos
