// The planned ways of one rover: legs planned ahead when the mission is made are taken up by the
// events that they are for; what does not fit is planned anew.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "mission/port/rover_port.h"
#include "mission/routes/planned_legs.h"
#include "record/rows.h"
#include "route/map/ground_limits.h"
#include "vehicle/vehicle_config.h"

namespace lsos {

// Where a rover is when a leg begins.
struct LegStart {
  Vec3 p_S_m = Vec3::Zero();
  double heading_rad = 0;  // clockwise from north
  bool is_at_rest = true;
};

// A leg planned before its event starts.
struct LegAhead {
  std::int64_t sequence = 0;  // of the event
  std::int64_t waypoint = 0;  // that it leads to, the first is 1
  LegStart start;
  Vec3 goal_S_m = Vec3::Zero();
  RouteSettings settings;
  PlannedLeg leg;
};

class RoverRoutes {
 public:
  // `vehicle`, `ground` and `legs` must outlive it. `load_w`: what the rover takes while it drives,
  // besides its drives.
  RoverRoutes(const VehicleConfig& vehicle, const GroundLimits& limits, double load_w,
              const Ground& ground, PlannedLegs& legs);

  bool can_turn_on_spot() const { return vehicle_->can_turn_on_spot; }
  double speed_max_mps() const { return vehicle_->speed_max_mps; }
  const std::string& rover_type() const { return vehicle_->type; }
  // What planning knows of the rover; kept as long as this.
  const DriveCost& cost(const RouteSettings& settings);
  // What stands so near that a leg between these places has to do with it.
  Obstacles obstacles_about(const Vec3& start_S_m, const Vec3& goal_S_m) const;
  PlannedLeg leg(const RouteSettings& settings, const LegStart& start, const Vec3& goal_S_m);
  void set_ahead(const std::vector<LegAhead>& ahead) { ahead_ = &ahead; }
  // Rows of what was planned ahead.
  void log_ahead(const std::string& rover_id);

  // See RoverPort. `sequence`: the event that asks.
  PlannedWay plan(const std::string& rover_id, SimTime now, std::int64_t sequence,
                  const LegStart& start, const Path3& waypoints_S_m, std::int64_t first,
                  const RouteSettings& settings);

  // Whether a rover that is to go through this waypoint next need not drive to it.
  static bool is_passed(const RouteSettings& settings, const Vec3& p_S_m, const Vec3& waypoint_S_m);
  // "the leg to waypoint 2: the goal is on ...; the nearest place that it can reach is ..."
  static std::string no_way_text(const Ground& ground, std::int64_t waypoint, const Vec3& start_S_m,
                                 const Vec3& goal_S_m, const PlannedLeg& leg);

  std::vector<PlannedPathRow> take_rows();
  std::vector<std::string> take_warnings();

  void archive(Archive& a) { a(attempts_); }

 private:
  const LegAhead* ahead(std::int64_t sequence, std::int64_t waypoint, const LegStart& start,
                        const Vec3& goal_S_m, const RouteSettings& settings);
  void log(const std::string& rover_id, SimTime now, std::int64_t sequence, std::int64_t waypoint,
           const PlannedLeg& leg);

  const VehicleConfig* vehicle_;
  GroundLimits limits_;
  double load_w_;
  const Ground* ground_;
  PlannedLegs* legs_;
  std::map<std::pair<double, double>, DriveCost> costs_;  // by speed and slope allowed
  const std::vector<LegAhead>* ahead_ = nullptr;
  // How often each leg was planned, by sequence and waypoint; at waypoint 0 how often the event has
  // asked for a way.
  std::map<std::int64_t, std::map<std::int64_t, std::int64_t>> attempts_;
  std::vector<PlannedPathRow> rows_;
  std::vector<std::string> warnings_;
};

}  // namespace lsos
