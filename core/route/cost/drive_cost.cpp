#include "route/cost/drive_cost.h"

#include <algorithm>

namespace lsos {

SlopeDrive SoilDrive::at(double slope_rad) const {
  if (by_slope.size() < 2) return by_slope.empty() ? SlopeDrive{} : by_slope.front();
  const double steps =
      std::clamp((slope_rad - first_rad) / step_rad, 0.0, static_cast<double>(by_slope.size() - 1));
  const auto k = std::min(static_cast<std::size_t>(steps), by_slope.size() - 2);
  const double share = steps - static_cast<double>(k);
  const SlopeDrive &low = by_slope[k], &high = by_slope[k + 1];
  const auto between = [&](double SlopeDrive::*value) {
    return low.*value + share * (high.*value - low.*value);
  };
  return {between(&SlopeDrive::slip),          between(&SlopeDrive::energy_jpm),
          between(&SlopeDrive::speed_mps),     between(&SlopeDrive::spare_jpm),
          between(&SlopeDrive::lost_jpm),      between(&SlopeDrive::side_slip_s2pm),
          between(&SlopeDrive::side_grip_mps2)};
}

double DriveCost::level_jpm() const {
  const SoilDrive& soil = soils.front();
  if (soil.by_slope.empty()) return 0;
  const SlopeDrive level = soil.at(0);
  return level.energy_jpm + idle_w / level.speed_mps;
}

}  // namespace lsos
