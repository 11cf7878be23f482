// The events of one rover, run one after another: waits for turns and conditions, calls phases when
// they are due, ends events and decides what follows a failure. Events that need no turn take
// effect at their time, before the event whose turn it is.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "mission/events/condition_watch.h"
#include "mission/events/event_record.h"
#include "mission/events/running_event.h"
#include "mission/events/turn.h"
#include "mission/model/machine.h"
#include "terrain/ground.h"

namespace lsos {

class EventSequence {
 public:
  // `ground` must outlive it.
  EventSequence(const RoverMachine& machine, const Ground& ground);

  // In an estimate: conditions are evaluated the less often the longer they have been waited for.
  void wait_coarsely() { waits_coarsely_ = true; }
  // Runs what is due now.
  void run(const Turn& turn);
  // Adds an event behind those with a lower sequence. Throws InputError when its sequence is taken
  // or its turn is over.
  void add(const EventMachine& machine);
  // Takes up the events of another plan in place of those that have not begun; check_revision()
  // must have passed. Returns the sequences of those that are new, differ or are gone.
  std::set<std::int64_t> revise(const RoverMachine& machine);
  // Time at which `run` must be called next even if nothing else happens; nullopt: only something
  // else can wake it (an arrival, another rover's event).
  std::optional<SimTime> wake(SimTime now, Instant mission_start) const;

  // Says of events whose time has not come that the mission is over; when a failure ended the
  // sequence, that this prevented them.
  void close(SimTime now);
  // Ends the running event as incomplete and starts no other.
  // `is_failure`: because an event failed; otherwise the reasons also say what each event waited
  // for.
  void stop(const Turn& turn, const std::string& reason, bool is_failure);

  bool is_finished() const { return is_finished_; }
  // Whether WarnWhen of the running event held when it was evaluated last.
  bool does_warn() const { return running_ && watch_.holds(); }
  // Whether the event whose turn it is waits for charge.
  bool waits_for_charge() const { return has_turn_ && waits_for_charge_; }
  // Label of a failed event with OnFailure = abort, else "".
  const std::string& aborts_mission() const { return aborts_mission_; }

  // Label and phase of the running event, "" when none runs.
  std::string event_label() const;
  std::string phase() const;

  const std::vector<EventMachine>& events() const { return machine_.events; }
  const EventRecords& records() const { return records_; }
  EventRecords& records() { return records_; }
  EventRow row(std::size_t index) const;

  // Phases that have ended, and warnings, since the last call.
  std::vector<PhaseRow> take_phases();
  std::vector<std::string> take_warnings();

  // The running event's scripts are saved through `host`; when reading, they are begun again in it.
  void archive(Archive& a, ScriptHost& host);

 private:
  EventRecord& current() { return records_[index_]; }
  const PlanEvent& event() const { return machine_.events[index_].event; }

  // Evaluates a condition at its first exchange, then at whole seconds. Returns false and sets
  // `fault` when its script fails.
  bool is_met(const char* name, const PlanEvent::Condition& condition, bool is_first,
              const Turn& turn, std::string& fault) const;
  static void note(const char* decision, const PlanEvent::Condition& condition,
                   std::int64_t sequence, RoverAgent& agent);
  // Runs the events that take effect now without a turn.
  void run_timed(const Turn& turn);
  bool give_turn(const Turn& turn);
  // Starts the event whose turn it is, or ends it, when it is time. Returns false while it waits.
  bool begin(const Turn& turn);
  bool may_start(const Turn& turn, std::string& impossible);
  void start(const Turn& turn);
  EventArguments arguments_of(const PlanEvent& event) const;
  // Records where the rover stands with what counts from an event's start.
  void begin_record(EventRecord& record, const Turn& turn) const;
  void end_record(EventRecord& record, EventStatus status, const std::string& reason,
                  const Turn& turn);
  SimTime next_evaluation(SimTime now) const;
  std::optional<SimTime> wake_of_turns(SimTime now, Instant mission_start) const;
  void stop_turns(const Turn& turn, const std::string& why, bool is_failure);
  // Calls the running event's script, or ends the event. Returns false when nothing more is due.
  bool go_on(const Turn& turn, int& changes);
  // Why the running event cannot go on, whatever its script requests; "" when it can.
  std::string hindrance(const RoverAgent& agent) const;
  bool is_powerless(const RoverAgent& agent) const;
  // Whether the event whose turn it is must wait for charge.
  bool lacks_charge(const RoverAgent& agent) const;
  bool is_timed_out(SimTime now) const;
  // Ends the running event from outside. Returns its progress as far as its script reports it.
  std::string abort(const Turn& turn);
  // Ends the running event and returns its progress: "in phase 'charge' since 600 s".
  std::string progress_until(const Turn& turn);
  void end(EventStatus status, const std::string& reason, const Turn& turn);
  void after_failure(SimTime now);
  void skip_to(std::size_t index, SimTime now);
  void finish(SimTime now, const std::string& reason, bool is_failure);
  void warn(std::optional<std::string> warning);

  RoverMachine machine_;
  const Ground* ground_;
  EventRecords records_;
  bool has_timed_ = false;       // not saved
  bool waits_coarsely_ = false;  // not saved
  std::size_t index_ = 0;
  bool has_turn_ = false;          // events_[index_] is waiting or running
  bool waits_for_others_ = false;  // for the end of an event in StartAfter
  bool waits_for_charge_ = false;  // the battery was empty, or a drive below the reserve
  bool waits_for_condition_ = false;
  bool is_finished_ = false;
  bool has_failed_ = false;  // it is finished because an event failed
  std::optional<RunningEvent> running_;
  ConditionWatch watch_;  // of the running event
  std::string aborts_mission_;

  std::vector<PhaseRow> phases_;
  std::vector<std::string> warnings_;
};

}  // namespace lsos
