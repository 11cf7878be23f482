// One rover in the simulation: its vehicle, the path it follows, its power and antennas, and
// whether it is parked. Scripts command it through RoverPort.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mission/model/rover_model.h"
#include "mission/port/motion.h"
#include "mission/port/rover_port.h"
#include "mission/port/surroundings.h"
#include "mission/routes/rover_routes.h"
#include "mission/rover/body_shape.h"
#include "mission/rover/drive_slip.h"
#include "mission/rover/rover_power.h"
#include "plan/plan.h"
#include "record/rows.h"
#include "vehicle/footprint.h"
#include "vehicle/path_follower.h"
#include "vehicle/vehicle.h"

namespace lsos {

class RoverAgent : public RoverPort {
 public:
  struct Note {
    std::int64_t sequence = 0;  // sequence of the event that wrote it
    std::string name, fields_json;
  };

  // `config`: the model's vehicle with links. `config`, `ground`, `sources`, `legs` and
  // `surroundings` must outlive it.
  RoverAgent(const PlanRover& rover, const RoverModel& model, const VehicleConfig& config,
             const Ground& ground, std::span<const PowerSource> sources, PlannedLegs& legs,
             const Surroundings& surroundings);

  // Places the rover at its start. Throws InputError when the terrain there is not known or too
  // steep to stand on.
  void place(double default_heading_rad);

  const std::string& id() const { return rover_.id; }
  bool is_parked() const { return is_parked_; }
  // Why the vehicle can no longer drive: rolled over, left the terrain, numbers not finite; else
  // "".
  const std::string& fault() const { return fault_; }
  bool is_broken() const { return is_broken_; }  // numbers are not finite: it stays where it is

  // Between exchanges: steps the physics. It touches nothing but this rover and the ground.
  void advance();
  // At an exchange, before scripts run: reads the state of the vehicle and updates the path
  // follower.
  void observe();
  // At an exchange, after observe(): brings the energy balance up to `now`. A rover whose battery
  // is empty stops.
  void update_energy(SimTime now);
  // At an exchange, after scripts ran: gives the vehicle its command, and parks it when it rests.
  void control();

  // Footprint after another `ahead_s` of the present motion.
  Footprint footprint(double ahead_s = 0) const;
  // Footprints, in order, up to where the rover would rest if it braked now: on its line when it
  // follows one, else straight ahead; while it turns on the spot, within a second.
  std::vector<Footprint> footprints_ahead() const;
  // Ends the drive because the rover would touch another, whose centre is `distance_m` away.
  void end_drive_before(const std::string& other_id, double distance_m);

  // Whether sunlight must be evaluated again: the Sun has moved far enough; the rover or something
  // near it moves, at whole multiples of two seconds; or motion has just ended.
  bool is_sun_due(SimTime now, Motion near) const;
  // When sunlight is next due if nothing else happens; absent: never.
  std::optional<SimTime> sun_wake(SimTime now) const;
  // Sets the result of an evaluation, which holds until the next.
  void set_sun(const PanelSunlight& value);
  const BodyShape& shape() const { return shape_; }
  // Poses of the chassis and each link; with broken dynamics the last finite ones.
  std::vector<PartPose> part_poses() const;
  // At an exchange, after scripts ran: power taken of what the asset that it is plugged into
  // offers, W.
  double accepted_w(double offered_w);
  // Warns once when the charge falls below the reserve.
  void warn_of_low_charge(SimTime now);
  // Updates the power flows for the present claims of scripts; conditions read them.
  void update_flows();
  // At the end of an exchange: fixes what flows from now on, and reports short supply and shed
  // loads.
  void settle_energy();

  const RoverView& view() const override { return view_; }
  RoverPower& power() override { return power_; }
  Deployment deploy_antenna(const std::string& antenna, bool up,
                            std::optional<double> duration_s) override;
  const AntennaArray& antennas() const { return antennas_; }
  // Failures injected by a scenario; they take effect at the next exchange. `name`: the link of a
  // wheel; throws std::runtime_error when there is none of that name.
  void set_wheel(const std::string& name, WheelMode mode);
  void set_silent(bool is_silent) { antennas_.set_silent(is_silent, now_ + exchange_period); }
  // Position of the antenna in use.
  Vec3 antenna_S_m() const;
  const RoverPower& power() const { return power_; }
  // Energy of loads, drives and losses since the start, and energy from panels; NaN without a
  // battery.
  double energy_used_j() const;
  double solar_j() const;
  DriveState drive() const override;
  // Share 0..1 of the followed line that lies behind; 0 when it follows none.
  double drive_share() const;
  void follow(const Path3& path_S_m, const FollowSettings& settings) override;
  PlannedRoute plan_path(const Path3& waypoints_S_m, std::int64_t first,
                         const RouteSettings& settings) override;
  Vec3 ahead_S_m(double distance_m) const override;
  std::optional<GroundView> ground_at(const Vec3& p_S_m) const override;
  SkyView sky() const override { return surroundings_->sky(place_now()); }
  std::optional<Vec3> place_of_S_m(const std::string& id) const override {
    return surroundings_->place_S_m(id);
  }
  std::optional<PairSight> sight_of(const std::string& id) const override {
    return surroundings_->sight(rover_.id, id);
  }
  RoverRoutes& routes() { return routes_; }
  void brake() override;
  // Called at the end of an event: stops whatever it left under way.
  void release();
  void note(const std::string& name, const std::string& fields_json) override;
  void warn(const std::string& text) override { warnings_.push_back(text); }

  // Sets the event that the following notes belong to.
  void set_noting_sequence(std::int64_t sequence) { noting_sequence_ = sequence; }
  // Notes since the last call.
  std::vector<Note> take_notes();
  // Warnings for the user since the last call.
  std::vector<std::string> take_warnings();
  Geodetic place_now() const;
  SampleRow sample(SimTime now, const std::string& event, const std::string& phase) const;
  // The same with the slip that conditions use: the mean over the last second of driving.
  SampleRow condition_sample(SimTime now, const std::string& event, const std::string& phase) const;
  std::vector<JointRow> joints(SimTime now) const;
  std::vector<PanelRow> panels(SimTime now) const;
  std::vector<ResourceRow> resources(SimTime now) const;

  const DriveSlip& slip() const { return slip_; }
  // Extremes over all exchanges.
  double slope_max_rad() const { return slope_max_rad_; }
  double elevation_gain_m() const;
  // Time at more than 1 mm/s, up to the end of the last event: swaying after it is not driving.
  double drive_s() const { return seconds(drive_time_in_events_); }

  void archive(Archive& a);

 private:
  void look();
  void find_faults();
  void follow_path();
  void find_hindrances();
  bool is_driving() const;
  void fail_drive(const std::string& finding, const std::string& reason,
                  const std::string& fields_json);
  void warn_of_shed_loads(double shed_w);
  void report_short_supply();
  void update_view();
  void update_extremes();
  void update_slip();

  PlanRover rover_;
  const Ground* ground_;
  const Surroundings* surroundings_;
  Vehicle vehicle_;
  Footprint footprint_at_rest_;
  BodyShape shape_;
  RoverPower power_;
  AntennaArray antennas_;
  RoverRoutes routes_;
  SimTime now_{};                  // time of the last exchange
  bool has_motion_ended_ = false;  // since sunlight was last evaluated
  bool is_shedding_ = false;
  bool has_warned_of_empty_ = false;  // warned that the battery is empty
  bool has_warned_of_low_ = false;    // warned that the charge is below the reserve
  bool has_warned_of_shed_ = false;   // warned that the battery, not empty, gives too little
  RoverView view_;
  VehicleReport report_;
  std::vector<double> joints_;  // m or rad, at the last exchange with finite numbers
  std::optional<PathFollower> follower_;
  DriveCommand command_;
  bool has_new_command_ = false;
  bool is_parked_ = true;
  bool is_broken_ = false;
  int exchanges_at_rest_ = 0;
  std::string fault_;
  std::string drive_failure_;            // why the present drive ended early, "" when it did not
  bool may_touch_with_chassis_ = false;  // high-centred when this drive began; may drive free
  std::vector<Note> notes_;
  std::vector<std::string> warnings_;
  std::int64_t noting_sequence_ = 0;
  DriveSlip slip_;
  double slope_max_rad_ = not_modelled;
  double elevation_gain_m_ = 0;
  double elevation_low_m_ = not_modelled, elevation_high_m_ = not_modelled;
  bool is_rising_ = false;
  SimTime drive_time_{}, drive_time_in_events_{};
};

}  // namespace lsos
