// Queries of rovers and their events about other rovers, assets and the sky.
#include <algorithm>

#include "mission/simulation.h"
#include "planet/sunlight.h"

namespace lsos {

const EventRecord& Simulation::record(const PlanEvent::Reference& event) const {
  for (const Rover& rover : rovers_) {
    if (rover.agent->id() != event.rover_id) continue;
    for (std::size_t i = 0; i < rover.sequence.events().size(); ++i) {
      if (rover.sequence.events()[i].event.sequence == event.sequence) {
        return rover.sequence.records()[i];
      }
    }
  }
  throw InternalError("a StartAfter names an event that is not in the plan");
}

std::optional<Vec3> Simulation::place_S_m(const std::string& id) const {
  for (const Rover& rover : rovers_) {
    if (rover.agent->id() == id) return rover.agent->view().p_S_m;
  }
  for (const StandingAsset& asset : assets_) {
    if (asset.plan.id == id) return asset.pose.p_S_m;
  }
  return {};
}

SkyView Simulation::sky(const Geodetic& place) const {
  const Body& body = *setup_.plan.mission.planet;
  const Instant at = setup_.plan.mission.start_time + now_;
  const SkyPosition sun = sunlight(body, place, at, 0).seen;
  const std::optional<SkyPosition> earth = lsos::sky(body, place, at).earth;
  SkyView view{sun.azimuth_rad, sun.elevation_rad, not_modelled, not_modelled};
  if (earth) {
    view.earth_azimuth_rad = earth->azimuth_rad;
    view.earth_elevation_rad = earth->elevation_rad;
  }
  return view;
}

std::optional<PairSight> Simulation::sight(const std::string& id, const std::string& other) const {
  if (!sight_) return {};
  // The order is that of sight_ends(), then Earth.
  std::vector<std::string> ids = rover_ids();
  for (const StandingAsset& asset : assets_) ids.push_back(asset.plan.id);
  ids.emplace_back(earth_id);
  const auto number = [&](const std::string& of) {
    return static_cast<std::size_t>(std::ranges::find(ids, of) - ids.begin());
  };
  return sight_->last(number(id), number(other));
}

}  // namespace lsos
