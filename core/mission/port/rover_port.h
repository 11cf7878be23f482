// A rover as scripts see it: its state, and their commands. Commands take effect in the following
// exchange period.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/sim_time.h"
#include "base/vector.h"
#include "mission/port/breakage.h"
#include "mission/port/power_port.h"
#include "route/cost/leg_request.h"

namespace lsos {

// The state at the last exchange. Field names are those of the script API.
struct RoverView {
  std::string id;
  std::string type;
  Vec3 p_S_m = Vec3::Zero();  // reference point, site frame
  double lon_rad = 0, lat_rad = 0, elevation_m = 0;
  double heading_rad = 0, pitch_rad = 0, roll_rad = 0;
  double speed_mps = 0, distance_m = 0, slope_rad = 0;
  double slip = not_modelled, sinkage_m = not_modelled;
  double drive_w = 0, drive_j = 0;
  double cruise_speed_mps = 0;  // the type's default driving speed
  double length_m = 0;          // length of its footprint
  double turning_radius_m = 0;  // the least; 0: it turns on the spot
  double slope_max_rad = std::numeric_limits<double>::infinity();  // that routes are planned over
  bool is_parked = false;
  bool is_adjusting = false;  // its limbs move although it stands
  // On limbs: under the chassis, mean over the wheels as the limbs hold them.
  double clearance_m = not_modelled;
  std::string stance_fault;  // why its limbs, which no longer move, are not in their stance
};

// State of the drive that the last `follow` or `follow_rover` began. Behind another rover,
// `arrived` means that all events of that one have ended.
struct DriveState {
  enum class Status { none, driving, arrived, failed };
  Status status = Status::none;
  std::string reason;           // why it failed
  double remaining_m = 0;       // along the path; behind another rover, to where that is
  bool is_blocked = false;      // it failed because of what lies ahead: ground, another rover
  std::string blocked_by = {};  // the rover or asset that it would have touched, "": none
  std::size_t next_point = 0;   // index of the path point it drives to, from 0
  bool is_backward = false;     // it backs up, or did when it ended
};

struct FollowSettings {
  std::optional<double> speed_mps;  // absent: the rover's cruise speed
  double arrival_radius_m = 1;
  bool is_crabbing = false;  // along the path without turning into it, if the rover can
  // Points of the path, ascending, at which the rover changes between forwards and backwards; 0: it
  // begins backwards.
  std::vector<std::size_t> gear_changes = {};
  // Before another rover it ends so early that it still has room to turn on the spot there, to go
  // round it on another path.
  bool keeps_room_to_turn = false;
  // Greatest cross-track error; beyond it the drive fails.
  double cross_track_max_m = std::numeric_limits<double>::infinity();
  // Steepest slope under its wheels that it was planned over; it warns where it meets a steeper
  // one.
  double slope_max_rad = std::numeric_limits<double>::infinity();
};

// Kept free between two bodies, of which one follows the other, at the end of braking; a drive ends
// before they would touch.
inline constexpr double pursuit_clearance_m = 0.5;

struct PursuitSettings {
  std::string leader_id;
  double distance_m = 20;           // that it keeps to the leader, along the leader's track
  std::optional<double> speed_mps;  // the greatest; absent: the rover type's
};

// Requirements on a planned route.
struct RouteSettings {
  std::optional<double> speed_mps;      // absent: the rover's cruise speed
  std::optional<double> slope_max_rad;  // besides the rover's own limit
  RouteAim aim = RouteAim::energy;
  double arrival_radius_m = 1;  // a first waypoint within this, at most 1 m, is passed
  std::vector<AvoidedDisc> avoided = {};
  std::vector<std::string> around = {};  // ids of rovers that it goes round where they are now
  std::vector<Obstacle> standing = {};   // these rovers; not for scripts to say

  bool operator==(const RouteSettings&) const = default;
};

// A route through waypoints, with a leg to each.
struct PlannedRoute {
  struct Leg {
    std::int64_t waypoint = 0;   // number of the waypoint it leads to, from 1
    std::size_t last_point = 0;  // index of its last point in the path
    double length_m = 0, duration_s = 0, energy_j = 0, slope_max_rad = 0;
  };
  Path3 path_S_m;
  std::vector<std::size_t> gear_changes;  // FollowSettings::gear_changes for this path
  std::vector<Leg> legs;
  // Why there is no route, "" when there is one; and the reachable place nearest to the goal, when
  // it is known.
  std::string reason;
  std::optional<Vec3> nearest_S_m;

  bool is_found() const { return reason.empty(); }
};

// Line of sight and link to another antenna, see the log's layer `pairs`.
struct PairSight {
  bool is_visible = false, is_linked = false;
  double fraction = not_modelled;  // of the disc of Earth that is visible
};

// The ground at a place.
struct GroundView {
  Vec3 p_S_m = Vec3::Zero();
  double elevation_m = 0;  // raster datum
  double slope_rad = 0;    // slope of the surface at this very point
  std::string soil;
};

// Directions of Sun and Earth at a rover, at the last exchange: azimuth clockwise from true north,
// elevation above the horizontal plane. NaN: there is none.
struct SkyView {
  double sun_azimuth_rad = not_modelled, sun_elevation_rad = not_modelled;
  double earth_azimuth_rad = not_modelled, earth_elevation_rad = not_modelled;
};

// A stance to change to: by name, or by the height of the chassis' underside over the ground.
struct PostureRequest {
  std::optional<std::string> stance = {};
  std::optional<double> height_m = {};
  std::optional<bool> is_level = {};      // absent: as the stance says, else true
  std::optional<double> duration_s = {};  // absent: as fast as the joints turn
};

class RoverPort {
 public:
  virtual ~RoverPort() = default;

  virtual const RoverView& view() const = 0;
  virtual DriveState drive_state() const = 0;

  // Drives along waypoints (site frame), beginning with the first; replaces the path it was
  // following.
  virtual void follow(const Path3& path_S_m, const FollowSettings& settings) = 0;
  // Drives behind another rover, along the track of that one, until all its events have ended.
  // Stands while it is near enough. Throws std::runtime_error when there is no such rover.
  virtual void follow_rover(const PursuitSettings& settings) = 0;
  // Plans a route from the rover through waypoints `first`, `first` + 1, ... (the first of all is
  // 1). Legs planned for the event before the start are taken up.
  virtual PlannedRoute plan_path(const Path3& waypoints_S_m, std::int64_t first,
                                 const RouteSettings& settings) = 0;
  // Place on the ground `distance_m` ahead of the rover.
  virtual Vec3 ahead_S_m(double distance_m) const = 0;
  // Ground under or over a place of the site; absent: there is none.
  virtual std::optional<GroundView> ground_at(const Vec3& p_S_m) const = 0;
  virtual SkyView sky() const = 0;
  // Position of another rover or an asset, on the ground; absent: nothing has that id.
  virtual std::optional<Vec3> place_of_S_m(const std::string& id) const = 0;
  // Result of the last evaluation of the line of sight to another rover, an asset or Earth; absent:
  // there was none yet, or nothing has that id.
  virtual std::optional<PairSight> sight_of(const std::string& id) const = 0;
  // Stops and holds the rover.
  virtual void brake() = 0;
  virtual PowerPort& power() = 0;
  // Raises or stows the antenna with that name, "" for all stowable ones. Throws std::runtime_error
  // when there is no such antenna, EquipmentFault when it cannot be stowed.
  virtual Deployment deploy_antenna(const std::string& antenna, bool up,
                                    std::optional<double> duration_s) = 0;
  // Begins to move the limbs into another stance and returns the time that it takes, s. Throws
  // std::runtime_error for a stance that there is not, EquipmentFault for what limbs cannot do.
  virtual double set_posture(const PostureRequest& request) = 0;
  // Something of the rover breaks, or works again, from this exchange on, with a note and, when it
  // breaks, a warning. Throws EquipmentFault for what the rover does not have, and for a mode or
  // share that does not fit.
  virtual void break_part(const Breakage& breakage) = 0;
  // Writes a row in `notes`. `fields_json`: a JSON object with sorted keys.
  virtual void note(const std::string& name, const std::string& fields_json) = 0;
  // Adds a warning to the summary and report of the run.
  virtual void warn(const std::string& text) = 0;
};

}  // namespace lsos
