// Events of a rover that take effect without a turn, among those that have one.
#include <fmt/format.h>

#include <algorithm>

#include "mission/events/awaited.h"
#include "mission/events/event_sequence.h"
#include "mission/events/timed_events.h"

namespace lsos {

void EventSequence::run_timed(const Turn& turn) {
  while (const auto index = next_timed_event(machine_.events, records_)) {
    const PlanEvent& event = machine_.events[*index].event;
    if (time_of_effect(event) > turn.now) return;
    EventRecord& record = records_[*index];
    record.ready = turn.now;
    std::string fault;
    TimedOutcome outcome;
    if (!event.skip_when.text.empty() &&
        holds("SkipWhen", event.skip_when, event, "", turn, fault)) {
      const std::int64_t of_the_turn = turn.agent.journal().sequence();
      note("skip_when", event.skip_when, event.sequence, turn.agent);
      turn.agent.journal().set_sequence(of_the_turn);
      outcome = {EventStatus::skipped, "SkipWhen: " + event.skip_when.text, {}, {}};
    } else if (!fault.empty()) {
      outcome = {EventStatus::failed, fault, {}, {}};
    } else {
      begin_record(record, turn);
      outcome = run_timed_event(event, arguments_of(event), turn);
    }
    end_record(record, outcome.status, outcome.reason, turn);
    records_.mark_changed(*index);
    for (PhaseRow& phase : outcome.phases) phases_.push_back(std::move(phase));
    for (std::string& warning : outcome.warnings) warnings_.push_back(std::move(warning));
    if (outcome.status != EventStatus::failed || event.on_failure == OnFailure::skip) continue;
    if (event.on_failure == OnFailure::abort) aborts_mission_ = event.label;
    if (!is_finished_) stop_turns(turn, fmt::format("'{}' failed", event.label), true);
  }
}

std::optional<SimTime> EventSequence::wake(SimTime now, Instant mission_start) const {
  std::optional<SimTime> wake = wake_of_turns(now, mission_start);
  if (!has_timed_) return wake;
  if (const auto timed = next_timed_event(machine_.events, records_)) {
    const SimTime then =
        std::max(now + exchange_period, time_of_effect(machine_.events[*timed].event));
    wake = std::min(wake.value_or(then), then);
  }
  return wake;
}

SimTime EventSequence::next_evaluation(SimTime now) const {
  constexpr int waited_parts = 100;
  const SimTime soon = (now / condition_period + 1) * condition_period;
  if (!waits_coarsely_ || !has_turn_) return soon;
  const EventRecord& record = records_[index_];
  const SimTime waited = now - record.start.value_or(*record.ready);
  return soon + waited / waited_parts / condition_period * condition_period;
}

void EventSequence::begin_record(EventRecord& record, const Turn& turn) const {
  const RoverAgent& agent = turn.agent;
  record.start = turn.now;
  record.distance_start_m = agent.view().distance_m;
  record.used_start_j = agent.power().energy_used_j();
  record.solar_start_j = agent.power().solar_j();
  record.charge_start = agent.power().view().charge;
  record.place = agent.motion().place();
}

void EventSequence::end_record(EventRecord& record, EventStatus status, const std::string& reason,
                               const Turn& turn) {
  const RoverAgent& agent = turn.agent;
  record.status = status;
  // The reason is the first line; a script's traceback goes to the warnings.
  record.reason = reason.substr(0, reason.find('\n'));
  if (record.reason != reason) warnings_.push_back(reason);
  record.end = turn.now;
  record.place = agent.motion().place();
  if (!record.start) return;
  record.distance_m = agent.view().distance_m - record.distance_start_m;
  record.energy_used_j = agent.power().energy_used_j() - record.used_start_j;
  record.solar_j = agent.power().solar_j() - record.solar_start_j;
  record.charge_end = agent.power().view().charge;
}

void EventSequence::close(SimTime now) {
  for (std::size_t i = 0; i < records_.size(); ++i) {
    if (!records_[i].is_timed || records_[i].status != EventStatus::not_started) continue;
    if (records_[i].end) continue;
    records_[i].is_prevented = has_failed_;
    records_[i].reason = fmt::format("the mission was over at {:.6g} s, before {:.6g} s",
                                     seconds(now), seconds(*machine_.events[i].event.at));
  }
}

}  // namespace lsos
