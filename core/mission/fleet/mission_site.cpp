#include "mission/fleet/mission_site.h"

#include <fmt/format.h>

#include <algorithm>

#include "mission/model/site.h"
#include "planet/ellipsoid.h"
#include "vehicle/wheel_soil.h"

namespace lsos {

namespace {

// Why one of the rover's wheels bears no such load, or a soil of the ground does not bear it; ""
// when all do.
std::string bearing_fault(const VehicleConfig& vehicle, const Ground& ground, double gravity_mps2) {
  const auto wheels = std::ranges::count_if(
      vehicle.links, [](const LinkConfig& link) { return link.wheel.has_value(); });
  const double load_n = vehicle.mass_kg() * gravity_mps2 / static_cast<double>(wheels);
  for (const LinkConfig& link : vehicle.links) {
    if (!link.wheel) continue;
    if (std::string fault = carcass_fault(*link.wheel, load_n); !fault.empty()) return fault;
    for (const Soil& soil : ground.soils()) {
      std::string fault = soil_fault(soil, *link.wheel, load_n, gravity_mps2);
      if (!fault.empty()) return fault;
    }
  }
  return "";
}

}  // namespace

MissionSite make_site(const SimulationSetup& setup) {
  const MissionInfo& mission = setup.plan.mission;
  LSOS_ASSERT(!setup.plan.rovers.empty());
  MissionSite site;
  site.ground = mission_ground(setup.terrain, setup.plan);
  const double g_mps2 = gravity_mps2(*mission.planet, site.ground->site().origin());
  for (const PlanRover& rover : setup.plan.rovers) {
    site.vehicles[{rover.model(), rover.configuration}] =
        make_vehicle(setup.rover_models.at(rover.model()).spec, rover.configuration, g_mps2);
  }
  Faults faults;
  for (const PlanRover& rover : setup.plan.rovers) {
    const std::string fault = bearing_fault(site.vehicle(rover), *site.ground, g_mps2);
    if (!fault.empty()) {
      faults.error(rover.place, fmt::format("Rover '{}': {}", rover.id, fault));
    }
  }
  faults.throw_if_errors();
  site.legs = std::make_unique<PlannedLegs>(*site.ground, mission.seed);
  site.legs->recall(setup.cached_legs);
  return site;
}

std::vector<StandingAsset> place_assets(const SimulationSetup& setup, MissionSite& site) {
  Faults faults;
  std::vector<StandingAsset> assets;
  std::vector<Obstacle> standing;
  for (const PlanAsset& asset : setup.plan.assets) {
    try {
      assets.push_back(place_asset(asset, setup.asset_models.at(asset.type), *site.ground));
    } catch (const InputError& error) {
      faults.add(error.faults());
      continue;
    }
    if (assets.back().gives_power()) {
      site.sources.push_back({asset.id, assets.back().pose.p_S_m});
    }
    const std::vector<Obstacle> more = assets.back().obstacles();
    standing.insert(standing.end(), more.begin(), more.end());
  }
  site.legs->set_standing(std::move(standing));
  faults.throw_if_errors();
  return assets;
}

std::vector<std::string> vehicle_assumptions(const MissionSite& site) {
  std::vector<std::string> assumptions;
  for (const auto& [key, vehicle] : site.vehicles) {
    for (const std::string& assumption : vehicle.assumptions) {
      if (std::ranges::find(assumptions, assumption) == assumptions.end()) {
        assumptions.push_back(assumption);
      }
    }
  }
  return assumptions;
}

}  // namespace lsos
