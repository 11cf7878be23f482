// The events of one rover, run one after another: waits for turns and conditions, calls phases when
// they are due, ends events and decides what follows a failure.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mission/events/running_event.h"
#include "mission/model/machine.h"
#include "planet/site_frame.h"
#include "terrain/ground.h"

namespace lsos {

// State and results of one event.
struct EventRecord {
  EventStatus status = EventStatus::not_started;
  std::string reason;
  std::optional<SimTime> ready, start, end;
  double distance_start_m = 0, distance_m = not_modelled;
  double used_start_j = not_modelled, energy_used_j = not_modelled;
  double solar_start_j = not_modelled, solar_j = not_modelled;
  Geodetic place;             // place of the rover at the start, then at the end
  bool is_prevented = false;  // will not start because of a failure
  bool is_written = true;     // the log holds its present state

  void archive(Archive& a);
};

class EventSequence {
 public:
  // What an event may query about the events of other rovers.
  class EventLookup {
   public:
    virtual ~EventLookup() = default;
    virtual const EventRecord& record(const PlanEvent::Reference& event) const = 0;
  };

  EventSequence(const RoverMachine& machine, const MissionInfo& mission, const Ground& ground);

  // Runs what is due at `now`.
  void run(SimTime now, RoverAgent& agent, ScriptHost& host, const EventLookup& others);
  // Adds an event behind those with a lower sequence. Throws InputError when its sequence is taken
  // or its turn is over.
  void add(const EventMachine& machine);
  // Time at which `run` must be called next even if nothing else happens; nullopt: only something
  // else can wake it (an arrival, another rover's event).
  std::optional<SimTime> wake(SimTime now) const;

  // Ends the running event as incomplete and starts no other.
  // `is_failure`: because an event failed; otherwise the reasons also say what each event waited
  // for.
  void stop(SimTime now, RoverAgent& agent, ScriptHost& host, const EventLookup& others,
            const std::string& reason, bool is_failure);

  bool is_finished() const { return is_finished_; }
  // When the last event so far ended.
  SimTime last_end() const;
  // Label of a failed event with OnFailure = abort, else "".
  const std::string& aborts_mission() const { return aborts_mission_; }

  // Label and phase of the running event, "" when none runs.
  std::string event_label() const;
  std::string phase() const;

  const std::vector<EventMachine>& events() const { return machine_.events; }
  const std::vector<EventRecord>& records() const { return records_; }
  EventRow row(std::size_t index) const;

  // Rows for the log since the last call, in the order of the changes.
  std::vector<std::size_t> take_changed_events();
  // Marks all events that have had their turn for writing again.
  void write_events_anew();
  std::vector<PhaseRow> take_phases();
  std::vector<std::string> take_warnings();

  // The running event's scripts are saved through `host`; when reading, they are begun again in it.
  void archive(Archive& a, ScriptHost& host);

 private:
  EventRecord& current() { return records_[index_]; }
  const PlanEvent& event() const { return machine_.events[index_].event; }

  // Evaluates a condition at its first exchange, then at whole seconds. Returns false and sets
  // `fault` when its script fails.
  bool is_met(const char* name, const PlanEvent::Condition& condition, bool is_first, SimTime now,
              const RoverAgent& agent, ScriptHost& host, std::string& fault);
  void note(const char* decision, const PlanEvent::Condition& condition, RoverAgent& agent) const;
  bool give_turn(SimTime now, const RoverAgent& agent);
  bool may_start(SimTime now, RoverAgent& agent, ScriptHost& host, const EventLookup& others,
                 std::string& impossible);
  void start(SimTime now, const RoverAgent& agent, ScriptHost& host);
  // Why the running event cannot go on, whatever its script requests; "" when it can.
  std::string hindrance(const RoverAgent& agent) const;
  void warn_of_unfinished_drive(const RoverAgent& agent);
  void warn_of_late_start(SimTime now);
  bool is_powerless(const RoverAgent& agent) const;
  bool is_timed_out(SimTime now) const;
  // Ends the running event from outside. Returns its progress as far as its script reports it.
  std::string abort(SimTime now, RoverAgent& agent, ScriptHost& host);
  // What the event whose turn it is waits for before it starts, with the present values
  // (event_sequence_waiting.cpp).
  std::string waits_for(SimTime now, const RoverAgent& agent, ScriptHost& host,
                        const EventLookup& others) const;
  // Ends the running event and returns its progress: "in phase 'charge' since 600 s".
  std::string progress_until(SimTime now, RoverAgent& agent, ScriptHost& host);
  void end(EventStatus status, const std::string& reason, SimTime now, RoverAgent& agent);
  void after_failure(SimTime now);
  void skip_to(std::size_t index, SimTime now);
  void finish(SimTime now, const std::string& reason, bool is_failure);
  void changed(std::size_t index);

  RoverMachine machine_;
  MissionInfo mission_;
  const Ground* ground_;

  std::vector<EventRecord> records_;
  std::size_t index_ = 0;
  bool has_turn_ = false;          // events_[index_] is waiting or running
  bool waits_for_others_ = false;  // for the end of an event in StartAfter
  bool waits_for_charge_ = false;  // the battery was empty
  bool waits_for_condition_ = false;
  bool is_finished_ = false;
  std::optional<RunningEvent> running_;
  std::string aborts_mission_;

  std::vector<std::size_t> changed_;
  std::vector<PhaseRow> phases_;
  std::vector<std::string> warnings_;
};

}  // namespace lsos
