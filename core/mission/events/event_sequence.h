// The events of one rover, run one after another: waits for its turn and conditions, calls phases
// when they are due, ends events and decides what follows a failure.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mission/events/running_event.h"
#include "mission/model/machine.h"
#include "planet/site_frame.h"
#include "terrain/ground.h"

namespace lsos {

// What became of one event so far.
struct EventRecord {
  EventStatus status = EventStatus::not_started;
  std::string reason;
  std::optional<SimTime> ready, start, end;
  double distance_start_m = 0, distance_m = not_modelled;
  double used_start_j = not_modelled, energy_used_j = not_modelled;
  double solar_start_j = not_modelled, solar_j = not_modelled;
  Geodetic place;             // of the rover when it started, then ended
  bool is_prevented = false;  // will not start because of a failure
  bool is_written = true;     // nothing new for the log

  void archive(Archive& a);
};

class EventSequence {
 public:
  // What an event may ask about the other rovers' events.
  class Others {
   public:
    virtual ~Others() = default;
    virtual const EventRecord& record(const PlanEvent::Reference& event) const = 0;
  };

  EventSequence(const RoverMachine& machine, const MissionInfo& mission, const Ground& ground);

  // Runs what is due at `now`.
  void run(SimTime now, RoverAgent& agent, ScriptHost& host, const Others& others);
  // One more event, behind those with a lower sequence. Throws InputError where its turn is over.
  void add(const EventMachine& machine);
  // The simulated time at which `run` must be called next though nothing else happens; nullopt:
  // only something else can wake it (an arrival, another rover's event).
  std::optional<SimTime> wake(SimTime now) const;

  // Ends the running event as incomplete and starts no other.
  // `is_failure`: because an event failed; else the reasons say besides what each waited for.
  void stop(SimTime now, RoverAgent& agent, ScriptHost& host, const Others& others,
            const std::string& reason, bool is_failure);

  bool is_finished() const { return is_finished_; }
  // When the last event so far ended.
  SimTime last_end() const;
  // An event with OnFailure = abort has failed: its label, else "".
  const std::string& aborts_mission() const { return aborts_mission_; }

  // Label and phase of the running event, "" when none runs.
  std::string event_label() const;
  std::string phase() const;

  const std::vector<EventMachine>& events() const { return machine_.events; }
  const std::vector<EventRecord>& records() const { return records_; }
  EventRow row(std::size_t index) const;

  // Rows for the log since the last call, in order of happening.
  std::vector<std::size_t> take_changed_events();
  // All that have had their turn are rows for the log again.
  void write_events_anew();
  std::vector<PhaseRow> take_phases();
  std::vector<std::string> take_warnings();

  // The running event's scripts are saved through `host` and begun again in it when reading.
  void archive(Archive& a, ScriptHost& host);

 private:
  EventRecord& current() { return records_[index_]; }
  const PlanEvent& event() const { return machine_.events[index_].event; }

  // Conditions are asked at first, then at whole seconds. False with a fault where its script
  // broke.
  bool is_met(const char* name, const PlanEvent::Condition& condition, bool is_first, SimTime now,
              const RoverAgent& agent, ScriptHost& host, std::string& fault);
  void note(const char* decision, const PlanEvent::Condition& condition, RoverAgent& agent) const;
  bool take_turn(SimTime now, const RoverAgent& agent);
  bool may_start(SimTime now, RoverAgent& agent, ScriptHost& host, const Others& others,
                 std::string& impossible);
  void start(SimTime now, const RoverAgent& agent, ScriptHost& host);
  // Why the running event cannot go on, whatever its script wants; "" when it can.
  std::string hindrance(const RoverAgent& agent) const;
  void warn_of_unfinished_drive(const RoverAgent& agent);
  void warn_of_late_start(SimTime now);
  bool is_powerless(const RoverAgent& agent) const;
  bool is_timed_out(SimTime now) const;
  // Answers how far it had come, as far as it says so.
  std::string abort(SimTime now, RoverAgent& agent, ScriptHost& host);
  // What the event whose turn it is waits for before it starts, with the values it has
  // (event_sequence_waiting.cpp).
  std::string waits_for(SimTime now, const RoverAgent& agent, ScriptHost& host,
                        const Others& others) const;
  // How far the running event has come: "in phase 'charge' since 600 s"; ends it.
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
  bool waits_for_others_ = false;  // for the end of a StartAfter
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
