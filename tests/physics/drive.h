// Shipped rovers on test grounds, driven along a path without the mission layer: nothing parks and
// nothing is logged.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "terrain/ground.h"
#include "vehicle/path_follower.h"
#include "vehicle/suspension/rover_spec.h"
#include "vehicle/vehicle.h"

namespace lsos::test {

inline const Geodetic start{0.1, 0.2, 0};

Soil shipped_soil(const std::string& name);
RoverSpec shipped_rover(const std::string& name);
TerrainSpec shipped_terrain(const std::string& name);

struct GroundAt {
  std::string planet;
  Surface surface;
  std::string soil;
  std::optional<Detail> detail = std::nullopt;
};
std::unique_ptr<Ground> ground(const GroundAt& at);

// The shipped rover in this planet's gravity; its script's step is multiplied by `step_share`.
VehicleConfig rover_on(const std::string& name, const Ground& ground, const std::string& planet,
                       const std::string& configuration = "", double step_share = 1);

struct DriveResult {
  std::string failure;  // "" when the rover arrived
  VehicleReport end;
  double distance_m = 0, drive_j = 0, worst_m = 0;  // worst: greatest distance to the path
  double duration_s = 0;
  WorkDone work;
  double energy_change_j = 0;  // kinetic and potential
};

// Drives along waypoints (site frame) from the start, heading for the first one initially.
DriveResult drive(const VehicleConfig& config, const Ground& ground,
                  const std::vector<Vec2>& waypoints_S_m, double speed_mps);

}  // namespace lsos::test
