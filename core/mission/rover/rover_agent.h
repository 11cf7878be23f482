// One rover in the simulation: what it is made of, the order in which its parts take part in an
// exchange, and what scripts command of it through RoverPort.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "driving/driven_track.h"
#include "mission/model/breakable.h"
#include "mission/model/measured_state.h"
#include "mission/model/rover_model.h"
#include "mission/model/rover_start.h"
#include "mission/port/rover_port.h"
#include "mission/port/surroundings.h"
#include "mission/routes/rover_routes.h"
#include "mission/rover/body_shape.h"
#include "mission/rover/rover_drive.h"
#include "mission/rover/rover_journal.h"
#include "mission/rover/rover_motion.h"
#include "mission/rover/rover_posture.h"
#include "mission/rover/rover_power.h"
#include "mission/rover/rover_tally.h"
#include "mission/rover/supply_watch.h"
#include "plan/plan.h"

namespace lsos {

class RoverAgent : public RoverPort {
 public:
  // `config`: the model's vehicle with links. `config`, `ground`, `sources`, `legs` and
  // `surroundings` must outlive it.
  RoverAgent(const PlanRover& rover, const RoverModel& model, const VehicleConfig& config,
             const Ground& ground, std::span<const PowerSource> sources, PlannedLegs& legs,
             const Surroundings& surroundings);
  RoverAgent(const RoverAgent&) = delete;  // parts point at each other
  RoverAgent& operator=(const RoverAgent&) = delete;

  const std::string& id() const { return rover_.id; }
  bool is_parked() const { return drive_.is_parked(); }

  // From now on its drives are foreseen in place of stepped: for an estimate of the mission.
  void foresee_drives() { foresees_ = true; }

  // Places the rover at its start. Throws InputError when the terrain there is not known or too
  // steep to stand on.
  void place(double default_heading_rad);
  // Sets all that `start` says, in place of what the plan and the script say: breakages, stance,
  // place and heading, panels, masts, battery and resources. What broke is noted. Throws as
  // place().
  void begin(const RoverStart& start);

  // Between two exchanges: puts the rover, at rest, where and as it was measured to be; a drive
  // goes on from there. Throws as place(), and for a rover that can no longer drive.
  Correction correct(const MeasuredState& measured);

  // The moments of an exchange, in their order.
  // Before it: steps the physics. It touches nothing but this rover and the ground.
  void advance();
  // Reads the state of the vehicle and updates the path follower. Returns whether a foreseen drive
  // has ended.
  bool observe(SimTime now);
  // In an estimate, after all have observed: drives on behind the rover that it follows.
  void pursue_foreseen(const RoverAgent& leader, bool has_leader_ended);
  // Brings the energy balance up to `now`. A rover whose battery is empty stops.
  void update_energy(SimTime now);
  // Scripts run here, and command it through RoverPort.
  // Gives the vehicle its command, and parks it when it rests.
  void control();
  // Sunlight is evaluated here, and power from assets is shared out by what is accepted of it, W.
  double accepted_w(double offered_w);
  // Fixes what flows from now on, and reports short supply and shed loads.
  void settle_energy();

  // Updates the power flows for the present claims of scripts; conditions read them.
  void update_flows();
  // Called at the end of an event: stops whatever it left under way.
  void release();

  const RoverMotion& motion() const { return motion_; }
  RoverDrive& drive() { return drive_; }
  const RoverDrive& drive() const { return drive_; }
  RoverPower& power() override { return power_; }
  const RoverPower& power() const { return power_; }
  const AntennaArray& antennas() const { return antennas_; }
  RoverRoutes& routes() { return routes_; }
  RoverJournal& journal() { return journal_; }
  const RoverTally& tally() const { return tally_; }
  const BodyShape& shape() const { return shape_; }
  // Where it has driven; absent: nothing asked for that.
  const std::optional<DrivenTrack>& track() const { return track_; }
  // Records its track from now on, at each exchange.
  void keep_track();
  // In an estimate: when its limbs come to rest; in the past where they have.
  SimTime limbs_move_until() const { return limbs_move_until_; }
  // Position of the antenna in use.
  Vec3 antenna_S_m() const;

  // What a scenario breaks or repairs between two exchanges, from the next one on. Returns the
  // fields of a note about it. Throws as break_part().
  std::string inject(const Breakage& breakage);
  // Has a wheel driven from the next exchange on, also one that is not in its configuration; "":
  // all of them. Throws as break_part().
  void inject_driven_wheel(const std::string& wheel);

  const RoverView& view() const override { return view_; }
  DriveState drive_state() const override { return drive_.state(); }
  void follow(const Path3& path_S_m, const FollowSettings& settings) override;
  void follow_rover(const PursuitSettings& settings) override;
  PlannedRoute plan_path(const Path3& waypoints_S_m, std::int64_t first,
                         const RouteSettings& settings) override;
  Vec3 ahead_S_m(double distance_m) const override;
  std::optional<GroundView> ground_at(const Vec3& p_S_m) const override;
  SkyView sky() const override { return surroundings_->sky(motion_.place()); }
  std::optional<Vec3> place_of_S_m(const std::string& id) const override {
    return surroundings_->place_S_m(id);
  }
  std::optional<PairSight> sight_of(const std::string& id) const override {
    return surroundings_->sight(rover_.id, id);
  }
  void brake() override { drive_.brake(); }
  Deployment deploy_antenna(const std::string& antenna, bool up,
                            std::optional<double> duration_s) override;
  double set_posture(const PostureRequest& request) override;
  void break_part(const Breakage& breakage) override;
  void note(const std::string& name, const std::string& fields_json) override {
    journal_.note(name, fields_json);
  }
  void warn(const std::string& text) override { journal_.warn(text); }

  void archive(Archive& a);

 private:
  void update_view();
  bool is_at_rest() const { return is_parked() && !drive_.is_carried(); }
  DriveEstimate estimate(const Path3& path_S_m, const FollowSettings& settings);
  void begin_as(const RoverStart& start);
  void correct_place(const MeasuredState& measured, Correction& correction);
  void check_reach(const Geodetic& measured, const Place& row) const;
  void correct_charge(const MeasuredState& measured, Correction& correction);
  void stand_at(const Geodetic& wanted, double wanted_rad, const std::vector<double>& joints,
                bool is_again);
  std::vector<double> joints_of(const RoverStart& start) const;
  void begin_panels(const RoverStart& start);
  void begin_masts(const RoverStart& start);
  BreakageOfParts resolved(const Breakage& breakage) const;
  void apply(const BreakageOfParts& breakage, SimTime from);

  PlanRover rover_;
  const Surroundings* surroundings_;
  RoverJournal journal_;
  RoverMotion motion_;
  RoverDrive drive_;
  std::optional<DrivenTrack> track_;
  RoverTally tally_;
  BodyShape shape_;
  RoverPower power_;
  SupplyWatch supply_watch_;
  AntennaArray antennas_;
  BreakableParts breakable_parts_;
  RoverRoutes routes_;
  bool foresees_ = false;
  SimTime limbs_move_until_{};  // in an estimate, with this power
  double limbs_w_ = 0;
  SimTime now_{};  // time of the last exchange
  RoverView view_;
};

}  // namespace lsos
