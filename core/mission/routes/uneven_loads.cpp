#include "mission/routes/uneven_loads.h"

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "route/cost/stance.h"

namespace lsos {

namespace {

constexpr double hurst = 0.7;
// Slip with uneven loads over that with even ones, fitted to SEV on rough planes of -3 to 14
// degrees (the test RoughPlanes says how well), and the most that it comes to.
constexpr double uneven_slip = 1.5, uneven_slip_most = 0.9;
// The most that uneven loads multiply energy by on slopes that only all wheels climb, and what they
// do where half of the wheels climb none.
constexpr double steep_most = 3, unknown = 2;

// Wheels on one axle, or one wheel.
struct Carrier {
  int parent = -1;
  std::vector<std::size_t> wheels;  // in the order of DriveCost::wheels_B_m
  const Wheel* wheel = nullptr;
};

std::vector<Carrier> carriers_of(const VehicleConfig& vehicle,
                                 const std::vector<Vec2>& wheels_B_m) {
  std::vector<Carrier> carriers;
  std::size_t wheel = 0;
  for (const LinkConfig& link : vehicle.links) {
    if (!link.wheel) continue;
    const Vec2& at_B_m = wheels_B_m[wheel];
    // Wheels that the chassis or a bogie carries side by side stand on no common axle.
    const auto shares_axle = [&](const Carrier& other) {
      return link.parent >= 0 && other.parent == link.parent &&
             std::abs(wheels_B_m[other.wheels.front()].x() - at_B_m.x()) < link.wheel->radius_m;
    };
    auto found = std::ranges::find_if(carriers, shares_axle);
    if (found == carriers.end()) {
      carriers.push_back({link.parent, {}, &*link.wheel});
      found = carriers.end() - 1;
    }
    found->wheels.push_back(wheel++);
  }
  return carriers;
}

// Stiffness of what bears a carrier, its wheels included, N/m; 0 where it turns freely.
double stiffness_npm(const VehicleConfig& vehicle, const Carrier& carrier) {
  double yields_mpn =
      1 / (static_cast<double>(carrier.wheels.size()) * carrier.wheel->normal_stiffness_npm);
  for (int link = carrier.parent; link >= 0;
       link = vehicle.links[static_cast<std::size_t>(link)].parent) {
    const LinkConfig& of = vehicle.links[static_cast<std::size_t>(link)];
    if (of.joint == JointType::prismatic && of.spring && of.spring->stiffness > 0) {
      yields_mpn += 1 / of.spring->stiffness;
    } else if (!of.steering && !of.limb) {
      return 0;
    }
  }
  return 1 / yields_mpn;
}

double wheel_load_n(const VehicleConfig& vehicle, const DriveCost& cost) {
  return vehicle.mass_kg() * cost.gravity_mps2 / static_cast<double>(cost.wheels_B_m.size());
}

// Variance of the difference of height between two places, of a surface whose heights 1 m apart
// differ by a standard deviation of 1 m.
double difference_m2(const Vec2& a_m, const Vec2& b_m) {
  return std::pow((a_m - b_m).norm(), 2 * hurst);
}

// Mean variance of the distance of places on that surface from the plane that fits them best; 0 for
// places that a plane always fits.
double off_plane_m2(const std::vector<Vec2>& at_m) {
  const auto count = static_cast<Eigen::Index>(at_m.size());
  Eigen::MatrixXd places(count, 3), half_differences(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Vec2& one_m = at_m[static_cast<std::size_t>(i)];
    places.row(i) << 1, one_m.x(), one_m.y();
    for (Eigen::Index j = 0; j < count; ++j) {
      half_differences(i, j) = difference_m2(one_m, at_m[static_cast<std::size_t>(j)]) / 2;
    }
  }
  const Eigen::MatrixXd off = Eigen::MatrixXd::Identity(count, count) -
                              places * places.completeOrthogonalDecomposition().pseudoInverse();
  const double sum_m2 = -(off * half_differences * off.transpose()).trace();
  constexpr double rounding = 1e-6;
  const double mean_m2 = half_differences.mean();
  return sum_m2 > rounding * mean_m2 ? sum_m2 / static_cast<double>(count) : 0;
}

// Mean variance of the heights under the wheels of one axle about their mean, on that surface.
double off_axle_m2(const Carrier& carrier, const std::vector<Vec2>& wheels_B_m) {
  double sum_m2 = 0;
  for (std::size_t i = 0; i < carrier.wheels.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      sum_m2 += difference_m2(wheels_B_m[carrier.wheels[i]], wheels_B_m[carrier.wheels[j]]);
    }
  }
  const auto count = static_cast<double>(carrier.wheels.size());
  return sum_m2 / (count * count);
}

// Two halves that bear the load in turn; where all wheels are alike they are the same.
std::array<std::vector<WheelDrive>, 2> halves_of(const std::vector<WheelDrive>& wheels) {
  std::array<std::vector<WheelDrive>, 2> halves;
  std::array<std::size_t, 3> counts{};  // of driven, free and locked wheels
  for (const WheelDrive& wheel : wheels) {
    std::size_t& count = counts[wheel.motor ? 0 : wheel.is_locked ? 2 : 1];
    halves[count++ % 2].push_back(wheel);
  }
  return halves;
}

double mean(double a, double b) { return (a + b) / 2; }

// Each half drives half of the way.
SlopeDrive in_turn(const SlopeDrive& a, const SlopeDrive& b) {
  return {mean(a.slip, b.slip),
          mean(a.energy_jpm, b.energy_jpm),
          1 / mean(1 / a.speed_mps, 1 / b.speed_mps),
          mean(a.spare_jpm, b.spare_jpm),
          mean(a.lost_jpm, b.lost_jpm),
          mean(a.side_slip_s2pm, b.side_slip_s2pm),
          mean(a.side_grip_mps2, b.side_grip_mps2)};
}

void slip_more(SlopeDrive& drive) {
  const double slip = std::min(uneven_slip * drive.slip, std::max(drive.slip, uneven_slip_most));
  const double rolled = (1 - drive.slip) / (1 - slip);
  drive.energy_jpm *= rolled;
  drive.speed_mps /= rolled;
  drive.slip = slip;
}

// The same drive where each metre takes so many times the energy and time.
SlopeDrive multiplied(SlopeDrive drive, double factor) {
  drive.energy_jpm *= factor;
  drive.lost_jpm *= factor;
  drive.speed_mps /= factor;
  drive.slip = 1 - (1 - drive.slip) / factor;
  return drive;
}

}  // namespace

double uneven_load_1pm(const VehicleConfig& vehicle, const DriveCost& cost) {
  if (cost.wheels_B_m.empty()) return 0;
  // Roughness is that of the supports of a stance.
  const double off_m2 = off_plane_m2(supports_m(cost.wheels_B_m, map_spacing_m(cost)));
  if (off_m2 <= 0) return 0;
  const double wheel_n = wheel_load_n(vehicle, cost);
  double sum = 0;
  for (const Carrier& carrier : carriers_of(vehicle, cost.wheels_B_m)) {
    const auto count = static_cast<double>(carrier.wheels.size());
    const double carried = stiffness_npm(vehicle, carrier) / (count * wheel_n);
    const double on_axle = carrier.wheel->normal_stiffness_npm / wheel_n;
    // Distances from a plane are normally distributed, roughness_m is their mean.
    sum += count * std::numbers::pi / 2 *
           (carried * carried + on_axle * on_axle * off_axle_m2(carrier, cost.wheels_B_m) / off_m2);
  }
  return std::sqrt(sum / static_cast<double>(cost.wheels_B_m.size()));
}

void add_uneven_loads(SoilDrive& drive, const VehicleConfig& vehicle,
                      const std::vector<WheelDrive>& wheels, const Soil& soil, double gravity_mps2,
                      double speed_mps, double slip_max) {
  const auto [one, other] = halves_of(wheels);
  const auto rows_of = [&](const std::vector<WheelDrive>& half) {
    return soil_drive(vehicle, half, soil, gravity_mps2, speed_mps, slip_max).by_slope;
  };
  const std::vector<SlopeDrive> rows = rows_of(one);
  const bool are_alike = one == other;
  const std::vector<SlopeDrive> more = are_alike ? rows : rows_of(other);
  const std::size_t climbed = std::min({rows.size(), more.size(), drive.by_slope.size()});
  drive.uneven = drive.by_slope;
  double steep = unknown;
  for (std::size_t k = 0; k < climbed; ++k) {
    drive.uneven[k] = in_turn(rows[k], more[k]);
    slip_more(drive.uneven[k]);
    raise_to(drive.uneven[k], drive.by_slope[k]);
    const bool is_up = drive.first_rad + drive.step_rad * static_cast<double>(k) >= 0;
    const double ratio = drive.uneven[k].energy_jpm / drive.by_slope[k].energy_jpm;
    if (is_up && std::isfinite(ratio)) steep = std::clamp(ratio, 1.0, steep_most);
  }
  for (std::size_t k = climbed; k < drive.by_slope.size(); ++k) {
    drive.uneven[k] = multiplied(drive.by_slope[k], steep);
  }
}

}  // namespace lsos
