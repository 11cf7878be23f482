#include "mission/events/running_event.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace lsos {

namespace {

constexpr SimTime long_stay{3'600'000'000};
constexpr std::size_t frames_max = 8;  // greatest depth of events within events

bool has_phase(const ScriptHost& host, const std::string& type, const std::string& phase) {
  const auto& events = host.declarations().events;
  const auto found = events.find(type);
  return found != events.end() &&
         std::ranges::find(found->second.phases, phase, &EventDeclaration::Phase::name) !=
             found->second.phases.end();
}

}  // namespace

RunningEvent::RunningEvent(const PlanEvent& event)
    : rover_id_(event.rover_id),
      label_(event.label),
      sequence_(event.sequence),
      place_(event.place) {}

RunningEvent::RunningEvent(const PlanEvent& event, const EventArguments& arguments,
                           const Turn& turn, bool is_beside)
    : RunningEvent(event) {
  is_beside_ = is_beside;
  push(event.type, arguments, "", turn);
  if (is_beside) frames_.back().outer = turn.agent.power().claims();
}

bool RunningEvent::is_due(const Turn& turn) const {
  switch (wake_) {
    case Wake::next_exchange:
      return true;
    case Wake::at_time:
      return turn.now >= wake_at_ || turn.agent.power().has_reached_charge();
    case Wake::arrival:
      return turn.agent.drive_state().status != DriveState::Status::driving ||
             (latest_ && turn.now >= *latest_);
  }
  return true;
}

RunningEvent::Progress RunningEvent::call(const Turn& turn) {
  PhaseContext called = context(turn);
  turn.agent.journal().set_sequence(sequence_);
  PhaseAnswer answer;
  try {
    answer = turn.host.run_phase(frames_.back().instance, frames_.back().phase, called);
  } catch (const ScriptError& error) {
    return fail(error.what(), turn);
  }
  if (const auto* failure = std::get_if<Fail>(&answer)) {
    return fail(failure->reason, turn);
  }
  if (std::holds_alternative<RunEvent>(answer) && frames_.size() >= frames_max) {
    return fail(fmt::format("events within events more than {} deep", frames_max), turn);
  }
  if (std::holds_alternative<Arrival>(answer) &&
      turn.agent.drive_state().status == DriveState::Status::none) {
    return fail("it answers lsos.arrival, and nothing drives: rover:follow was not called", turn);
  }
  const bool waits = std::holds_alternative<Stay>(answer) ||
                     std::holds_alternative<SleepUntil>(answer) ||
                     std::holds_alternative<Arrival>(answer);
  return waits ? wait(answer, turn) : go_on(answer, turn);
}

RunningEvent::Progress RunningEvent::wait(const PhaseAnswer& answer, const Turn& turn) {
  wake_ = Wake::at_time;
  wake_at_ = turn.now + exchange_period;
  // The advice is given once, at the exchange at which the hour is over.
  const SimTime stayed = turn.now - frames_.back().phase_start;
  if (std::holds_alternative<Stay>(answer) && stayed >= long_stay &&
      stayed - exchange_period < long_stay &&
      turn.agent.drive_state().status != DriveState::Status::driving) {
    advice_ = fmt::format(
        "{}:{}: {} '{}': phase '{}' of {} has answered nothing for an hour and is called every "
        "0.1 s, while nothing drives; does a 'return lsos.done' lack, or an lsos.sleep?",
        place_.file, place_.line, rover_id_, label_, frames_.back().phase, frames_.back().type);
  }
  if (const auto* sleep = std::get_if<SleepUntil>(&answer)) {
    wake_at_ = std::max(wake_at_, round_up_to_exchange(sleep->time));
  }
  // When nothing drives, the phase is called again at the next exchange rather than never.
  const auto* arrival = std::get_if<Arrival>(&answer);
  if (arrival != nullptr && turn.agent.drive_state().status == DriveState::Status::driving) {
    wake_ = Wake::arrival;
    latest_.reset();
    if (arrival->latest) latest_ = std::max(wake_at_, round_up_to_exchange(*arrival->latest));
  }
  return Progress::waits;
}

RunningEvent::Progress RunningEvent::go_on(const PhaseAnswer& answer, const Turn& turn) {
  wake_ = Wake::next_exchange;
  if (const auto* go = std::get_if<GoTo>(&answer)) {
    enter_phase(go->phase, turn.now);
    return Progress::goes_on;
  }
  if (const auto* inner = std::get_if<RunEvent>(&answer)) {
    push(inner->type, inner->arguments, inner->next, turn);
    frames_.back().outer = turn.agent.power().claims();
    return Progress::goes_on;
  }
  // Done ends this event and every outer event whose last phase it was.
  std::string next;
  while (!frames_.empty() && next.empty()) {
    next = frames_.back().next;
    pop(turn);
  }
  if (frames_.empty()) return Progress::completed;
  enter_phase(next, turn.now);
  return Progress::goes_on;
}

RunningEvent::Progress RunningEvent::fail(const std::string& reason, const Turn& turn) {
  reason_ = reason;
  for (const std::string& fault : abort(turn).faults) reason_ += "; " + fault;
  return Progress::failed;
}

RunningEvent::Ending RunningEvent::abort(const Turn& turn) {
  Ending ending;
  turn.agent.journal().set_sequence(sequence_);
  while (!frames_.empty()) {
    PhaseContext called = context(turn);
    try {
      const std::string state = turn.host.run_abort(frames_.back().instance, called);
      if (!state.empty()) ending.state += (ending.state.empty() ? "" : "; ") + state;
    } catch (const ScriptError& error) {
      ending.faults.push_back(error.what());
    }
    pop(turn);
  }
  if (!is_beside_) turn.agent.brake();
  return ending;
}

std::optional<SimTime> RunningEvent::wake(SimTime now) const {
  switch (wake_) {
    case Wake::next_exchange:
      return now + exchange_period;
    case Wake::at_time:
      return wake_at_;
    case Wake::arrival:
      return latest_;
  }
  return std::nullopt;
}

PhaseContext RunningEvent::context(const Turn& turn) const {
  return {.rover = turn.agent,
          .now = turn.now,
          .phase_start = frames_.back().phase_start,
          .event_start = frames_.back().start,
          .mission_start = turn.mission.start_time,
          .seed = turn.mission.seed,
          .rover_id = rover_id_,
          .sequence = sequence_,
          .label = label_,
          .script_number = frames_.back().number,
          .place = place_};
}

std::string RunningEvent::endless_text(const ScriptHost& host) const {
  const EventDeclaration& event = host.declarations().events.at(frames_.back().type);
  const auto phase =
      std::ranges::find(event.phases, frames_.back().phase, &EventDeclaration::Phase::name);
  return to_string(Fault{Severity::error,
                         {event.place.file, phase == event.phases.end() ? 0 : phase->line},
                         fmt::format("its phases go round without time passing, now in '{}' of {}",
                                     frames_.front().phase, frames_.front().type)});
}

void RunningEvent::push(const std::string& type, const EventArguments& arguments,
                        const std::string& next, const Turn& turn) {
  Frame frame;
  frame.type = type;
  frame.arguments = arguments;
  frame.phase = turn.host.declarations().events.at(type).start_phase;
  frame.next = next;
  frame.start = frame.phase_start = turn.now;
  frame.number = begun_++;
  frame.instance = turn.host.begin(type, arguments);
  frames_.push_back(std::move(frame));
}

void RunningEvent::pop(const Turn& turn) {
  end_phase(turn.now);
  turn.host.end(frames_.back().instance);
  turn.agent.power().set_claims(frames_.back().outer);
  frames_.pop_back();
}

void RunningEvent::enter_phase(const std::string& phase, SimTime now) {
  end_phase(now);
  frames_.back().phase = phase;
  frames_.back().phase_start = now;
}

void RunningEvent::end_phase(SimTime now) {
  if (frames_.size() > 1) return;
  phases_.push_back(
      {rover_id_, sequence_, frames_.front().phase, frames_.front().phase_start, now});
}

std::vector<PhaseRow> RunningEvent::take_phases() { return std::exchange(phases_, {}); }

void RunningEvent::archive(Archive& a, ScriptHost& host) {
  a.tag("running");
  std::uint64_t depth = frames_.size();
  LSOS_ARCHIVE(a, begun_, wake_, wake_at_, latest_, depth);
  if (a.is_reading()) {
    if (depth == 0 || depth > frames_max) a.refuse("saved state holds events nested so deep");
    frames_.resize(depth);
  }
  for (Frame& frame : frames_) {
    std::string state = a.is_reading() ? "" : host.save(frame.instance);
    LSOS_ARCHIVE(a, frame.type, frame.phase, frame.next, frame.start, frame.phase_start,
                 frame.number, frame.outer, frame.arguments, state);
    if (a.is_reading()) {
      const Frame* below = &frame == &frames_.front() ? nullptr : &frame - 1;
      const bool goes_on =
          below == nullptr || frame.next.empty() || has_phase(host, below->type, frame.next);
      if (!goes_on || !has_phase(host, frame.type, frame.phase)) {
        a.refuse("saved state holds a phase that its event has not");
      }
      frame.instance = host.begin(frame.type, frame.arguments);
      host.restore(frame.instance, state);
    }
  }
}

}  // namespace lsos
