#include "route/cost/stance_drive.h"

#include <algorithm>
#include <cmath>

#include "driving/side_slip.h"
#include "driving/slope_speed.h"

namespace lsos {

namespace {

// Distance in which a rover whose speed side slip limits changes it by a standard deviation of
// v^2 / 2. Fitted to the energy of SEV and LRV on LunarSouthPole (RoughGround, PlannedTurns).
constexpr double speed_change_m = 14;

// Speed where side slip limits it: its mean, and the standard deviation of v^2 / 2.
struct LimitedSpeed {
  double mean_mps = 0, spread_m2ps2 = 0;
};

// The cross slope varies on rough ground, and with it the side slip angle. The time per metre and
// v^2 / 2 are taken over a normal distribution, by Gauss and Hermite's rule of three nodes.
LimitedSpeed side_slip_limited(const SlopeDrive& drive, const Stance& stance,
                               const DriveCost& cost) {
  const double bank = std::sin(stance.bank_rad);
  const double away = std::sqrt(3.0) * cost.rough_tilt_1pm * stance.roughness_m;
  const auto limited_mps = [&](double tilt) {
    const double slip_rad =
        side_slip_rad(cost.gravity_mps2 * tilt, drive.side_slip_s2pm, drive.side_grip_mps2);
    return std::min(drive.speed_mps, side_slip_speed_mps(slip_rad));
  };
  const double least_mps = limited_mps(std::abs(bank) + away);
  if (least_mps >= drive.speed_mps) return {drive.speed_mps, 0};
  const double middle_mps = limited_mps(bank), most_mps = limited_mps(std::abs(bank) - away);
  const auto mean = [](double middle, double low, double high) {
    return (4 * middle + low + high) / 6;
  };
  const auto half_square = [](double v) { return v * v / 2; };
  const double low = half_square(least_mps), middle = half_square(middle_mps),
               high = half_square(most_mps);
  const double of_all = mean(middle, low, high);
  const double variance = mean(middle * middle, low * low, high * high) - of_all * of_all;
  return {1 / mean(1 / middle_mps, 1 / least_mps, 1 / most_mps),
          std::sqrt(std::max(0.0, variance))};
}

// Adds what uneven loads take of energy on this slope, and as many times the time.
void count_uneven_loads(SlopeDrive& drive, const SoilDrive& soil, double pitch_rad, double share) {
  if (share <= 0 || soil.uneven.empty()) return;
  const SlopeDrive even = soil.at(pitch_rad), uneven = soil.at(pitch_rad, share);
  drive.energy_jpm += uneven.energy_jpm - even.energy_jpm;
  drive.lost_jpm += uneven.lost_jpm - even.lost_jpm;
  drive.spare_jpm = std::max(0.0, drive.spare_jpm + uneven.spare_jpm - even.spare_jpm);
  drive.speed_mps *= uneven.speed_mps / even.speed_mps;
  drive.slip += uneven.slip - even.slip;
}

}  // namespace

// Soil holds a rover up a slope by slipping downhill, whatever the heading. Slip across the route
// costs a share `across` of what slip along it costs (from MER, Husky and SEV, driven across 10
// degrees). Without it climbing in zigzags would slip less and cost less, which it does not.
SlopeDrive stance_drive(const DriveCost& cost, const Stance& stance) {
  constexpr double across = 0.35, none_rad = 0.01;
  const SoilDrive& soil = cost.soils[static_cast<std::size_t>(stance.soil)];
  SlopeDrive drive = soil.at(stance.pitch_rad);
  double more_jpm = 0;  // what gravity's spare energy covers first
  const bool is_up = stance.pitch_rad > 0;
  const double held_rad = is_up ? stance.slope_rad : std::abs(stance.bank_rad);
  if (held_rad > std::max(0.0, stance.pitch_rad) + none_rad) {
    const SlopeDrive held = soil.at(held_rad), level = is_up ? drive : soil.at(0);
    const double uphill = is_up ? stance.pitch_rad / held_rad : 0;
    const double share = uphill * uphill + across * (1 - uphill * uphill);
    more_jpm = share * std::max(0.0, held.energy_jpm * held.slip - level.energy_jpm * level.slip);
    // Wheels roll along the route and up the slope; where they brake, the rover moves faster.
    const double slid = held.slip / std::max(0.05, 1 - held.slip);
    const double rolling_mps = soil.rolling_speed_mps(), rolled = rolling_mps / drive.speed_mps;
    const double along = is_up ? std::max(rolled, 1 + slid * uphill) : rolled;
    const double aside = across * slid;
    drive.speed_mps =
        rolling_mps / std::sqrt(along * along + aside * aside * (1 - uphill * uphill));
  }
  count_uneven_loads(drive, soil, stance.pitch_rad, cost.uneven_share_at(stance.roughness_m));
  // `braked_mps` limits the rim speed; the rover moves faster than its rims by the slip in the
  // table.
  const double braked_mps =
      slope_speed_mps({stance.pitch_rad, stance.bank_rad}, cost.level_speed_mps,
                      cost.acceleration_mps2, cost.gravity_mps2);
  drive.speed_mps *= std::min(1.0, braked_mps / cost.speed_mps);
  const LimitedSpeed limited = side_slip_limited(drive, stance, cost);
  drive.speed_mps = limited.mean_mps;
  // The resistance X of bumps comes in bursts. Distributed exponentially about its mean m =
  // more_jpm, it exceeds gravity's spare energy s by E[max(0, X - s)] = m exp(-s / m) in the mean.
  more_jpm += cost.rough_jspm3 * drive.speed_mps * stance.roughness_m;
  // A rover that keeps slowing down for side slip loses in its brakes what its drag does not take.
  const double drag_mps2 = (drive.energy_jpm - drive.lost_jpm) / cost.speeding_kg;
  more_jpm += cost.speeding_kg * limited.spread_m2ps2 / speed_change_m *
              std::max(0.0, 1 - drag_mps2 / cost.acceleration_mps2);
  if (more_jpm > 0) drive.energy_jpm += more_jpm * std::exp(-drive.spare_jpm / more_jpm);
  drive.energy_jpm += cost.idle_w / drive.speed_mps;
  return drive;
}

}  // namespace lsos
