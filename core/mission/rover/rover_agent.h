// One rover in the simulation: its vehicle, what it is following, and whether it is parked. This
// is what scripts command through RoverPort.
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
    std::int64_t sequence = 0;  // of the event that wrote it
    std::string name, fields_json;
  };

  // `config`: the model's vehicle with links. `config`, `ground`, `sources`, `legs` and
  // `surroundings` must outlive it.
  RoverAgent(const PlanRover& rover, const RoverModel& model, const VehicleConfig& config,
             const Ground& ground, std::span<const PowerSource> sources, PlannedLegs& legs,
             const Surroundings& surroundings);

  // Stands the rover at its start. Throws InputError when the terrain is not known there.
  void place(double default_heading_rad);

  const std::string& id() const { return rover_.id; }
  bool is_parked() const { return is_parked_; }
  // Why the vehicle can drive no more: rolled over, left the terrain, broken numbers; else "".
  const std::string& fault() const { return fault_; }
  bool is_broken() const { return is_broken_; }  // numbers are not finite: it stays where it is

  // Between exchanges; touches nothing but this rover and the ground.
  void advance();
  // At an exchange, before scripts run: looks at the vehicle and at the line it follows.
  void observe();
  // At an exchange, after observe(): brings the energy balance up to `now`. A rover whose battery
  // is empty stops.
  void count_energy(SimTime now);
  // At an exchange, after scripts ran: gives the vehicle its command, and parks it when it rests.
  void control();

  // What it covers after so much more of its present motion.
  Footprint footprint(double ahead_s = 0) const;
  // What it covers, one after the other, before it could come to rest if it braked: on its line
  // where it follows one, else straight on; while it turns on the spot, within a second.
  std::vector<Footprint> footprints_ahead() const;
  // It would touch another: the drive ends.
  void end_drive_before(const std::string& other_id, double distance_m);

  // The Sun is to be looked at again: it has moved so far; or the rover or something near it moves,
  // at whole multiples of two seconds; or motion has just ended.
  bool is_sun_due(SimTime now, Motion near) const;
  // When, though nothing else happens; absent: never.
  std::optional<SimTime> sun_wake(SimTime now) const;
  // What the look was of; it holds until the next.
  void set_sun(const SunValue& value);
  const BodyShape& shape() const { return shape_; }
  // With broken dynamics: where its parts were last.
  std::vector<PartPose> part_poses() const;
  // At an exchange, after scripts ran: of what the asset that it is plugged into offers, W.
  double taken_w(double offered_w);
  // What flows as long as scripts ask for nothing else; conditions look at it.
  void tell_low(SimTime now);
  void find_flows();
  // What flows from now on.
  void settle_energy();

  const RoverView& view() const override { return view_; }
  RoverPower& power() override { return power_; }
  Deployment deploy_antenna(const std::string& antenna, bool up,
                            std::optional<double> duration_s) override;
  const AntennaArray& antennas() const { return antennas_; }
  // Failures that a scenario makes; they are seen at the next exchange. Wheels by the names of
  // their links; throws std::runtime_error where there is none.
  void set_wheel(const std::string& name, WheelMode mode);
  void set_silent(bool is_silent) { antennas_.set_silent(is_silent, now_ + exchange_period); }
  // Of the antenna in use.
  Vec3 antenna_S_m() const;
  const RoverPower& power() const { return power_; }
  // Load, drive and loss since the start, and what panels gave; NaN without a battery.
  double energy_used_j() const;
  double solar_j() const;
  DriveState drive() const override;
  // How much of the line that it follows lies behind, 0..1; 0 when it follows none.
  double drive_share() const;
  void follow(const Path3& path_S_m, const FollowSettings& settings) override;
  PlannedWay plan_path(const Path3& waypoints_S_m, std::int64_t first,
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
  // The event has ended: stops whatever it left under way.
  void release();
  void note(const std::string& name, const std::string& fields_json) override;
  void warn(const std::string& text) override { warnings_.push_back(text); }

  // Notes that follow are of this event.
  void set_noting_sequence(std::int64_t sequence) { noting_sequence_ = sequence; }
  // What scripts have noted since the last call.
  std::vector<Note> take_notes();
  // What the user should know, since the last call.
  std::vector<std::string> take_warnings();
  Geodetic place_now() const;
  SampleRow sample(SimTime now, const std::string& event, const std::string& phase) const;
  // The same with the slip that conditions look at: of driving, over the last second.
  SampleRow condition_sample(SimTime now, const std::string& event, const std::string& phase) const;
  std::vector<JointRow> joints(SimTime now) const;
  std::vector<PanelRow> panels(SimTime now) const;
  std::vector<ResourceRow> resources(SimTime now) const;

  const DriveSlip& slip() const { return slip_; }
  // Extremes over all exchanges.
  double slope_max_rad() const { return slope_max_rad_; }
  double elevation_gain_m() const;
  // Faster than 1 mm/s, until an event last ended: what sways on after it is no driving.
  double drive_s() const { return seconds(drive_time_in_events_); }

  void archive(Archive& a);

 private:
  void look();
  void find_faults();
  void drive_on();
  void find_hindrances();
  bool is_driving() const;
  void fail_drive(const std::string& finding, const std::string& reason,
                  const std::string& fields_json);
  void tell_shed(double shed_w);
  void tell_short();
  void update_view();
  void count_extremes();
  void count_slip();

  PlanRover rover_;
  const Ground* ground_;
  const Surroundings* surroundings_;
  Vehicle vehicle_;
  Footprint footprint_at_rest_;
  BodyShape shape_;
  RoverPower power_;
  AntennaArray antennas_;
  RoverRoutes routes_;
  SimTime now_{};                  // of the last exchange
  bool has_motion_ended_ = false;  // since the last look at the Sun
  bool is_shedding_ = false;
  bool has_told_empty_ = false;  // that its battery was
  bool has_told_low_ = false;    // that its charge was below the reserve
  bool has_told_shed_ = false;   // that its battery, though not empty, gives less than is asked
  RoverView view_;
  VehicleReport report_;
  std::vector<double> joints_;  // m or rad, as report_ of the last good exchange
  std::optional<PathFollower> follower_;
  DriveCommand command_;
  bool has_new_command_ = false;
  bool is_parked_ = true;
  bool is_broken_ = false;
  int exchanges_at_rest_ = 0;
  std::string fault_;
  std::string drive_failure_;            // why the present drive ended early, "" when it did not
  bool may_touch_with_chassis_ = false;  // high-centred when this drive began: let it get free
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
