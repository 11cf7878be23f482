#include "mission/events/event_sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "mission/events/awaited.h"
#include "mission/events/event_warnings.h"
#include "mission/events/timed_events.h"
#include "mission/model/site.h"
#include "mission/port/note_json.h"

namespace lsos {

namespace {

bool are_of(const std::vector<EventMachine>& events, const EventRecords& records) {
  if (records.size() != events.size()) return false;
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (records[i].is_timed != events[i].event.at.has_value()) return false;
  }
  return true;
}

}  // namespace

EventSequence::EventSequence(const RoverMachine& machine, const Ground& ground)
    : machine_(machine), ground_(&ground), records_(machine.events.size()) {
  for (std::size_t i = 0; i < records_.size(); ++i) {
    has_timed_ |= records_[i].is_timed = machine_.events[i].event.at.has_value();
    if (machine_.events[i].event.is_enabled) continue;
    records_[i].status = EventStatus::disabled;
    records_[i].end = SimTime{};
  }
}

void EventSequence::run(const Turn& turn) {
  if (has_timed_) run_timed(turn);
  int changes = 0;
  while (!is_finished_) {
    if (!has_turn_ && !give_turn(turn)) return;
    if (!running_) {
      if (!begin(turn)) return;
      changes = 0;
      continue;
    }
    if (!go_on(turn, changes)) return;
  }
}

bool EventSequence::begin(const Turn& turn) {
  std::string impossible;
  if (is_met("SkipWhen", event().skip_when, turn.now == *current().ready, turn, impossible)) {
    note("skip_when", event().skip_when, event().sequence, turn.agent);
    end(EventStatus::skipped, "SkipWhen: " + event().skip_when.text, turn);
    return true;
  }
  if (impossible.empty() && may_start(turn, impossible)) {
    start(turn);
    return true;
  }
  if (impossible.empty()) return false;
  end(EventStatus::failed, impossible, turn);
  return true;
}

bool EventSequence::go_on(const Turn& turn, int& changes) {
  const bool is_first = turn.now == *current().start;
  watch_.observe(event(), phase(), is_first, turn);
  std::string hindered = hindrance(turn.agent);
  if (hindered.empty() && is_met("StopWhen", event().stop_when, is_first, turn, hindered)) {
    note("stop_when", event().stop_when, event().sequence, turn.agent);
    hindered = "StopWhen: " + event().stop_when.text;
  }
  if (++changes > RunningEvent::phase_changes_max) hindered = running_->endless_text(turn.host);
  const bool is_due = running_->is_due(turn);
  // An event that ends exactly at its timeout has not exceeded it.
  if (hindered.empty() && !is_due && is_timed_out(turn.now)) {
    hindered = fmt::format("timed out after {} s", seconds(*event().timeout));
  }
  if (!hindered.empty()) {
    const std::string state = abort(turn);
    if (!state.empty()) hindered += "; " + state;
    end(EventStatus::failed, hindered, turn);
    if (turn.agent.motion().is_broken()) finish(turn.now, hindered, true);
    return true;
  }
  if (!is_due) return false;
  const RunningEvent::Progress progress = running_->call(turn);
  if (const std::string advice = running_->take_advice(); !advice.empty()) warn(advice);
  switch (progress) {
    case RunningEvent::Progress::waits:
      return is_timed_out(turn.now);
    case RunningEvent::Progress::goes_on:
      break;
    case RunningEvent::Progress::completed:
      warn(unfinished_drive_warning(event(), turn.agent));
      end(EventStatus::completed, "", turn);
      break;
    case RunningEvent::Progress::failed:
      end(EventStatus::failed, running_->reason(), turn);
      break;
  }
  return true;
}

std::string EventSequence::hindrance(const RoverAgent& agent) const {
  if (is_powerless(agent)) return "the battery is empty";
  const bool drives = agent.drive_state().status != DriveState::Status::none;
  if (agent.power().keeps_reserve()) {
    std::string reason = reserve_text(agent.power());
    // Whatever the script would do about a failed drive.
    if (agent.drive_state().reason == reason) return reason;
  }
  const RoverMotion& motion = agent.motion();
  return !motion.fault().empty() && (drives || motion.is_broken()) ? motion.fault() : "";
}

bool EventSequence::is_timed_out(SimTime now) const {
  return event().timeout && now - *records_[index_].start >= *event().timeout;
}

// Gives the next enabled event its turn; false when there is none.
bool EventSequence::give_turn(const Turn& turn) {
  // Events that will not start any more have an end.
  while (index_ < records_.size() &&
         (current().status != EventStatus::not_started || current().end || current().is_timed)) {
    ++index_;
  }
  if (index_ >= records_.size()) {
    is_finished_ = true;
    return false;
  }
  has_turn_ = true;
  waits_for_condition_ = waits_for_charge_ = false;
  current().status = EventStatus::waiting;
  current().ready = turn.now;
  current().place = turn.agent.motion().place();
  records_.mark_changed(index_);
  return true;
}

// Events such as waiting and recharging go on with an empty battery.
bool EventSequence::is_powerless(const RoverAgent& agent) const {
  return agent.power().waits_for_reserve() &&
         !machine_.events[index_].declaration.goes_on_without_power;
}

bool EventSequence::lacks_charge(const RoverAgent& agent) const {
  return is_powerless(agent) ||
         (agent.power().keeps_reserve() && machine_.events[index_].declaration.drives);
}

bool EventSequence::may_start(const Turn& turn, std::string& impossible) {
  // An end counts from the next exchange on, so that the order of rovers within one exchange does
  // not matter.
  waits_for_others_ = false;
  bool is_late = false;
  for (const PlanEvent::Reference& awaited : event().start_after) {
    const EventRecord& record = turn.others.record(awaited);
    if (!record.end) {
      waits_for_others_ = true;
    } else if (*record.end >= turn.now) {
      is_late = true;
    } else if (!record.has_ended()) {
      impossible = fmt::format("{}/{}, which it waits for, can no longer run", awaited.rover_id,
                               awaited.sequence);
      return false;
    }
  }
  if (waits_for_others_ || is_late) {
    // An awaited event that has ended now is examined at the next exchange, whatever else is
    // awaited.
    waits_for_others_ = !is_late;
    return false;
  }
  const bool did_wait_for_charge = std::exchange(waits_for_charge_, lacks_charge(turn.agent));
  if (waits_for_charge_ && !turn.agent.power().may_charge()) {
    waits_for_charge_ = false;
    impossible = fmt::format(
        "{}, and nothing charges it: {}",
        is_powerless(turn.agent) ? "the battery is empty" : reserve_text(turn.agent.power()),
        turn.agent.power().panels().specs().empty() ? "there are no solar panels"
                                                    : "the solar panels are stowed");
    return false;
  }
  if (waits_for_charge_ && !did_wait_for_charge) {
    turn.agent.journal().set_sequence(event().sequence);
    turn.agent.note("waits_for_charge", "{}");
  }
  if (waits_for_charge_) return false;
  if (event().start_time && *event().start_time - turn.mission.start_time > turn.now) return false;
  if (event().start_when.text.empty()) return true;
  const bool did_wait = waits_for_condition_;
  waits_for_condition_ = !is_met("StartWhen", event().start_when, !did_wait, turn, impossible);
  if (!waits_for_condition_) {
    note("start_when", event().start_when, event().sequence, turn.agent);
  } else if (!did_wait) {
    note("waits_for", event().start_when, event().sequence, turn.agent);
  }
  return !waits_for_condition_;
}

bool EventSequence::is_met(const char* name, const PlanEvent::Condition& condition, bool is_first,
                           const Turn& turn, std::string& fault) const {
  return !condition.text.empty() && is_condition_due(is_first, turn.now) &&
         holds(name, condition, event(), phase(), turn, fault);
}

void EventSequence::note(const char* decision, const PlanEvent::Condition& condition,
                         std::int64_t sequence, RoverAgent& agent) {
  agent.journal().set_sequence(sequence);
  agent.note(decision, fmt::format(R"({{"condition":{}}})", note_json(condition.text)));
}

void EventSequence::add(const EventMachine& machine) {
  const std::int64_t sequence = machine.event.sequence;
  const auto at = std::ranges::find_if(
      machine_.events, [&](const EventMachine& other) { return other.event.sequence >= sequence; });
  const auto index = static_cast<std::size_t>(at - machine_.events.begin());
  const bool is_taken = at != machine_.events.end() && at->event.sequence == sequence;
  const bool is_timed = machine.event.at.has_value();
  const bool is_before = index < index_ || (index == index_ && has_turn_);
  const bool is_past = is_before && !is_timed;
  if (is_taken || is_past) {
    throw InputError(machine.event.place,
                     fmt::format("Sequence = {}: {}", sequence,
                                 is_taken ? "the rover has an event with it"
                                          : "what comes later has begun already"));
  }
  machine_.events.insert(at, machine);
  records_.insert(index, is_timed);
  has_timed_ |= is_timed;
  if (is_before) ++index_;
  if (!is_timed) is_finished_ = false;
}

EventArguments EventSequence::arguments_of(const PlanEvent& event) const {
  EventArguments arguments{event.params, on_ground_S_m(event.geometry.points, *ground_)};
  for (const std::vector<Geodetic>& hole : event.geometry.holes) {
    arguments.holes_S_m.push_back(on_ground_S_m(hole, *ground_));
  }
  return arguments;
}

void EventSequence::start(const Turn& turn) {
  current().status = EventStatus::running;
  begin_record(current(), turn);
  records_.mark_changed(index_);
  warn(late_start_warning(event(), current(), turn));
  if (!machine_.events[index_].declaration.drives) warn(far_start_warning(event(), turn));
  running_.emplace(event(), arguments_of(event()), turn);
  watch_ = {};
}

std::string EventSequence::abort(const Turn& turn) {
  RunningEvent::Ending ending = running_->abort(turn);
  for (std::string& fault : ending.faults) warnings_.push_back(std::move(fault));
  return ending.state;
}

void EventSequence::end(EventStatus status, const std::string& reason, const Turn& turn) {
  turn.agent.release();  // stops whatever its script left under way
  if (running_) {
    for (PhaseRow& phase : running_->take_phases()) phases_.push_back(std::move(phase));
  }
  end_record(current(), status, reason, turn);
  records_.mark_changed(index_);
  has_turn_ = false;
  running_.reset();
  if (status == EventStatus::failed) after_failure(turn.now);
}

void EventSequence::after_failure(SimTime now) {
  switch (event().on_failure) {
    case OnFailure::skip:
      return;
    case OnFailure::go_to: {
      const auto target = std::ranges::find_if(machine_.events, [&](const EventMachine& machine) {
        return machine.event.sequence == event().go_to_sequence;
      });
      skip_to(static_cast<std::size_t>(target - machine_.events.begin()), now);
      return;
    }
    case OnFailure::abort:
      aborts_mission_ = event().label;
      finish(now, fmt::format("'{}' failed", event().label), true);
      return;
    case OnFailure::stop:
      finish(now, fmt::format("'{}' failed", event().label), true);
      return;
  }
}

// Starts no more events.
void EventSequence::finish(SimTime now, const std::string& reason, bool is_failure) {
  is_finished_ = true;
  has_failed_ |= is_failure;
  records_.prevent_rest(now, reason, is_failure, false);
}

void EventSequence::skip_to(std::size_t index, SimTime now) {
  for (std::size_t i = index_ + 1; i < index; ++i) {
    EventRecord& record = records_[i];
    if (record.status != EventStatus::not_started || record.is_timed) continue;
    record.status = EventStatus::skipped;
    record.reason = fmt::format("'{}' failed and goes to '{}'", event().label,
                                machine_.events[index].event.label);
    record.end = now;
  }
  index_ = index;
}

std::optional<SimTime> EventSequence::wake_of_turns(SimTime now, Instant mission_start) const {
  if (is_finished_) return std::nullopt;
  const SimTime next = now + exchange_period;
  const SimTime next_evaluation = this->next_evaluation(now);
  if (running_) {
    std::optional<SimTime> wake = running_->wake(now);
    if (!event().stop_when.text.empty() || !event().warn_when.text.empty())
      wake = std::min(wake.value_or(next_evaluation), next_evaluation);
    if (event().timeout) {
      const SimTime over = round_up_to_exchange(*records_[index_].start + *event().timeout);
      wake = std::min(wake.value_or(over), over);
    }
    return wake;
  }
  if (!has_turn_) return next;
  if (waits_for_condition_) return next_evaluation;
  // Events in StartAfter wake it when they end; its StartTime is known.
  std::optional<SimTime> wake;
  if (!waits_for_others_ && !waits_for_charge_) {
    wake = next;
    if (event().start_time) {
      wake = std::max(next, round_up_to_exchange(*event().start_time - mission_start));
    }
  }
  if (!event().skip_when.text.empty())
    wake = std::min(wake.value_or(next_evaluation), next_evaluation);
  return wake;
}

std::string EventSequence::event_label() const { return running_ ? event().label : ""; }
std::string EventSequence::phase() const { return running_ ? running_->phase() : ""; }

EventRow EventSequence::row(std::size_t index) const {
  return event_row(machine_.events[index].event, records_[index]);
}

std::vector<PhaseRow> EventSequence::take_phases() {
  if (running_) {
    for (PhaseRow& phase : running_->take_phases()) phases_.push_back(std::move(phase));
  }
  return std::exchange(phases_, {});
}

std::vector<std::string> EventSequence::take_warnings() { return std::exchange(warnings_, {}); }

void EventSequence::warn(std::optional<std::string> warning) {
  if (warning) warnings_.push_back(std::move(*warning));
}

void EventSequence::archive(Archive& a, ScriptHost& host) {
  bool is_running = running_.has_value();
  a.tag("events");
  LSOS_ARCHIVE(a, records_, index_, has_turn_, waits_for_others_, waits_for_charge_,
               waits_for_condition_, is_finished_, has_failed_, aborts_mission_, is_running);
  if (a.is_reading()) {
    const bool fits = index_ <= records_.size() && are_of(machine_.events, records_);
    const bool has_times = index_ < records_.size() && records_[index_].ready &&
                           (!is_running || records_[index_].start);
    if (!fits || ((has_turn_ || is_running) && !(has_turn_ && has_times))) {
      a.refuse("saved state is of other events");
    }
    if (is_running) running_.emplace(event());
  }
  if (!is_running) return;
  LSOS_ARCHIVE(a, watch_);
  const Archive::Part part(a, "running_");
  running_->archive(a, host);
}

}  // namespace lsos
