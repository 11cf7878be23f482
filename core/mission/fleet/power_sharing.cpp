#include "mission/fleet/power_sharing.h"

#include <algorithm>

namespace lsos {

void share_power(Fleet& fleet, FleetSunlight* sunlight, const Moment& moment) {
  for (StandingAsset& asset : fleet.assets) {
    const auto takes = [&](const FleetRover& rover) {
      return rover.agent->power().plugged_into() == asset.plan.id;
    };
    if (std::ranges::none_of(fleet.rovers, takes)) {
      asset.sun.reset();
      continue;
    }
    if (!asset.model.panels.empty()) sunlight->update(asset, fleet, moment);
    double left_w = asset.supply_w();
    for (FleetRover& rover : fleet.rovers) {
      if (!takes(rover)) continue;
      const double given_w = rover.agent->accepted_w(left_w);
      rover.agent->power().set_given(given_w);
      left_w = std::max(0.0, left_w - given_w);
    }
  }
}

}  // namespace lsos
