// What a mission stands on: the ground, the vehicles as gravity there settles them, the assets that
// give power, and the legs that are planned on that ground.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "mission/fleet/simulation_setup.h"
#include "mission/routes/planned_legs.h"
#include "mission/rover/rover_power.h"
#include "mission/rover/standing_asset.h"

namespace lsos {

struct MissionSite {
  std::unique_ptr<Ground> ground;
  // Vehicles with links; key: PlanRover::model() and RoverConfig.
  std::map<std::pair<std::string, std::string>, VehicleConfig> vehicles;
  std::unique_ptr<PlannedLegs> legs;
  std::vector<PowerSource> sources;

  const VehicleConfig& vehicle(const PlanRover& rover) const {
    return vehicles.at({rover.model(), rover.configuration});
  }
};

// Throws InputError when the plan does not fit the terrain, or a soil does not bear a rover.
MissionSite make_site(const SimulationSetup& setup);

// Places the plan's assets on the ground; planned legs go round them. Throws InputError when the
// terrain at one is not known.
std::vector<StandingAsset> place_assets(const SimulationSetup& setup, MissionSite& site);

// What the vehicles' scripts assume; configurations of one type share it.
std::vector<std::string> vehicle_assumptions(const MissionSite& site);

}  // namespace lsos
