// The contents of a rover script.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/error.h"
#include "vehicle/suspension/legged.h"
#include "vehicle/suspension/rocker_bogie.h"
#include "vehicle/suspension/skid_steer.h"
#include "vehicle/suspension/wishbone.h"

namespace lsos {

using Suspension = std::variant<Wishbone, RockerBogie, SkidSteer, Legged>;

// A configuration that a plan's RoverConfig may name: state and load of the vehicle at the start.
struct RoverConfiguration {
  std::string name = {};
  std::string doc = {};
  std::map<std::string, double> joints = {};  // m or rad, by joint; the others are at 0
  // On limbs, for a stance: height of the chassis' underside over the ground, with the wheels where
  // `joints` put them; and whether posture control keeps the chassis level.
  std::optional<double> height_m = {};
  bool is_level = true;
  std::vector<std::string> free_wheels = {};  // by wheel: turns without motor and brake
  std::vector<std::string> locked_wheels = {};
  double payload_mass_kg = 0;  // on the chassis, in addition to its mass; negative removes mass
  Vec3 p_BP_m = Vec3::Zero();  // centre of mass of the payload
  std::optional<std::int64_t> crew = {};  // people on board; absent: as many as the rover carries
};

// Whether a rover on limbs can change to it: a configuration that also loads the rover or sets
// modes of its wheels is one to start in.
bool is_stance(const RoverConfiguration& configuration);

struct RoverSpec {
  std::string name = {};
  std::string doc = {};
  Place place = {};
  VehicleConfig vehicle;  // without links, which the template adds for the site's gravity
  Suspension suspension;
  std::vector<RoverConfiguration> configurations = {};
};

// The whole vehicle in one of its configurations ("": as the template builds it).
VehicleConfig make_vehicle(const RoverSpec& spec, const std::string& configuration,
                           double gravity_mps2);

// Inconsistencies in a script ("wheel_offsets_m is empty"), one sentence each; empty if there are
// none.
std::vector<std::string> vehicle_faults(const RoverSpec& spec);

}  // namespace lsos
