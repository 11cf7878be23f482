#include "route/cost/drive_cost.h"

#include <algorithm>
#include <cmath>

namespace lsos {

namespace {

SlopeDrive between(const SlopeDrive& low, const SlopeDrive& high, double share) {
  const auto value = [&](double SlopeDrive::*of) { return std::lerp(low.*of, high.*of, share); };
  return {value(&SlopeDrive::slip),          value(&SlopeDrive::energy_jpm),
          value(&SlopeDrive::speed_mps),     value(&SlopeDrive::spare_jpm),
          value(&SlopeDrive::lost_jpm),      value(&SlopeDrive::side_slip_s2pm),
          value(&SlopeDrive::side_grip_mps2)};
}

// Energy and time of a metre, and what wheels roll for it, add up: `share` may be above 1, as
// `uneven` is the worse in each.
SlopeDrive partly(const SlopeDrive& even, const SlopeDrive& uneven, double share) {
  const auto added = [&](double one, double other) { return one + share * (other - one); };
  SlopeDrive drive = even;
  drive.energy_jpm = added(even.energy_jpm, uneven.energy_jpm);
  drive.lost_jpm = added(even.lost_jpm, uneven.lost_jpm);
  drive.spare_jpm = std::max(0.0, added(even.spare_jpm, uneven.spare_jpm));
  drive.speed_mps = 1 / added(1 / even.speed_mps, 1 / uneven.speed_mps);
  drive.slip = 1 - 1 / added(1 / (1 - even.slip), 1 / (1 - uneven.slip));
  drive.side_slip_s2pm = added(even.side_slip_s2pm, uneven.side_slip_s2pm);
  drive.side_grip_mps2 = 1 / added(1 / even.side_grip_mps2, 1 / uneven.side_grip_mps2);
  return drive;
}

SlopeDrive row_at(const std::vector<SlopeDrive>& rows, double steps) {
  if (rows.size() < 2) return rows.empty() ? SlopeDrive{} : rows.front();
  steps = std::clamp(steps, 0.0, static_cast<double>(rows.size() - 1));
  const auto k = std::min(static_cast<std::size_t>(steps), rows.size() - 2);
  return between(rows[k], rows[k + 1], steps - static_cast<double>(k));
}

}  // namespace

SlopeDrive SoilDrive::at(double slope_rad) const {
  return row_at(by_slope, (slope_rad - first_rad) / step_rad);
}

SlopeDrive SoilDrive::at(double slope_rad, double uneven_share) const {
  if (uneven.empty()) return at(slope_rad);
  return partly(at(slope_rad), row_at(uneven, (slope_rad - first_rad) / step_rad), uneven_share);
}

double DriveCost::level_jpm() const {
  const SoilDrive& soil = soils.front();
  if (soil.by_slope.empty()) return 0;
  const SlopeDrive level = soil.at(0);
  return level.energy_jpm + idle_w / level.speed_mps;
}

}  // namespace lsos
