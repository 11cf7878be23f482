#include "mission/fleet/rover_result.h"

#include <algorithm>

namespace lsos {

RoverResult result_of(const FleetRover& rover) {
  const RoverAgent& agent = *rover.agent;
  RoverResult result;
  result.id = agent.id();
  result.distance_m = agent.view().distance_m;
  for (const EventRecord& record : rover.sequence.records().all()) {
    if (record.ready && record.end) {
      result.duration_s = std::max(result.duration_s, seconds(*record.end));
    }
  }
  const RoverTally& tally = agent.tally();
  result.drive_s = tally.drive_s();
  result.elevation_gain_m = tally.elevation_gain_m();
  result.slope_max_rad = tally.slope_max_rad();
  const DriveSlip& slip = agent.drive().slip();
  result.slip_greatest = slip.greatest();
  result.slip_p95 = slip.p95();
  result.slip_rolling = slip.greatest_rolling();
  result.driven_s = slip.driven_s();
  result.mean_mps = slip.mean_mps();
  result.mean_requested_mps = slip.mean_requested_mps();
  const RoverPower& power = agent.power();
  if (power.has_battery()) {
    result.energy_start_j = power.energy_at_start_j();
    result.energy_end_j = power.account().energy_j;
    result.energy_used_j = power.energy_used_j();
    result.solar_j = power.solar_j();
    result.external_j = power.view().external_j;
  }
  result.resources = power.resources();
  return result;
}

}  // namespace lsos
