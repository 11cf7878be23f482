// Shipped rovers on grounds of the test's choice, driven along a path below the machine: nothing
// parks, nothing is logged.
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

// The shipped rover on this ground's planet; `step_share` of its script's step.
VehicleConfig rover_on(const std::string& name, const Ground& ground, const std::string& planet,
                       const std::string& configuration = "", double step_share = 1);

struct DriveResult {
  std::string failure;  // "" when it arrived
  VehicleReport end;
  double distance_m = 0, drive_j = 0, worst_m = 0;  // worst: farthest from the drawn line
  double duration_s = 0;
  WorkDone work;
  double energy_change_j = 0;  // kinetic and potential
};

// Along waypoints from the start (site frame), beginning towards the first.
DriveResult drive(const VehicleConfig& config, const Ground& ground,
                  const std::vector<Vec2>& waypoints_S_m, double speed_mps);

}  // namespace lsos::test
