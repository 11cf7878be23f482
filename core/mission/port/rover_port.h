// A rover as scripts see it: what it is now, and what they may tell it to do. Commands take
// effect in the following exchange period.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/sim_time.h"
#include "base/vector.h"
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
  double length_m = 0;          // of the ground that it covers
  double turning_radius_m = 0;  // the least; 0: it turns on the spot
  bool is_parked = false;
};

// What became of the last `follow`.
struct DriveState {
  enum class Status { none, driving, arrived, failed };
  Status status = Status::none;
  std::string reason;          // why it failed
  double remaining_m = 0;      // along the path
  bool is_blocked = false;     // it failed because of what lies ahead: ground, another rover
  std::size_t next_point = 0;  // of the path, that it drives to; 0 is the first
};

struct FollowSettings {
  std::optional<double> speed_mps;  // absent: the rover's cruise speed
  double arrival_radius_m = 1;
  bool is_crabbing = false;  // along the path without turning into it, if the rover can
  // Farther than this from the path the drive fails.
  double stray_max_m = std::numeric_limits<double>::infinity();
};

// What a planned way keeps to.
struct RouteSettings {
  std::optional<double> speed_mps;      // absent: the rover's cruise speed
  std::optional<double> slope_max_rad;  // besides the rover's own limit
  RouteAim aim = RouteAim::energy;
  double arrival_radius_m = 1;  // a first waypoint that is this near, 1 m at most, is passed
  std::vector<AvoidedDisc> avoided = {};

  bool operator==(const RouteSettings&) const = default;
};

// A way through some waypoints, a leg to each.
struct PlannedWay {
  struct Leg {
    std::int64_t waypoint = 0;   // that it leads to, the first is 1
    std::size_t last_point = 0;  // of the path
    double length_m = 0, duration_s = 0, energy_j = 0, slope_max_rad = 0;
  };
  Path3 path_S_m;
  std::vector<Leg> legs;
  // Why there is none, "" when there is one; and how far it is to be had, where that is known.
  std::string reason;
  std::optional<Vec3> nearest_S_m;

  bool is_found() const { return reason.empty(); }
};

// What a rover's antenna has of another: see the log's layer `pairs`.
struct PairSight {
  bool is_visible = false, is_linked = false;
};

// The ground at a place.
struct GroundView {
  Vec3 p_S_m = Vec3::Zero();
  double elevation_m = 0;  // raster datum
  double slope_rad = 0;    // of its very surface there
  std::string soil;
};

// Where Sun and Earth stand at a rover, at the last exchange: azimuth clockwise from true north,
// elevation above the plane across the vertical. NaN: there is none.
struct SkyView {
  double sun_azimuth_rad = not_modelled, sun_elevation_rad = not_modelled;
  double earth_azimuth_rad = not_modelled, earth_elevation_rad = not_modelled;
};

class RoverPort {
 public:
  virtual ~RoverPort() = default;

  virtual const RoverView& view() const = 0;
  virtual DriveState drive() const = 0;

  // Drive along waypoints (site frame), beginning with the first; replaces what it was following.
  virtual void follow(const Path3& path_S_m, const FollowSettings& settings) = 0;
  // A way over the ground from where the rover is through waypoints `first`, `first` + 1, ... (the
  // first of all is 1). What was planned for the event when the mission was made is taken up.
  virtual PlannedWay plan_path(const Path3& waypoints_S_m, std::int64_t first,
                               const RouteSettings& settings) = 0;
  // The place so far ahead of the rover, on the ground.
  virtual Vec3 ahead_S_m(double distance_m) const = 0;
  // Under or over a place of the site; absent: there is no ground.
  virtual std::optional<GroundView> ground_at(const Vec3& p_S_m) const = 0;
  virtual SkyView sky() const = 0;
  // Of another rover or an asset, on the ground; absent: there is none with that id.
  virtual std::optional<Vec3> place_of_S_m(const std::string& id) const = 0;
  // What the last look at another rover, an asset or Earth found; absent: there was none yet, or
  // nothing has that id.
  virtual std::optional<PairSight> sight_of(const std::string& id) const = 0;
  // Stop and hold.
  virtual void brake() = 0;
  virtual PowerPort& power() = 0;
  // Raises or stows the antenna with that name, "" for all that can be. Throws std::runtime_error
  // where none has the name, EquipmentFault for what cannot be.
  virtual Deployment deploy_antenna(const std::string& antenna, bool up,
                                    std::optional<double> duration_s) = 0;
  // A row in `notes`. `fields_json`: an object with sorted keys.
  virtual void note(const std::string& name, const std::string& fields_json) = 0;
  // A warning of the run, for its summary and report.
  virtual void warn(const std::string& text) = 0;
};

}  // namespace lsos
