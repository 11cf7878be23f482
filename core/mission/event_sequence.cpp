#include "mission/event_sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/units.h"

namespace lsos {

namespace {

constexpr int phase_changes_max = 100;      // at one exchange; more is a loop
constexpr std::size_t frames_max = 8;       // events within events
constexpr double far_from_point_m = 50;     // a stationary event's Point farther than this is odd

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

Path3 geometry_S_m(const PlanGeometry& geometry, const Ground& ground) {
  Path3 path;
  for (const Geodetic& point : geometry.points) {
    const double elevation_m = ground.elevation_m(point).value_or(0);
    path.push_back(ground.site().p_S_m({point.lon_rad, point.lat_rad, elevation_m}));
  }
  return path;
}

void EventRecord::archive(Archive& a) {
  a(status)(reason)(ready)(start)(end)(distance_start_m)(distance_m)(place.lon_rad)(
      place.lat_rad)(place.height_m)(is_written);
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

void EventSequence::run(SimTime now, RoverAgent& agent, ScriptHost& host, const Others& others) {
  int changes = 0;
  while (!is_finished_) {
    if (!has_turn_ && !take_turn(now, agent)) return;
    if (++changes > phase_changes_max) {
      abort_scripts(now, agent, host);
      end(EventStatus::failed, "its phases go round without time passing", now, agent);
      continue;
    }
    if (frames_.empty()) {
      std::string impossible;
      if (!may_start(now, others, impossible)) {
        if (impossible.empty()) return;
        end(EventStatus::failed, impossible, now, agent);
        continue;
      }
      start(now, agent, host);
      changes = 0;
    }
    if (!agent.fault().empty()) {
      const bool is_moving = agent.drive().status == DriveState::Status::failed;
      if (is_moving || agent.is_broken()) {
        abort_scripts(now, agent, host);
        end(EventStatus::failed, agent.fault(), now, agent);
        if (agent.is_broken()) finish(now);
        continue;
      }
    }
    if (event().timeout && now - *current().start >= *event().timeout) {
      abort_scripts(now, agent, host);
      end(EventStatus::failed,
          fmt::format("timed out after {} s", seconds(*event().timeout)), now, agent);
      continue;
    }
    if (!is_due(now, agent)) return;
    if (!call_phase(now, agent, host)) return;
  }
}

// Gives the next enabled event its turn; false when there is none.
bool EventSequence::take_turn(SimTime now, RoverAgent& agent) {
  while (index_ < records_.size() && current().status != EventStatus::not_started) ++index_;
  if (index_ >= records_.size()) {
    is_finished_ = true;
    return false;
  }
  has_turn_ = true;
  current().status = EventStatus::waiting;
  current().ready = now;
  current().place = agent.place_now();
  changed(index_);
  return true;
}

bool EventSequence::may_start(SimTime now, const Others& others, std::string& impossible) {
  waits_for_others_ = false;
  for (const PlanEvent::Reference& awaited : event().start_after) {
    const EventRecord& record = others.record(awaited);
    if (!has_ended(record)) {
      // `incomplete`, or not started though its rover has finished, will never end.
      if (record.status == EventStatus::incomplete || record.end) {
        impossible = fmt::format("{}/{}, which it waits for, can no longer run",
                                 awaited.rover_id, awaited.sequence);
      }
      waits_for_others_ = true;
      return false;
    }
    // The order of rovers within one exchange must not matter: it counts from the next one.
    if (*record.end >= now) return false;
  }
  return !event().start_time || *event().start_time - mission_.start_time <= now;
}

void EventSequence::start(SimTime now, RoverAgent& agent, ScriptHost& host) {
  current().status = EventStatus::running;
  current().start = now;
  current().distance_start_m = agent.view().distance_m;
  current().place = agent.place_now();
  changed(index_);
  const EventMachine& machine = machine_.events[index_];
  const Path3 path_S_m = geometry_S_m(event().geometry, *ground_);
  if (!machine.declaration.drives && event().geometry.kind == GeometryKind::point) {
    const double away_m = surface_distance_m(*mission_.planet, agent.place_now(),
                                             event().geometry.points.front());
    if (away_m > far_from_point_m) {
      warnings_.push_back(fmt::format("{} of {}: the rover is {:.0f} m from the event's Point",
                                      event().label, event().rover_id, away_m));
    }
  }
  push(event().type, {event().params, path_S_m}, "", now, host);
}

bool EventSequence::is_due(SimTime now, const RoverAgent& agent) const {
  switch (wake_) {
    case Wake::next_exchange:
      return true;
    case Wake::at_time:
      return now >= wake_at_;
    case Wake::arrival:
      return agent.drive().status != DriveState::Status::driving;
  }
  return true;
}

// Returns whether there may be more to do at this exchange.
bool EventSequence::call_phase(SimTime now, RoverAgent& agent, ScriptHost& host) {
  const Frame& frame = frames_.back();
  PhaseContext called = context(now, agent);
  agent.set_noting_sequence(event().sequence);
  PhaseAnswer answer;
  try {
    answer = host.run_phase(frame.instance, frame.phase, called);
  } catch (const ScriptError& error) {
    abort_scripts(now, agent, host);
    end(EventStatus::failed, error.what(), now, agent);
    return true;
  }
  if (std::holds_alternative<Stay>(answer)) {
    wake_ = Wake::at_time;
    wake_at_ = now + exchange_period;
    return false;
  }
  if (const auto* sleep = std::get_if<SleepUntil>(&answer)) {
    wake_ = Wake::at_time;
    wake_at_ = round_up_to_exchange(std::max(sleep->time, now + exchange_period));
    return false;
  }
  if (std::holds_alternative<Arrival>(answer)) {
    // Nothing under way: asked again at the next exchange rather than never.
    wake_ = agent.drive().status == DriveState::Status::driving ? Wake::arrival : Wake::at_time;
    wake_at_ = now + exchange_period;
    return false;
  }
  wake_ = Wake::next_exchange;
  if (const auto* go = std::get_if<GoTo>(&answer)) {
    enter_phase(go->phase, now);
  } else if (const auto* inner = std::get_if<RunEvent>(&answer)) {
    if (frames_.size() >= frames_max) {
      abort_scripts(now, agent, host);
      end(EventStatus::failed,
          fmt::format("events within events more than {} deep", frames_max), now, agent);
    } else {
      push(inner->type, inner->arguments, inner->next, now, host);
    }
  } else if (const auto* fail = std::get_if<Fail>(&answer)) {
    abort_scripts(now, agent, host);
    end(EventStatus::failed, fail->reason, now, agent);
  } else {
    // Done: so is every event whose last phase was this one.
    std::string next;
    while (!frames_.empty() && next.empty()) {
      next = frames_.back().next;
      pop(now, host);
    }
    if (frames_.empty()) {
      end(EventStatus::completed, "", now, agent);
    } else {
      enter_phase(next, now);
    }
  }
  return true;
}

void EventSequence::push(const std::string& type, const EventArguments& arguments,
                         const std::string& next, SimTime now, ScriptHost& host) {
  const EventDeclaration& declaration = host.declarations().events.at(type);
  Frame frame{type, arguments, declaration.start_phase, next, now};
  frame.instance = host.begin(type, arguments);
  frames_.push_back(std::move(frame));
  wake_ = Wake::next_exchange;
}

void EventSequence::pop(SimTime now, ScriptHost& host) {
  if (frames_.size() == 1) write_phase(now);
  host.end(frames_.back().instance);
  frames_.pop_back();
}

void EventSequence::enter_phase(const std::string& phase, SimTime now) {
  if (frames_.size() == 1) write_phase(now);
  frames_.back().phase = phase;
  frames_.back().phase_start = now;
}

// The phases of the plan's own event are logged, not those of events within it.
void EventSequence::write_phase(SimTime now) {
  const Frame& frame = frames_.front();
  phases_.push_back({event().rover_id, event().sequence, frame.phase, frame.phase_start, now});
}

PhaseContext EventSequence::context(SimTime now, RoverAgent& agent) const {
  return {.rover = agent,
          .now = now,
          .phase_start = frames_.back().phase_start,
          .event_start = *records_[index_].start,
          .mission_start = mission_.start_time,
          .seed = mission_.seed,
          .rover_id = event().rover_id,
          .sequence = event().sequence,
          .label = event().label};
}

// An event ends from outside its script: innermost first, each may clean up once.
void EventSequence::abort_scripts(SimTime now, RoverAgent& agent, ScriptHost& host) {
  while (!frames_.empty()) {
    PhaseContext called = context(now, agent);
    try {
      host.run_abort(frames_.back().instance, called);
    } catch (const ScriptError& error) {
      warnings_.push_back(error.what());
    }
    pop(now, host);
  }
  agent.brake();
}

void EventSequence::end(EventStatus status, const std::string& reason, SimTime now,
                        const RoverAgent& agent) {
  LSOS_ASSERT(frames_.empty());
  EventRecord& record = current();
  record.status = status;
  record.reason = reason;
  record.end = now;
  record.place = agent.place_now();
  if (record.start) record.distance_m = agent.view().distance_m - record.distance_start_m;
  changed(index_);
  has_turn_ = false;
  wake_ = Wake::next_exchange;
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
      finish(now);
      return;
    case OnFailure::stop:
      finish(now);
      return;
  }
}

// No more events run here. An end without having started says so to those who wait for them.
void EventSequence::finish(SimTime now) {
  is_finished_ = true;
  for (std::size_t i = index_ + 1; i < records_.size(); ++i) {
    if (records_[i].status == EventStatus::not_started) records_[i].end = now;
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
    changed(i);
  }
  index_ = index;
}

void EventSequence::stop(SimTime now, RoverAgent& agent, ScriptHost& host,
                         const std::string& reason) {
  if (!frames_.empty()) abort_scripts(now, agent, host);
  if (has_turn_) {
    const bool has_started = current().start.has_value();
    end(has_started ? EventStatus::incomplete : EventStatus::not_started, reason, now, agent);
  }
  finish(now);
}

std::optional<SimTime> EventSequence::wake(SimTime now) const {
  if (is_finished_) return std::nullopt;
  if (frames_.empty()) {
    if (!has_turn_) return now + exchange_period;
    // What StartAfter names wakes it when it ends; its StartTime is known.
    if (waits_for_others_) return std::nullopt;
    const SimTime next = now + exchange_period;
    if (!event().start_time) return next;
    return std::max(next, round_up_to_exchange(*event().start_time - mission_.start_time));
  }
  std::optional<SimTime> earliest;
  if (event().timeout) {
    earliest = round_up_to_exchange(*records_[index_].start + *event().timeout);
  }
  if (wake_ == Wake::next_exchange) return now + exchange_period;
  if (wake_ == Wake::at_time) earliest = earliest ? std::min(*earliest, wake_at_) : wake_at_;
  return earliest;
}

std::string EventSequence::event_label() const {
  return frames_.empty() ? "" : event().label;
}

std::string EventSequence::phase() const { return frames_.empty() ? "" : frames_.front().phase; }

EventRow EventSequence::row(std::size_t index) const {
  const PlanEvent& event = machine_.events[index].event;
  const EventRecord& record = records_[index];
  EventRow row;
  row.rover_id = event.rover_id;
  row.sequence = event.sequence;
  row.type = event.type;
  row.label = event.label;
  row.status = record.status;
  row.reason = record.reason;
  row.ready = record.ready;
  row.start = record.start;
  // An end without a start or a reason to have ended stands only inside (see after_failure).
  if (record.status != EventStatus::not_started) row.end = record.end;
  row.distance_m = record.distance_m;
  if (record.ready) row.place = record.place;
  return row;
}

void EventSequence::changed(std::size_t index) {
  if (!records_[index].is_written) return;
  records_[index].is_written = false;
  changed_.push_back(index);
}

std::vector<std::size_t> EventSequence::take_changed_events() {
  for (const std::size_t index : changed_) records_[index].is_written = true;
  return std::exchange(changed_, {});
}

std::vector<PhaseRow> EventSequence::take_phases() { return std::exchange(phases_, {}); }
std::vector<std::string> EventSequence::take_warnings() { return std::exchange(warnings_, {}); }

void EventSequence::archive(Archive& a, ScriptHost& host) {
  a.tag("events")(records_)(index_)(has_turn_)(waits_for_others_)(is_finished_)(
      wake_)(wake_at_)(aborts_mission_);
  std::uint64_t depth = frames_.size();
  a(depth);
  if (a.is_reading()) frames_.resize(depth);
  for (Frame& frame : frames_) {
    a(frame.type)(frame.phase)(frame.next)(frame.phase_start)(frame.arguments);
    std::string state = a.is_reading() ? "" : host.save(frame.instance);
    a(state);
    if (a.is_reading()) {
      frame.instance = host.begin(frame.type, frame.arguments);
      host.restore(frame.instance, state);
    }
  }
}

}  // namespace lsos
