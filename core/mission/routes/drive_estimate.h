// What a drive is expected to take before anything moves: time and energy along its line, by the
// drive cost model that routes are planned with.
#pragma once

#include <string>
#include <vector>

#include "mission/port/rover_port.h"
#include "mission/routes/drive_slack.h"
#include "route/cost/drive_cost.h"
#include "terrain/ground.h"
#include "vehicle/path_follower.h"

namespace lsos {

// Sums from the beginning of a drive to a place of its line.
struct DriveMark {
  double along_m = 0;   // straight from point to point of the line
  double driven_m = 0;  // along the ground
  double time_s = 0;
  double energy_j = 0;  // electrical, of the drives
};

// Greatest distance between two marks.
inline constexpr double mark_spacing_m = 250;

struct DriveEstimate {
  Path3 line_S_m;                         // on the ground, from the rover to the end of its path
  std::vector<std::size_t> gear_changes;  // points of the line, as in FollowSettings
  std::ptrdiff_t path_begins_at = 1;      // point of the line that is the path's first
  std::vector<DriveMark> marks;           // ascending; the first is all 0
  DriveSlack slack;                       // of what it takes in all
  // Why it is expected to end at the last mark, before the end of its path; "" when it is not.
  std::string failure;
  bool is_blocked = false;  // by the ground ahead
};

// A drive on a planned route, whose legs say what they take. `from_S_m`: where the rover is.
// `cost`: that the route was planned with.
DriveEstimate estimate_planned(const DriveCost& cost, const Vec3& from_S_m,
                               const PlannedRoute& route, const FollowSettings& settings);

// A drive on any path. It ends where the ground is too steep for the rover's wheels or not known.
// `yaw_rad`: of the rover, counter-clockwise from east. `cost`, `limits`: at the speed of the
// drive.
DriveEstimate estimate_drawn(const Ground& ground, const DriveCost& cost,
                             const FollowerLimits& limits, const Vec3& from_S_m, double yaw_rad,
                             const Path3& path_S_m, const FollowSettings& settings);

}  // namespace lsos
