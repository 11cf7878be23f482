// The planned routes of one rover: events take up the legs planned for them before the start; where
// these do not fit, legs are planned anew.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "mission/port/rover_port.h"
#include "mission/routes/drive_estimate.h"
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
  std::int64_t sequence = 0;  // sequence of the event it is for
  std::int64_t waypoint = 0;  // number of the waypoint it leads to, from 1
  LegStart start;
  Vec3 goal_S_m = Vec3::Zero();
  RouteSettings settings;
  PlannedLeg leg;
  std::vector<Vec3> hubs_B_m = {};  // on limbs: the stance that it is planned for
};

class RoverRoutes {
 public:
  // `vehicle`, `ground` and `legs` must outlive it. `load_w`: power of the loads while the rover
  // drives, without its wheel motors.
  RoverRoutes(const VehicleConfig& vehicle, const GroundLimits& limits, double load_w,
              const Ground& ground, PlannedLegs& legs);

  bool can_turn_on_spot() const { return vehicle_.can_turn_on_spot; }
  double speed_max_mps() const { return vehicle_.speed_max_mps; }
  const std::string& rover_type() const { return vehicle_.type; }
  // Drive cost model of the rover; the reference is valid as long as this object.
  const DriveCost& cost(const RouteSettings& settings);
  // Obstacles near enough to affect a leg between these places.
  Obstacles obstacles_about(const Vec3& start_S_m, const Vec3& goal_S_m) const;
  PlannedLeg leg(const RouteSettings& settings, const LegStart& start, const Vec3& goal_S_m);
  void set_ahead(const std::vector<LegAhead>& ahead) { ahead_ = &ahead; }
  // On limbs: plans from now on for the stance with its wheels' hubs at these places. Legs planned
  // ahead are taken up in the stance that they are planned for.
  void stand_on(const std::vector<Vec3>& hubs_B_m);
  // The same for a stance of the rover's script; false: it has none of that name.
  bool stand_in(const std::string& stance);
  void stand_as_started();
  // The stance in which the rover starts, when that is not the configuration's.
  void start_on(const std::vector<Vec3>& hubs_B_m);
  const std::vector<Vec3>& hubs_B_m() const { return hubs_B_m_; }
  // Adds rows for the legs planned ahead. `sequences`: of these events alone; nullptr: of all.
  void log_ahead(const std::string& rover_id, SimTime now,
                 const std::set<std::int64_t>* sequences = nullptr);

  // See RoverPort::plan_path(). `sequence`: of the calling event.
  PlannedRoute plan(const std::string& rover_id, SimTime now, std::int64_t sequence,
                    const LegStart& start, const Path3& waypoints_S_m, std::int64_t first,
                    const RouteSettings& settings);

  // What a drive is expected to take: the legs of the route that was planned last know, where that
  // is what is driven.
  DriveEstimate estimate(const Vec3& from_S_m, double yaw_rad, const Path3& path_S_m,
                         const FollowSettings& settings);

  // Whether a rover is so near to its next waypoint that it need not drive to it.
  static bool is_passed(const RouteSettings& settings, const Vec3& p_S_m, const Vec3& waypoint_S_m);
  // "the leg to waypoint 2: the goal is on ...; the nearest place that can be reached is ..."
  static std::string no_route_text(const Ground& ground, std::int64_t waypoint,
                                   const Vec3& start_S_m, const Vec3& goal_S_m,
                                   const PlannedLeg& leg);
  // "the leg to waypoint 2 ends 1.3 m from it, within ArrivalRadius: the goal is on ..."
  static std::string short_end_text(std::int64_t waypoint, const Vec3& goal_S_m,
                                    const PlannedLeg& leg);

  std::vector<PlannedPathRow> take_rows();
  std::vector<std::string> take_warnings();

  void archive(Archive& a) { LSOS_ARCHIVE(a, attempts_, started_B_m_); }

 private:
  const LegAhead* ahead(std::int64_t sequence, std::int64_t waypoint, const LegStart& start,
                        const Vec3& goal_S_m, const RouteSettings& settings);
  void log(const std::string& rover_id, SimTime now, std::int64_t sequence, std::int64_t waypoint,
           const PlannedLeg& leg);

  const VehicleConfig* config_;
  VehicleConfig vehicle_;  // as it stands
  std::vector<Vec3> hubs_B_m_;
  std::vector<Vec3> started_B_m_;  // of the stance in which the rover starts
  GroundLimits limits_;
  double load_w_;
  const Ground* ground_;
  PlannedLegs* legs_;
  std::map<std::pair<double, double>, DriveCost> costs_;  // key: speed and greatest slope
  const std::vector<LegAhead>* ahead_ = nullptr;
  // How often each leg was planned, by sequence and waypoint; at waypoint 0 how often the event has
  // requested a route.
  std::map<std::int64_t, std::map<std::int64_t, std::int64_t>> attempts_;
  PlannedRoute last_;  // not saved: only estimates ask for it
  std::vector<PlannedPathRow> rows_;
  std::vector<std::string> warnings_;
};

}  // namespace lsos
