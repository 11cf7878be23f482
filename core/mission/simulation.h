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
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/worker_pool.h"
#include "mission/ahead/route_ahead.h"
#include "mission/events/event_sequence.h"
#include "mission/light/light.h"
#include "mission/light/sight_over_end.h"
#include "mission/light/sight_watch.h"
#include "mission/model/machine.h"
#include "mission/model/rover_model.h"
#include "mission/port/script_host.h"
#include "mission/rover/rover_agent.h"
#include "mission/rover/standing_asset.h"
#include "record/log.h"

namespace lsos {

struct SimulationSetup {
  Plan plan;
  std::map<std::string, RoverModel> rover_models;  // key: PlanRover::model()
  std::map<std::string, AssetModel> asset_models;  // key: AssetType
  TerrainSpec terrain;
  std::function<std::unique_ptr<ScriptHost>()> make_host;
  int threads = 1;
  // Torture mode: at each exchange all state is written out, thrown away and read back.
  bool save_every_exchange = false;
  // Whether lines of sight are evaluated, for the layers `pairs` and `sight_intervals` of the log.
  bool keeps_sight = false;
  // Legs planned by an earlier run, see PlannedLegs.
  std::string cached_legs = {};
  // Whether routes are planned before the start. A simulation that resumes a saved state needs
  // none.
  bool plans_ahead = true;
  // Called once the routes are planned with the legs to keep for later runs, also when a leg has no
  // route.
  std::function<void(const std::string& bytes)> cache_legs = {};
  // Called with a description as the planning of each leg begins, and with "" when it ends.
  std::function<void(const std::string& what)> on_planning = {};
};

// Totals and extremes of one rover over the mission.
struct RoverResult {
  std::string id;
  double distance_m = 0;
  double duration_s = 0;  // until the end of its last event
  double drive_s = 0;
  double elevation_gain_m = 0;
  double slope_max_rad = not_modelled;
  double slip_greatest = not_modelled, slip_p95 = not_modelled;  // while driving, see DriveSlip
  double slip_rolling = not_modelled, driven_s = 0;              // see DriveSlip
  double mean_mps = not_modelled, mean_requested_mps = not_modelled;
  double energy_start_j = not_modelled, energy_end_j = not_modelled;
  double energy_used_j = not_modelled, solar_j = not_modelled, external_j = not_modelled;
  std::map<std::string, double> resources = {};
};

class Simulation : private EventSequence::EventLookup, private Surroundings {
 public:
  // Runs the machine's `initialise`: creates the ground and site frame, places the vehicles at
  // their starts, plans routes. Throws InputError when the plan does not fit the terrain.
  explicit Simulation(SimulationSetup setup);
  ~Simulation() override;

  // Sets the log that rows are written to; without one none are written. Call it before `start`, or
  // later with a log that begins anew, which then also receives the events that have started or
  // ended by then.
  void set_log(LogWriter* log);
  // Sets the listener that is called with each note of scripts and findings. Call it before
  // `start`.
  void set_note_listener(std::function<void(const NoteRow&)> listener) {
    note_listener_ = std::move(listener);
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
  const Ground& ground() const { return *ground_; }
  // Name of the GPU that renders light and sight; "" when neither is needed.
  std::string renderer() const { return renderer_ ? renderer_->gpu.name() : ""; }

  std::vector<EventRow> events() const;
  std::vector<RoverResult> results() const;
  const std::vector<std::string>& warnings() const { return warnings_; }
  // Warnings known before the start: about the terrain, legs without a route, and equipment that
  // events need.
  std::vector<Fault> advice() const;
  // The routes of one rover that are planned before the start.
  struct RoverRoutesAhead {
    std::string rover_id;
    std::vector<LegAhead> legs;
    std::vector<PassedWaypoint> passed;
    std::vector<DrawnLine> drawn;
  };
  const std::vector<RoverRoutesAhead>& routes_ahead() const { return routes_ahead_; }
  // Legs for the next run to recall; "" when this run planned no new one.
  std::string cached_legs() const { return legs_->kept(); }
  std::vector<std::string> assumptions() const;
  // Warnings about stops that see the Sun or Earth over the end of the known ground, at times
  // estimated from the plan.
  std::vector<Fault> ground_end_warnings() const;
  // Progress of the mission, 0..1: events that have ended, plus the driven share of those under
  // way.
  double progress() const;

  // Interactive control by a prompt or a scenario, between exchanges.
  std::vector<std::string> rover_ids() const;
  // Returns nullptr when there is no such rover.
  RoverAgent* agent(const std::string& rover_id);
  const EventSequence* sequence(const std::string& rover_id) const;
  // Adds an event of a rover. Throws InputError when its sequence is taken or its turn is over, or
  // when there is no such rover.
  void dispatch(const PlanEvent& event);
  // Writes a row in `notes` about an interactive change to a rover. `fields_json`: a JSON object
  // with sorted keys.
  void note_interactive(const std::string& rover_id, const std::string& name,
                        const std::string& fields_json);

  // Serialises all state, and restores it into a simulation of the same setup.
  std::string save();
  void restore(const std::string& bytes);

 private:
  struct Rover {
    std::unique_ptr<RoverAgent> agent;
    EventSequence sequence;
    std::optional<SimTime> wake;    // when its scripts are due although it is parked
    std::optional<SimTime> logged;  // time of its last sample
    bool was_parked = true;         // at the start of this exchange; not saved
    Motion motion = Motion::none;   // motion of the rover or its panels now; not saved
  };

  void check_soil() const;
  void place_assets();
  void build();
  void place_rovers();
  void throw_with_advice(Faults& faults) const;
  void plan_routes();
  void check_starts_overlap(Faults& faults) const;
  void exchange();
  void avoid_rovers();
  void avoid_assets();
  void run_scripts();
  void take_warnings(Rover& rover);
  // Sunlight, and power from assets to rovers (simulation_light.cpp).
  void make_light();
  void add_light_assumptions(std::vector<std::string>& assumptions) const;
  void update_sunlight();
  void warn_of_ends();
  void share_power();
  Motion motion_of(const Rover& rover) const;
  Motion motion_near(const Vec3& p_S_m, const RoverAgent* except) const;
  Mesh solids_near(const Vec3& eye_S_m, const std::string& except_id, const Sunlight& sun) const;
  std::optional<SimTime> quiet_wake(const Rover& rover) const;
  // Lines of sight (simulation_sight.cpp).
  void make_sight();
  std::vector<SightEnd> sight_ends() const;
  Mesh solids_between(const Vec3& from_S_m, const Vec3& to_S_m) const;
  void update_sight();
  void log_pairs(std::size_t from);
  void finish_sight();
  void log_rows();
  void log_sample(std::size_t number);
  SimTime next_time();
  std::size_t events_ended() const;
  bool is_sample_due(const Rover& rover) const;
  SimTime next_sample(const Rover& rover) const;
  const EventRecord& record(const PlanEvent::Reference& event) const override;
  std::optional<Vec3> place_S_m(const std::string& id) const override;
  SkyView sky(const Geodetic& place) const override;
  std::optional<PairSight> sight(const std::string& id, const std::string& other) const override;

  SimulationSetup setup_;
  LogWriter* log_ = nullptr;
  std::function<void(const NoteRow&)> note_listener_;
  MissionMachine machine_;
  std::unique_ptr<Ground> ground_;
  // Vehicles with links; key: PlanRover::model() and RoverConfig.
  std::map<std::pair<std::string, std::string>, VehicleConfig> vehicles_;
  std::unique_ptr<ScriptHost> host_;
  std::unique_ptr<PlannedLegs> legs_;
  std::vector<RoverRoutesAhead> routes_ahead_;  // one for each rover
  std::vector<Fault> route_faults_;
  std::vector<PowerSource> sources_;
  std::vector<StandingAsset> assets_;
  std::unique_ptr<Renderer> renderer_;
  std::unique_ptr<Light> light_;
  std::unique_ptr<SightOverEnd> sun_over_end_;  // with light_
  std::unique_ptr<SightWatch> sight_;
  std::optional<SimTime> assets_logged_;  // when pairs of assets were last logged
  double optical_depth_ = 0;
  std::vector<Rover> rovers_;
  WorkerPool pool_;
  SimTime now_{};
  bool is_finished_ = false;
  std::vector<std::string> warnings_;
};

}  // namespace lsos
