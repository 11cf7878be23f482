#include "mission/events/event_sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/units.h"
#include "mission/model/site.h"
#include "mission/port/note_json.h"

namespace lsos {

namespace {

constexpr int phase_changes_max = 100;  // at one exchange; more means an endless loop
constexpr SimTime condition_period{1'000'000};
// A stationary event whose Point is farther from the rover than this gets a warning.
constexpr double far_from_point_m = 50;

bool has_ended(const EventRecord& record) {
  switch (record.status) {
    case EventStatus::completed:
    case EventStatus::failed:
    case EventStatus::skipped:
    case EventStatus::disabled:
      return true;
    default:
      return false;
  }
}

}  // namespace

void EventRecord::archive(Archive& a) {
  a(status)(reason)(
      ready)(start)(end)(distance_start_m)(distance_m)(used_start_j)(energy_used_j)(solar_start_j)(solar_j)(place
                                                                                                                .lon_rad)(
      place.lat_rad)(place.height_m)(is_prevented)(is_written);
}

EventSequence::EventSequence(const RoverMachine& machine, const MissionInfo& mission,
                             const Ground& ground)
    : machine_(machine), mission_(mission), ground_(&ground), records_(machine.events.size()) {
  for (std::size_t i = 0; i < records_.size(); ++i) {
    if (machine_.events[i].event.is_enabled) continue;
    records_[i].status = EventStatus::disabled;
    records_[i].end = SimTime{};
  }
}

void EventSequence::run(SimTime now, RoverAgent& agent, ScriptHost& host,
                        const EventLookup& others) {
  int changes = 0;
  while (!is_finished_) {
    if (!has_turn_ && !give_turn(now, agent)) return;
    if (!running_) {
      std::string impossible;
      if (is_met("SkipWhen", event().skip_when, now == *current().ready, now, agent, host,
                 impossible)) {
        note("skip_when", event().skip_when, agent);
        end(EventStatus::skipped, "SkipWhen: " + event().skip_when.text, now, agent);
        continue;
      }
      if (impossible.empty() && may_start(now, agent, host, others, impossible)) {
        start(now, agent, host);
        changes = 0;
      } else if (impossible.empty()) {
        return;
      } else {
        end(EventStatus::failed, impossible, now, agent);
        continue;
      }
    }
    std::string hindered = hindrance(agent);
    if (hindered.empty() && is_met("StopWhen", event().stop_when, now == *current().start, now,
                                   agent, host, hindered)) {
      note("stop_when", event().stop_when, agent);
      hindered = "StopWhen: " + event().stop_when.text;
    }
    if (++changes > phase_changes_max) {
      const Fault fault{Severity::error, running_->phase_place(host),
                        fmt::format("its phases go round without time passing, now in '{}' of {}",
                                    running_->phase(), event().type)};
      hindered = to_string(fault);
    }
    const bool is_due = running_->is_due(now, agent);
    // An event that ends exactly at its timeout has not exceeded it.
    if (hindered.empty() && !is_due && is_timed_out(now)) {
      hindered = fmt::format("timed out after {} s", seconds(*event().timeout));
    }
    if (!hindered.empty()) {
      const std::string state = abort(now, agent, host);
      if (!state.empty()) hindered += "; " + state;
      end(EventStatus::failed, hindered, now, agent);
      if (agent.is_broken()) finish(now, hindered, true);
      continue;
    }
    if (!is_due) return;
    const RunningEvent::Progress progress = running_->call(now, mission_, agent, host);
    if (const std::string advice = running_->take_advice(); !advice.empty()) {
      warnings_.push_back(advice);
    }
    switch (progress) {
      case RunningEvent::Progress::waits:
        if (is_timed_out(now)) break;
        return;
      case RunningEvent::Progress::goes_on:
        break;
      case RunningEvent::Progress::completed:
        warn_of_unfinished_drive(agent);
        end(EventStatus::completed, "", now, agent);
        break;
      case RunningEvent::Progress::failed:
        end(EventStatus::failed, running_->reason(), now, agent);
        break;
    }
  }
}

std::string EventSequence::hindrance(const RoverAgent& agent) const {
  if (is_powerless(agent)) return "the battery is empty";
  const bool drives = agent.drive().status != DriveState::Status::none;
  return !agent.fault().empty() && (drives || agent.is_broken()) ? agent.fault() : "";
}

bool EventSequence::is_timed_out(SimTime now) const {
  return event().timeout && now - *records_[index_].start >= *event().timeout;
}

// Gives the next enabled event its turn; false when there is none.
bool EventSequence::give_turn(SimTime now, const RoverAgent& agent) {
  // Events that will not start any more have an end.
  while (index_ < records_.size() &&
         (current().status != EventStatus::not_started || current().end)) {
    ++index_;
  }
  if (index_ >= records_.size()) {
    is_finished_ = true;
    return false;
  }
  has_turn_ = true;
  waits_for_condition_ = waits_for_charge_ = false;
  current().status = EventStatus::waiting;
  current().ready = now;
  current().place = agent.place_now();
  changed(index_);
  return true;
}

// Events such as waiting and recharging go on with an empty battery.
bool EventSequence::is_powerless(const RoverAgent& agent) const {
  return agent.power().waits_for_reserve() &&
         !machine_.events[index_].declaration.goes_on_without_power;
}

bool EventSequence::may_start(SimTime now, RoverAgent& agent, ScriptHost& host,
                              const EventLookup& others, std::string& impossible) {
  // An end counts from the next exchange on, so that the order of rovers within one exchange does
  // not matter.
  waits_for_others_ = false;
  bool is_late = false;
  for (const PlanEvent::Reference& awaited : event().start_after) {
    const EventRecord& record = others.record(awaited);
    if (!record.end) {
      waits_for_others_ = true;
    } else if (*record.end >= now) {
      is_late = true;
    } else if (!has_ended(record)) {
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
  const bool did_wait_for_charge = std::exchange(waits_for_charge_, is_powerless(agent));
  if (waits_for_charge_ && !did_wait_for_charge) {
    agent.set_noting_sequence(event().sequence);
    agent.note("waits_for_charge", "{}");
  }
  if (waits_for_charge_) return false;
  if (event().start_time && *event().start_time - mission_.start_time > now) return false;
  if (event().start_when.text.empty()) return true;
  const bool did_wait = waits_for_condition_;
  waits_for_condition_ =
      !is_met("StartWhen", event().start_when, !did_wait, now, agent, host, impossible);
  if (!waits_for_condition_) {
    note("start_when", event().start_when, agent);
  } else if (!did_wait) {
    note("waits_for", event().start_when, agent);
  }
  return !waits_for_condition_;
}

bool EventSequence::is_met(const char* name, const PlanEvent::Condition& condition, bool is_first,
                           SimTime now, const RoverAgent& agent, ScriptHost& host,
                           std::string& fault) {
  if (condition.text.empty() || (!is_first && now % condition_period != SimTime{})) return false;
  try {
    return host.holds(condition.text, agent.condition_sample(now, event_label(), phase()), agent);
  } catch (const ScriptError& error) {
    fault = to_string({Severity::error,
                       {event().place.file, condition.line},
                       fmt::format("{} '{}' at {} s: {} = {}: {}", event().type, event().label,
                                   seconds(now), name, condition.text, error.what())});
    return false;
  }
}

void EventSequence::note(const char* decision, const PlanEvent::Condition& condition,
                         RoverAgent& agent) const {
  agent.set_noting_sequence(event().sequence);
  agent.note(decision, fmt::format(R"({{"condition":{}}})", note_json(condition.text)));
}

void EventSequence::add(const EventMachine& machine) {
  const std::int64_t sequence = machine.event.sequence;
  const auto at = std::ranges::find_if(
      machine_.events, [&](const EventMachine& other) { return other.event.sequence >= sequence; });
  const auto index = static_cast<std::size_t>(at - machine_.events.begin());
  const bool is_taken = at != machine_.events.end() && at->event.sequence == sequence;
  const bool is_past = index < index_ || (index == index_ && has_turn_);
  if (is_taken || is_past) {
    throw InputError(machine.event.place,
                     fmt::format("Sequence = {}: {}", sequence,
                                 is_taken ? "the rover has an event with it"
                                          : "what comes later has begun already"));
  }
  machine_.events.insert(at, machine);
  records_.insert(records_.begin() + static_cast<std::ptrdiff_t>(index), EventRecord{});
  is_finished_ = false;
}

void EventSequence::start(SimTime now, const RoverAgent& agent, ScriptHost& host) {
  current().status = EventStatus::running;
  current().start = now;
  current().distance_start_m = agent.view().distance_m;
  current().used_start_j = agent.energy_used_j();
  current().solar_start_j = agent.solar_j();
  current().place = agent.place_now();
  changed(index_);
  warn_of_late_start(now);
  const EventMachine& machine = machine_.events[index_];
  EventArguments arguments{event().params, on_ground_S_m(event().geometry.points, *ground_)};
  for (const std::vector<Geodetic>& hole : event().geometry.holes) {
    arguments.holes_S_m.push_back(on_ground_S_m(hole, *ground_));
  }
  if (!machine.declaration.drives && event().geometry.kind == GeometryKind::point) {
    const double away_m =
        surface_distance_m(*mission_.planet, agent.place_now(), event().geometry.points.front());
    if (away_m > far_from_point_m) {
      warnings_.push_back(fmt::format("{} of {}: the rover is {:.0f} m from the event's Point",
                                      event().label, event().rover_id, away_m));
    }
  }
  running_.emplace(event(), arguments, now, host);
}

std::string EventSequence::abort(SimTime now, RoverAgent& agent, ScriptHost& host) {
  RunningEvent::Ending ending = running_->abort(now, mission_, agent, host);
  for (std::string& fault : ending.faults) warnings_.push_back(std::move(fault));
  return ending.state;
}

void EventSequence::end(EventStatus status, const std::string& reason, SimTime now,
                        RoverAgent& agent) {
  agent.release();  // stops whatever its script left under way
  EventRecord& record = current();
  if (running_) {
    for (PhaseRow& phase : running_->take_phases()) phases_.push_back(std::move(phase));
  }
  record.status = status;
  // The reason is the first line; a script's traceback goes to the warnings.
  record.reason = reason.substr(0, reason.find('\n'));
  if (record.reason != reason) warnings_.push_back(reason);
  record.end = now;
  record.place = agent.place_now();
  if (record.start) {
    record.distance_m = agent.view().distance_m - record.distance_start_m;
    record.energy_used_j = agent.energy_used_j() - record.used_start_j;
    record.solar_j = agent.solar_j() - record.solar_start_j;
  }
  changed(index_);
  has_turn_ = false;
  running_.reset();
  if (status == EventStatus::failed) after_failure(now);
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

// Starts no more events. Those that have not started get an end, which events waiting for them read
// as never to run.
void EventSequence::finish(SimTime now, const std::string& reason, bool is_failure) {
  is_finished_ = true;
  for (std::size_t i = 0; i < records_.size(); ++i) {
    if (records_[i].status != EventStatus::not_started || records_[i].end) continue;
    records_[i].end = now;
    records_[i].reason = reason;
    records_[i].is_prevented = is_failure;
  }
}

void EventSequence::skip_to(std::size_t index, SimTime now) {
  for (std::size_t i = index_ + 1; i < index; ++i) {
    EventRecord& record = records_[i];
    if (record.status != EventStatus::not_started) continue;
    record.status = EventStatus::skipped;
    record.reason = fmt::format("'{}' failed and goes to '{}'", event().label,
                                machine_.events[index].event.label);
    record.end = now;
  }
  index_ = index;
}

std::optional<SimTime> EventSequence::wake(SimTime now) const {
  if (is_finished_) return std::nullopt;
  const SimTime next = now + exchange_period;
  const SimTime next_evaluation = (now / condition_period + 1) * condition_period;
  if (running_) {
    std::optional<SimTime> wake = running_->wake(now);
    if (!event().stop_when.text.empty())
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
      wake = std::max(next, round_up_to_exchange(*event().start_time - mission_.start_time));
    }
  }
  if (!event().skip_when.text.empty())
    wake = std::min(wake.value_or(next_evaluation), next_evaluation);
  return wake;
}

SimTime EventSequence::last_end() const {
  SimTime last{};
  for (const EventRecord& record : records_) last = std::max(last, record.end.value_or(SimTime{}));
  return last;
}

void EventSequence::archive(Archive& a, ScriptHost& host) {
  a.tag("events")(records_)(
      index_)(has_turn_)(waits_for_others_)(waits_for_charge_)(waits_for_condition_)(is_finished_)(aborts_mission_);
  bool is_running = running_.has_value();
  a(is_running);
  if (a.is_reading() && is_running) running_.emplace(event());
  if (is_running) running_->archive(a, host);
}

}  // namespace lsos
