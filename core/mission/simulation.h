// A running mission: the clock, the rovers with their event sequences, and the order in which
// things happen.
//
// Time is whole microseconds. Every 0.1 s is an exchange; between two exchanges each rover's
// physics reads only itself and the ground, so rovers step in parallel on several threads. An
// exchange runs on one thread, in byte order of RoverId: the state of the physics is read, scripts
// run, commands are given, rows are logged. A parked rover takes part only when it wakes; when all
// are parked, the clock leaps to the earliest wake.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/worker_pool.h"
#include "mission/ahead/mission_work.h"
#include "mission/fleet/fleet.h"
#include "mission/fleet/fleet_sight.h"
#include "mission/fleet/fleet_sunlight.h"
#include "mission/fleet/mission_log.h"
#include "mission/fleet/mission_site.h"
#include "mission/fleet/preparation.h"
#include "mission/fleet/rover_result.h"
#include "mission/fleet/simulation_setup.h"
#include "mission/kept_warnings.h"
#include "mission/model/machine.h"
#include "mission/model/plan_revision.h"

namespace lsos {

class Simulation : private Surroundings {
 public:
  // Runs the machine's `initialise`: creates the ground and site frame, places the vehicles at
  // their starts, plans routes. Throws InputError when the plan does not fit the terrain.
  explicit Simulation(SimulationSetup setup);
  ~Simulation() override;

  // Sets the log that rows are written to; without one none are written. Call it before `start`, or
  // later with a log that begins anew, which then also receives the events that have started or
  // ended by then.
  void set_log(LogWriter* log) { log_.set_writer(log, fleet_); }
  // Writes what happened since the last exchange: notes, events and planned legs. A checkpoint does
  // not hold them.
  void log_changes();
  // Sets the listener that is called with each note of scripts and findings. Call it before
  // `start`.
  void set_note_listener(std::function<void(const NoteRow&)> listener) {
    log_.set_listener(std::move(listener));
  }
  // Runs the exchange at time 0.
  void start();
  // Steps to the next exchange, over quiet time in one leap, but no farther than `until`, which
  // must be a later exchange.
  void advance(std::optional<SimTime> until = {});
  // Ends running events as incomplete (a signal, the end of MaxDuration).
  void stop(const std::string& reason, bool is_failure = false);
  // Runs the machine's `terminate`: writes the last samples and the remaining events. Called once,
  // when finished.
  void terminate();

  bool is_finished() const { return is_finished_; }
  SimTime now() const { return now_; }
  const Plan& plan() const { return setup_.plan; }
  const Ground& ground() const { return *site_.ground; }
  // Name of the GPU that renders light and sight; "" when neither is needed.
  std::string renderer() const { return renderer_ ? renderer_->gpu.name() : ""; }

  std::vector<EventRow> events() const;
  std::vector<RoverResult> results() const;
  const std::vector<std::string>& warnings() const { return warnings_.texts(); }
  // Says how many more there were than are kept; "" when all are.
  std::string warnings_left_out() const { return warnings_.rest(); }
  // Warnings known before the start: about the terrain, legs without a route, and equipment that
  // events need.
  std::vector<Fault> advice() const;
  // Routes that are planned before the start.
  const std::vector<RoverRoutesAhead>& routes_ahead() const { return routes_ahead_.rovers; }
  // Legs for the next run to recall; "" when this run planned no new one.
  std::string cached_legs() const { return site_.legs->kept(); }
  std::vector<std::string> assumptions() const;
  // Warnings about stops that see the Sun or Earth over the end of the known ground, at times
  // estimated from the plan.
  std::vector<Fault> ground_end_warnings() const;
  // Progress of the mission, 0..1: events that have ended, plus the driven share of those under
  // way.
  double progress() const;
  // What it has done and has yet to do, for an estimate of the time that is left.
  MissionWork work() const;
  // Ids of the rovers that are not parked.
  std::vector<std::string> moving_rovers() const;
  bool is_at_rest() const;

  // Interactive control by a prompt or a scenario, between exchanges: rovers may be commanded.
  const Fleet& fleet() const { return fleet_; }
  // Adds an event of a rover. Throws InputError when its sequence is taken or its turn is over, or
  // when there is no such rover.
  void dispatch(const PlanEvent& event);
  // Writes a row in `notes` about an interactive change to a rover. `fields_json`: a JSON object
  // with sorted keys.
  void note_interactive(const std::string& rover_id, const std::string& name,
                        const std::string& fields_json);

  // Goes on from what was measured of rovers, by id, in place of what was simulated. Throws
  // InputError with all faults; the simulation is then of no use.
  std::map<std::string, Correction> correct(const std::map<std::string, MeasuredState>& measured);

  // Goes on from what a simulation of another plan has come to, which is of no use afterwards; its
  // plan and this one must have passed check_revision().
  void go_on_from(Simulation& earlier);
  // Events that have begun or ended.
  EventReferences begun_events() const;

  // Serialises all state, and restores it into a simulation of the same setup. What is restored may
  // come from anyone: throws Archive::Mismatch for what no such simulation saves, after which the
  // simulation is of no use.
  std::string save();
  void restore(const std::string& bytes);

 private:
  void build();
  void hand_out_routes();
  void throw_with_advice(Faults& faults) const;
  void plan_routes();
  void make_light_and_sight();
  void update_light_and_sight();
  void exchange();
  void run_scripts();
  void take_warnings(FleetRover& rover);
  void warn_of_ends();
  Moment moment() const { return {now_, setup_.plan.mission.start_time + now_}; }
  Turn turn_of(const FleetRover& rover) const;
  // Earliest time at which something happens to a parked rover that its scripts do not wait for.
  std::optional<SimTime> quiet_wake(const FleetRover& rover) const;
  SimTime next_time() const;
  void archive(Archive& a);
  void take_up(const std::string& bytes);
  // Whether rovers follow others whose tracks are known.
  bool has_sound_convoys() const;
  // Writes out all state, throws it away and reads it back.
  void save_and_restore();

  std::optional<Vec3> place_S_m(const std::string& id) const override {
    return fleet_.place_S_m(id);
  }
  bool has_rover(const std::string& id) const override { return fleet_.find(id) != nullptr; }
  std::optional<Obstacle> obstacle(const std::string& rover_id) const override {
    return fleet_.obstacle(rover_id);
  }
  SkyView sky(const Geodetic& place) const override;
  std::optional<PairSight> sight(const std::string& id, const std::string& other) const override;

  SimulationSetup setup_;
  MissionMachine machine_;
  MissionSite site_;
  std::unique_ptr<ScriptHost> host_;
  FleetRoutes routes_ahead_;
  Fleet fleet_;
  std::unique_ptr<Renderer> renderer_;
  std::unique_ptr<FleetSunlight> sunlight_;  // nullptr: nothing depends on sunlight
  std::unique_ptr<FleetSight> sight_;        // nullptr: lines of sight are not evaluated
  MissionLog log_;
  WorkerPool pool_;
  SimTime now_{};
  bool is_finished_ = false;
  KeptWarnings warnings_;
};

}  // namespace lsos
