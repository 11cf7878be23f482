// State and results of events.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/archive.h"
#include "plan/plan.h"
#include "record/rows.h"

namespace lsos {

struct EventRecord {
  EventStatus status = EventStatus::not_started;
  std::string reason;
  std::optional<SimTime> ready, start, end;
  double distance_start_m = 0, distance_m = not_modelled;
  double used_start_j = not_modelled, energy_used_j = not_modelled;
  double solar_start_j = not_modelled, solar_j = not_modelled;
  double charge_start = not_modelled, charge_end = not_modelled;  // 0..1
  Geodetic place;             // place of the rover at the start, then at the end
  bool is_prevented = false;  // will not start because of a failure
  bool is_timed = false;      // PlanEvent::at: it has no turn
  bool is_written = true;     // the log holds its present state

  // Whether it is over, or will never run.
  bool has_ended() const;
  // Whether it has begun, or is over without having begun.
  bool has_begun() const;
  // Whether its turn came and the mission has ended before what it waited for did.
  bool has_waited_in_vain() const;

  void archive(Archive& a);
  bool is_sound() const;
};

// The records of one rover's events, and which of them the log does not hold as they are.
class EventRecords {
 public:
  explicit EventRecords(std::size_t count) : all_(count) {}

  const std::vector<EventRecord>& all() const { return all_; }
  std::size_t size() const { return all_.size(); }
  EventRecord& operator[](std::size_t index) { return all_[index]; }
  const EventRecord& operator[](std::size_t index) const { return all_[index]; }
  void insert(std::size_t index, bool is_timed);
  // When the last event so far ended.
  SimTime last_end() const;
  // Gives events that have not started an end, which events waiting for them read as never to run;
  // those that take effect without a turn only with `timed_too`.
  void prevent_rest(SimTime now, const std::string& reason, bool is_failure, bool timed_too);

  // Marks an event for writing.
  void mark_changed(std::size_t index);
  // Marks all events that a log of the mission so far holds for writing again: those that have had
  // their turn, and the disabled ones. The others are written at the end.
  void mark_all_changed();
  // Events to be written since the last call, in the order of their changes.
  std::vector<std::size_t> take_changed();

  void archive(Archive& a) { LSOS_ARCHIVE(a, all_); }

 private:
  std::vector<EventRecord> all_;
  std::vector<std::size_t> changed_;
};

// What an event may query about the events of other rovers.
class EventLookup {
 public:
  virtual ~EventLookup() = default;
  virtual const EventRecord& record(const PlanEvent::Reference& event) const = 0;
};

// Row of the log. Until an event ends, it holds the state in which a killed program would leave it.
EventRow event_row(const PlanEvent& event, const EventRecord& record);

}  // namespace lsos
