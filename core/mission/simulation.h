// A mission that runs: the clock, the rovers and their machines, and the order in which things
// happen.
//
// Time is whole microseconds. Every 0.1 s is an exchange; between two exchanges each rover's
// physics reads only itself and the ground, so rovers step side by side on several threads. At an
// exchange, on one thread and in byte order of RoverId: physics is looked at, scripts run,
// commands are given, rows are logged. A parked rover takes part only when it wakes; when all
// rest, the clock leaps to the earliest wake.
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
#include "mission/light/looks_over_end.h"
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
  std::map<std::string, RoverModel> rover_models;  // by PlanRover::model()
  std::map<std::string, AssetModel> asset_models;  // by AssetType
  TerrainSpec terrain;
  std::function<std::unique_ptr<ScriptHost>()> make_host;
  int threads = 1;
  // Torture: at each exchange all state is written out, everything is thrown away and read back.
  bool save_every_exchange = false;
  // Layers `pairs` and `sight_intervals` are wanted.
  bool keeps_sight = false;
  // Legs that an earlier run has planned, see PlannedLegs.
  std::string kept_legs = {};
  // Ways are planned before it starts. One that is made to go on from a saved state needs none.
  bool plans_ahead = true;
  // Called with those to keep once the ways are planned, also where one is missing.
  std::function<void(const std::string& bytes)> keep_legs = {};
  // Told what is planned as that begins, "" at its end.
  std::function<void(const std::string& what)> on_planning = {};
};

// What became of one rover.
struct RoverResult {
  std::string id;
  double distance_m = 0;
  double duration_s = 0;  // to its last event's end
  double drive_s = 0;
  double elevation_gain_m = 0;
  double slope_max_rad = not_modelled;
  double slip_greatest = not_modelled, slip_p95 = not_modelled;  // of driving, see DriveSlip
  double slip_rolling = not_modelled, driven_s = 0;              // the same
  double mean_mps = not_modelled, mean_requested_mps = not_modelled;
  double energy_start_j = not_modelled, energy_end_j = not_modelled;
  double energy_used_j = not_modelled, solar_j = not_modelled, external_j = not_modelled;
  std::map<std::string, double> resources = {};
};

class Simulation : private EventSequence::Others, private Surroundings {
 public:
  // The machine's `initialise`: ground, site frame, vehicles standing at their starts. Throws
  // InputError when the plan does not fit the terrain.
  explicit Simulation(SimulationSetup setup);
  ~Simulation() override;

  // Where rows go; none are written without. Before `start`; or later, of a log that begins anew:
  // events that were under way or over by then are in it too.
  void set_log(LogWriter* log);
  // Who is told each note that scripts and findings write. Before `start`.
  void set_note_listener(std::function<void(const NoteRow&)> listener) {
    note_listener_ = std::move(listener);
  }
  // The exchange at time 0.
  void start();
  // To the next exchange, over quiet time in one leap; no farther than `until`, an exchange to
  // come.
  void advance(std::optional<SimTime> until = {});
  // Ends what runs as incomplete (a signal, the end of MaxDuration).
  void stop(const std::string& reason, bool is_failure = false);
  // `terminate`: last samples, the rest of the events. Called once, when finished.
  void terminate();

  bool is_finished() const { return is_finished_; }
  SimTime now() const { return now_; }
  const Plan& plan() const { return setup_.plan; }
  const Ground& ground() const { return *ground_; }
  // What draws light and sight; "" when nothing asks for it.
  std::string renderer() const { return renderer_ ? renderer_->gpu.name() : ""; }

  std::vector<EventRow> events() const;
  std::vector<RoverResult> results() const;
  const std::vector<std::string>& warnings() const { return warnings_; }
  // What is known before it starts: of the terrain's files, of ways that do not exist.
  std::vector<Fault> advice() const;
  // The ways that are planned before it starts.
  struct WayAhead {
    std::string rover_id;
    std::vector<LegAhead> legs;
    std::vector<PassedWaypoint> passed;
    std::vector<DrawnLine> drawn;
  };
  const std::vector<WayAhead>& ways_ahead() const { return ways_ahead_; }
  // Legs for the next run to take up; "" when it would learn nothing new.
  std::string kept_legs() const { return legs_->kept(); }
  std::vector<std::string> assumptions() const;
  // Where its stops see Sun and Earth over the end of the ground, by an estimate of its duration.
  std::vector<Fault> end_ahead() const;
  // How far the mission has come, 0..1: events that have ended, and the share driven of those under
  // way.
  double progress() const;

  // For whoever has it in hand: a prompt, a scenario. Between exchanges.
  std::vector<std::string> rover_ids() const;
  // nullptr: there is no such rover.
  RoverAgent* agent(const std::string& rover_id);
  const EventSequence* sequence(const std::string& rover_id) const;
  // One more event of a rover. Throws InputError where its turn is over.
  void dispatch(const PlanEvent& event);
  // A row in `notes` of what a hand has done to a rover. `fields_json`: an object with sorted keys.
  void note_by_hand(const std::string& rover_id, const std::string& name,
                    const std::string& fields_json);

  // All state, and back into a simulation of the same setup.
  std::string save();
  void restore(const std::string& bytes);

 private:
  struct Rover {
    std::unique_ptr<RoverAgent> agent;
    EventSequence sequence;
    std::optional<SimTime> wake;    // when its scripts must be called though it is parked
    std::optional<SimTime> logged;  // its last sample
    bool was_parked = true;         // when this exchange began; not saved
    Motion motion = Motion::none;   // of it or its panels at this exchange; not saved
  };

  void check_soil() const;
  void stand_assets();
  void build();
  void place_rovers();
  void throw_with_advice(Faults& faults) const;
  void plan_ways();
  void find_things_in_each_other(Faults& faults) const;
  void exchange();
  void keep_apart();
  void keep_off_assets();
  void run_scripts();
  void take_warnings(Rover& rover);
  // The light, and who gives power to whom (simulation_light.cpp).
  void make_light();
  void add_light_assumptions(std::vector<std::string>& assumptions) const;
  void watch_the_sun();
  void warn_of_ends();
  void share_power();
  Motion motion_of(const Rover& rover) const;
  Motion motion_near(const Vec3& p_S_m, const RoverAgent* except) const;
  Mesh solids_near(const Vec3& eye_S_m, const std::string& except_id, const Sunlight& sun) const;
  std::optional<SimTime> quiet_wake(const Rover& rover) const;
  // Who sees whom (simulation_sight.cpp).
  void make_sight();
  std::vector<SightEnd> sight_ends() const;
  Mesh solids_between(const Vec3& from_S_m, const Vec3& to_S_m) const;
  void watch_sight();
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
  // By RoverType and RoverConfig, with links.
  std::map<std::pair<std::string, std::string>, VehicleConfig> vehicles_;
  std::unique_ptr<ScriptHost> host_;
  std::unique_ptr<PlannedLegs> legs_;
  std::vector<WayAhead> ways_ahead_;  // by rover
  std::vector<Fault> way_faults_;
  std::vector<PowerSource> sources_;
  std::vector<StandingAsset> assets_;
  std::unique_ptr<Renderer> renderer_;
  std::unique_ptr<Light> light_;
  std::unique_ptr<LooksOverEnd> sun_over_end_;  // with light_
  std::unique_ptr<SightWatch> sight_;
  std::optional<SimTime> assets_logged_;  // pairs of assets
  double optical_depth_ = 0;
  std::vector<Rover> rovers_;
  WorkerPool pool_;
  SimTime now_{};
  bool is_finished_ = false;
  std::vector<std::string> warnings_;
};

}  // namespace lsos
