// What a rover script says.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/error.h"
#include "vehicle/suspension/rocker_bogie.h"
#include "vehicle/suspension/skid_steer.h"
#include "vehicle/suspension/wishbone.h"

namespace lsos {

using Suspension = std::variant<Wishbone, RockerBogie, SkidSteer>;

// What a plan's RoverConfig may name: how the vehicle stands and is loaded when it starts.
struct RoverConfiguration {
  std::string name = {};
  std::string doc = {};
  std::map<std::string, double> joints = {};  // m or rad, by joint; the others stand at 0
  std::vector<std::string> free_wheels = {};  // by wheel: turns without motor and brake
  std::vector<std::string> locked_wheels = {};
  double payload_mass_kg = 0;  // on the chassis, besides its own; negative takes load off
  Vec3 p_BP_m = Vec3::Zero();  // of the payload's centre of mass
  std::optional<std::int64_t> crew = {};  // aboard; absent: as many as the rover carries
};

struct RoverSpec {
  std::string name = {};
  std::string doc = {};
  Place place = {};
  VehicleConfig vehicle;  // without links: the template adds them at the site's gravity
  Suspension suspension;
  std::vector<RoverConfiguration> configurations = {};
};

// The whole vehicle in one of its configurations ("": as the template makes it).
VehicleConfig make_vehicle(const RoverSpec& spec, const std::string& configuration,
                           double gravity_mps2);

// What does not fit together in a script ("wheel_offsets_m is empty"), one sentence each; empty
// when all is well.
std::vector<std::string> vehicle_faults(const RoverSpec& spec);

}  // namespace lsos
