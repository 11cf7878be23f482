// A rover as scripts see it: what it is now, and what they may tell it to do. Commands take
// effect in the following exchange period.
#pragma once

#include <optional>
#include <string>

#include "base/sim_time.h"
#include "base/vector.h"
#include "mission/power_port.h"

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
  bool is_parked = false;
};

// What became of the last `follow`.
struct DriveState {
  enum class Status { none, driving, arrived, failed };
  Status status = Status::none;
  std::string reason;      // why it failed
  double remaining_m = 0;  // along the path
};

struct FollowSettings {
  std::optional<double> speed_mps;  // absent: the rover's cruise speed
  double arrival_radius_m = 1;
  bool is_crabbing = false;  // along the path without turning into it, if the rover can
};

class RoverPort {
 public:
  virtual ~RoverPort() = default;

  virtual const RoverView& view() const = 0;
  virtual DriveState drive() const = 0;

  // Drive along waypoints (site frame), beginning with the first; replaces what it was following.
  virtual void follow(const Path3& path_S_m, const FollowSettings& settings) = 0;
  // Stop and hold.
  virtual void brake() = 0;
  virtual PowerPort& power() = 0;
  // Raises or stows the antenna with that name, "" for all that can be. Answers how long that
  // takes, s. Throws std::runtime_error for what cannot be.
  virtual double deploy_antenna(const std::string& antenna, bool up,
                                std::optional<double> duration_s) = 0;
  // A row in `notes`. `fields_json`: an object with sorted keys.
  virtual void note(const std::string& name, const std::string& fields_json) = 0;
};

}  // namespace lsos
