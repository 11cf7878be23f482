#include "mission/event_sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/units.h"

namespace lsos {

namespace {

constexpr int phase_changes_max = 100;   // at one exchange; more is a loop
constexpr double far_from_point_m = 50;  // a stationary event's Point farther than this is odd

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
  a(status)(reason)(ready)(start)(end)(distance_start_m)(distance_m)(place.lon_rad)(place.lat_rad)(
      place.height_m)(is_written);
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
    if (!running_) {
      std::string impossible;
      if (may_start(now, others, impossible)) {
        start(now, agent, host);
        changes = 0;
      } else if (impossible.empty()) {
        return;
      } else {
        end(EventStatus::failed, impossible, now, agent);
        continue;
      }
    }
    std::string hindered = hindrance(now, agent);
    if (++changes > phase_changes_max) hindered = "its phases go round without time passing";
    if (!hindered.empty()) {
      abort(now, agent, host);
      end(EventStatus::failed, hindered, now, agent);
      if (agent.is_broken()) finish(now);
      continue;
    }
    if (!running_->is_due(now, agent)) return;
    switch (running_->call(now, mission_, agent, host)) {
      case RunningEvent::Progress::waits:
        return;
      case RunningEvent::Progress::goes_on:
        break;
      case RunningEvent::Progress::completed:
        end(EventStatus::completed, "", now, agent);
        break;
      case RunningEvent::Progress::failed:
        end(EventStatus::failed, running_->reason(), now, agent);
        break;
    }
  }
}

std::string EventSequence::hindrance(SimTime now, const RoverAgent& agent) const {
  const bool drives = agent.drive().status != DriveState::Status::none;
  if (!agent.fault().empty() && (drives || agent.is_broken())) return agent.fault();
  const SimTime running = now - *records_[index_].start;
  if (event().timeout && running >= *event().timeout) {
    return fmt::format("timed out after {} s", seconds(*event().timeout));
  }
  return "";
}

// Gives the next enabled event its turn; false when there is none.
bool EventSequence::take_turn(SimTime now, const RoverAgent& agent) {
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
        impossible = fmt::format("{}/{}, which it waits for, can no longer run", awaited.rover_id,
                                 awaited.sequence);
      }
      waits_for_others_ = true;
      return false;
    }
    // The order of rovers within one exchange must not matter: it counts from the next one.
    if (*record.end >= now) return false;
  }
  return !event().start_time || *event().start_time - mission_.start_time <= now;
}

void EventSequence::start(SimTime now, const RoverAgent& agent, ScriptHost& host) {
  current().status = EventStatus::running;
  current().start = now;
  current().distance_start_m = agent.view().distance_m;
  current().place = agent.place_now();
  changed(index_);
  const EventMachine& machine = machine_.events[index_];
  const Path3 path_S_m = geometry_S_m(event().geometry, *ground_);
  if (!machine.declaration.drives && event().geometry.kind == GeometryKind::point) {
    const double away_m =
        surface_distance_m(*mission_.planet, agent.place_now(), event().geometry.points.front());
    if (away_m > far_from_point_m) {
      warnings_.push_back(fmt::format("{} of {}: the rover is {:.0f} m from the event's Point",
                                      event().label, event().rover_id, away_m));
    }
  }
  running_.emplace(event(), EventArguments{event().params, path_S_m}, now, host);
}

void EventSequence::abort(SimTime now, RoverAgent& agent, ScriptHost& host) {
  for (std::string& fault : running_->abort(now, mission_, agent, host)) {
    warnings_.push_back(std::move(fault));
  }
}

void EventSequence::end(EventStatus status, const std::string& reason, SimTime now,
                        const RoverAgent& agent) {
  EventRecord& record = current();
  if (running_) {
    for (PhaseRow& phase : running_->take_phases()) phases_.push_back(std::move(phase));
  }
  record.status = status;
  record.reason = reason;
  record.end = now;
  record.place = agent.place_now();
  if (record.start) record.distance_m = agent.view().distance_m - record.distance_start_m;
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
  if (running_) abort(now, agent, host);
  if (has_turn_) {
    const bool has_started = current().start.has_value();
    end(has_started ? EventStatus::incomplete : EventStatus::not_started, reason, now, agent);
  }
  finish(now);
}

std::optional<SimTime> EventSequence::wake(SimTime now) const {
  if (is_finished_) return std::nullopt;
  const SimTime next = now + exchange_period;
  if (running_) {
    std::optional<SimTime> wake = running_->wake(now);
    if (event().timeout) {
      const SimTime over = round_up_to_exchange(*records_[index_].start + *event().timeout);
      wake = std::min(wake.value_or(over), over);
    }
    return wake;
  }
  // What StartAfter names wakes it when it ends; its StartTime is known.
  if (waits_for_others_) return std::nullopt;
  if (!has_turn_ || !event().start_time) return next;
  return std::max(next, round_up_to_exchange(*event().start_time - mission_.start_time));
}

std::string EventSequence::event_label() const { return running_ ? event().label : ""; }
std::string EventSequence::phase() const { return running_ ? running_->phase() : ""; }

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

std::vector<PhaseRow> EventSequence::take_phases() {
  if (running_) {
    for (PhaseRow& phase : running_->take_phases()) phases_.push_back(std::move(phase));
  }
  return std::exchange(phases_, {});
}
std::vector<std::string> EventSequence::take_warnings() { return std::exchange(warnings_, {}); }

void EventSequence::archive(Archive& a, ScriptHost& host) {
  a.tag("events")(records_)(index_)(has_turn_)(waits_for_others_)(is_finished_)(aborts_mission_);
  bool is_running = running_.has_value();
  a(is_running);
  if (a.is_reading() && is_running) running_.emplace();
  if (is_running) running_->archive(a, host);
}

}  // namespace lsos
