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
  return {low.slip + share * (high.slip - low.slip),
          low.energy_jpm + share * (high.energy_jpm - low.energy_jpm),
          low.speed_mps + share * (high.speed_mps - low.speed_mps),
          low.spare_jpm + share * (high.spare_jpm - low.spare_jpm),
          low.lost_jpm + share * (high.lost_jpm - low.lost_jpm)};
}

double DriveCost::level_jpm() const {
  const SoilDrive& soil = soils.front();
  if (soil.by_slope.empty()) return 0;
  const SlopeDrive level = soil.at(0);
  return level.energy_jpm + idle_w / level.speed_mps;
}

}  // namespace lsos
