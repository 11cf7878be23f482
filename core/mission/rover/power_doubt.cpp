// What an estimate does not know of a rover's loads.
#include <cmath>

#include "mission/rover/rover_power.h"

namespace lsos {

LoadDoubt RoverPower::load_doubt(bool is_dark, bool is_parked) const {
  if (!has_battery()) return {};
  PowerDemand other = demand_;
  other.load_w +=
      load_w(spec_.loads, {is_dark, is_parked}) - load_w(spec_.loads, {!is_dark, is_parked});
  const PowerFlows now = flows();
  const PowerFlows then = power_flows(*spec_.battery, account().energy_j, other);
  const auto used_w = [](const PowerFlows& flow) {
    return flow.load_w + flow.drive_w + flow.loss_w;
  };
  return {std::abs(used_w(then) - used_w(now)), std::abs(then.energy_rate_w - now.energy_rate_w)};
}

}  // namespace lsos
