#include "route/cost/stance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace lsos {

namespace {

// Greatest lateral slip across a slope, taken as the slip up an equally steep slope less that on
// the level. The path follower heads uphill of its line by as much; up to this limit it holds the
// line within some centimetres (MER across 10 degrees: 0.1 m), beyond it that is not reliable.
constexpr double side_slip_max = 0.4;
// Greatest slip with which brakes hold the rover on a descent; with more it slides (Husky, which
// gets down 28 degrees, has 0.2 in the mean).
constexpr double braking_slip_max = 0.4;

// Number of map spacings along the shorter side of the rectangle of the wheels, and the bounds of
// the spacing.
constexpr double nodes_a_side = 4, spacing_min_m = 0.2, spacing_max_m = 1;

// Greatest rise assumed of the ground between points of the underside, in units of
// GroundMap::Window::bump_m(). Larger: more stances need the slow check of every node; smaller:
// that check may miss a rock.
constexpr double bumps_between = 2;

// Height of the lowest point of the underside above the plane of the wheels, and the part of it
// that may be used up.
double underside_level_m(const DriveCost& cost) {
  const auto by_height = [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); };
  return std::ranges::min_element(cost.underside_B_m, by_height)->z();
}
double clearance_left_m(const DriveCost& cost) {
  return std::max(1e-3, underside_level_m(cost) - cost.limits.clearance_min_m);
}

double side_slip(const SoilDrive& soil, double bank_rad) {
  return std::max(0.0, soil.at(std::abs(bank_rad)).slip - soil.at(0).slip);
}

// Slip of wheels that brake: the rover is faster than they roll by this share of its speed.
double braking_slip(const SoilDrive& soil, double pitch_rad) {
  if (pitch_rad >= 0) return 0;
  return std::max(0.0, 1 - soil.rolling_speed_mps() / soil.at(pitch_rad).speed_mps);
}

// Greatest slope, along or across, that uses less than `far_share` of every limit on every soil;
// to 0.001 rad.
double far_slope_rad(const DriveCost& cost) {
  constexpr double step_rad = 0.001;
  const double most_rad = StanceFinder::far_share * cost.limits.slope_max_rad;
  double slope_rad = 0;
  const auto is_far_from_limits = [&](const SoilDrive& soil) {
    return slope_rad < climb_max_rad(soil) &&
           soil.at(slope_rad).slip < StanceFinder::far_share * cost.limits.slip_max &&
           side_slip(soil, slope_rad) < StanceFinder::far_share * side_slip_max &&
           braking_slip(soil, -slope_rad) < StanceFinder::far_share * braking_slip_max;
  };
  while (slope_rad < most_rad && std::ranges::all_of(cost.soils, is_far_from_limits))
    slope_rad += step_rad;
  return slope_rad - step_rad;
}

// Range of columns in each row whose nodes lie within a distance along a direction, either way.
struct Slab {
  double shift, half;  // shift of its middle per row, and half width, in columns

  double low(double row) const { return shift * row - half; }
  double high(double row) const { return shift * row + half; }
};

// `along_m`: components along the direction of one column and one row, m. The range is the whole
// row where a column has none.
Slab slab(const Vec2& along_m, double most_m) {
  constexpr double none_m = 1e-12;
  if (std::abs(along_m.x()) < none_m) return {0, std::numeric_limits<double>::infinity()};
  return {-along_m.y() / along_m.x(), most_m / std::abs(along_m.x())};
}

}  // namespace

std::vector<Vec2> supports_m(const std::vector<Vec2>& wheels_m, double map_spacing_m) {
  std::vector<Vec2> supports;
  std::vector<int> wheels_on;
  for (const Vec2& wheel : wheels_m) {
    const auto near = std::ranges::find_if(
        supports, [&](const Vec2& at_m) { return (at_m - wheel).norm() < map_spacing_m / 2; });
    if (near == supports.end()) {
      supports.push_back(wheel);
      wheels_on.push_back(1);
      continue;
    }
    int& count = wheels_on[static_cast<std::size_t>(near - supports.begin())];
    *near += (wheel - *near) / ++count;
  }
  return supports;
}

double map_spacing_m(const DriveCost& cost) {
  Vec2 low_m = cost.wheels_B_m.front(), high_m = low_m;
  for (const Vec2& wheel : cost.wheels_B_m) {
    low_m = low_m.cwiseMin(wheel);
    high_m = high_m.cwiseMax(wheel);
  }
  return std::clamp((high_m - low_m).minCoeff() / nodes_a_side, spacing_min_m, spacing_max_m);
}

StanceFinder::StanceFinder(const DriveCost& cost)
    : cost_(cost),
      far_slope_rad_(far_slope_rad(cost)),
      far_clearance_m_(cost.limits.clearance_min_m + (1 - far_share) * clearance_left_m(cost)) {
  const std::vector<Vec2> at_B_m = supports_m(cost.wheels_B_m, map_spacing_m(cost));
  // Least squares of z = a + b ahead + c left.
  Eigen::Matrix<double, Eigen::Dynamic, 3> places(at_B_m.size(), 3);
  for (std::size_t k = 0; k < at_B_m.size(); ++k) {
    places.row(static_cast<Eigen::Index>(k)) << 1, at_B_m[k].x(), at_B_m[k].y();
  }
  const Eigen::Matrix<double, 3, Eigen::Dynamic> plane_by_heights =
      (places.transpose() * places).inverse() * places.transpose();
  for (Eigen::Index k = 0; k < places.rows(); ++k) {
    // The leverage is 1 where the others alone define no plane.
    const double own_share = places.row(k).dot(plane_by_heights.col(k));
    supports_.push_back({at_B_m[static_cast<std::size_t>(k)], plane_by_heights.col(k),
                         own_share < 1 - 1e-9 ? 1 / (1 - own_share) : 1});
  }
  underside_low_B_m_ = underside_high_B_m_ = cost.underside_B_m.front().head<2>();
  underside_m_ = underside_level_m(cost);
  for (const Vec3& point : cost.underside_B_m) {
    underside_low_B_m_ = underside_low_B_m_.cwiseMin(point.head<2>());
    underside_high_B_m_ = underside_high_B_m_.cwiseMax(point.head<2>());
  }
  Vec2 low_B_m = underside_low_B_m_, high_B_m = underside_high_B_m_;
  for (const Vec2& support_B_m : at_B_m) {
    low_B_m = low_B_m.cwiseMin(support_B_m);
    high_B_m = high_B_m.cwiseMax(support_B_m);
  }
  middle_B_m_ = (low_B_m + high_B_m) / 2;
  half_B_m_ = (high_B_m - low_B_m) / 2;
}

double StanceFinder::least_clearance_m(const GroundMap::Window& ground, const Footing& footing,
                                       const Vec3& plane) const {
  const Vec2 middle_B_m = (underside_low_B_m_ + underside_high_B_m_) / 2;
  const Vec2 half_B_m = (underside_high_B_m_ - underside_low_B_m_) / 2;
  const Vec2 middle = footing.nodes(middle_B_m.x(), middle_B_m.y());
  const Vec2 half = footing.half(half_B_m);
  const int row_last = static_cast<int>(middle.y() + half.y());
  // Distances ahead and to the left per column and row.
  const double per_m2 = footing.ahead.squaredNorm();
  const Vec2 ahead_m = footing.ahead / per_m2, left_m = footing.left / per_m2;
  const Slab along = slab(ahead_m, half_B_m.x()), across = slab(left_m, half_B_m.y());
  // Rise of the underside per column and row.
  const Vec2 rise_m = plane.y() * ahead_m + plane.z() * left_m;
  const double level_m =
      plane.x() + plane.y() * middle_B_m.x() + plane.z() * middle_B_m.y() + underside_m_;
  double least_m = std::numeric_limits<double>::infinity();
  for (int row = static_cast<int>(std::ceil(middle.y() - half.y())); row <= row_last; ++row) {
    const double y = row - middle.y();
    const double low = std::max(along.low(y), across.low(y));
    const double high = std::min(along.high(y), across.high(y));
    if (!(low <= high)) continue;
    const int column_last = static_cast<int>(middle.x() + high);
    for (int column = static_cast<int>(std::ceil(middle.x() + low)); column <= column_last;
         ++column) {
      const double x = column - middle.x();
      const double over_m = level_m + rise_m.x() * x + rise_m.y() * y - ground.node_m(column, row);
      if (over_m < least_m) least_m = over_m;  // not where there is no ground
    }
  }
  return least_m;
}

Stance StanceFinder::at(GroundMap& map, const Vec2& at_m, const Vec2& ahead) const {
  const Vec2 ahead_nodes = ahead / map.spacing_m();
  const Footing footing{map.nodes(at_m), ahead_nodes, {-ahead_nodes.y(), ahead_nodes.x()}};
  const Vec2 middle = footing.nodes(middle_B_m_.x(), middle_B_m_.y());
  const Vec2 half = footing.half(half_B_m_);
  Stance stance;
  const auto ground = map.window(middle - half, middle + half);
  if (!ground) return stance;
  // This runs thousands of times per metre: no allocation, except for rovers with very many wheels.
  std::array<double, 32> few_m;
  std::vector<double> many_m;
  if (supports_.size() > few_m.size()) many_m.resize(supports_.size());
  double* heights_m = many_m.empty() ? few_m.data() : many_m.data();
  Vec3 plane = Vec3::Zero();
  for (std::size_t k = 0; k < supports_.size(); ++k) {
    const Support& support = supports_[k];
    heights_m[k] = ground->height_m(footing.nodes(support.at_B_m.x(), support.at_B_m.y()));
    plane += support.plane_by_height * heights_m[k];
  }
  if (std::isnan(plane.x())) return stance;
  stance.is_on_ground = true;
  const auto plane_m = [&](double x_m, double y_m) {
    return plane.x() + plane.y() * x_m + plane.z() * y_m;
  };
  for (std::size_t k = 0; k < supports_.size(); ++k) {
    const Support& support = supports_[k];
    const double off_m = std::abs(heights_m[k] - plane_m(support.at_B_m.x(), support.at_B_m.y()));
    stance.unevenness_m = std::max(stance.unevenness_m, support.leverage * off_m);
    stance.roughness_m += off_m;
  }
  stance.roughness_m /= static_cast<double>(supports_.size());
  stance.pitch_rad = std::atan(plane.y());
  stance.bank_rad = std::atan(plane.z());
  stance.slope_rad = std::atan(std::sqrt(plane.y() * plane.y() + plane.z() * plane.z()));
  stance.clearance_m = std::numeric_limits<double>::infinity();
  for (const Vec3& point : cost_.underside_B_m) {
    const double over_m = plane_m(point.x(), point.y()) + point.z() -
                          ground->height_m(footing.nodes(point.x(), point.y()));
    if (over_m < stance.clearance_m) stance.clearance_m = over_m;  // not where there is no ground
  }
  // A rock may stand between those points, so all nodes are checked where the margin is small.
  if (stance.clearance_m - bumps_between * ground->bump_m() < far_clearance_m_) {
    stance.clearance_m = std::min(stance.clearance_m, least_clearance_m(*ground, footing, plane));
  }
  stance.soil = map.soil(at_m);
  return stance;
}

Hazard hazard(const Stance& stance, const DriveCost& cost) {
  return hazard(stance, cost, cost.limits);
}

Hazard hazard(const Stance& stance, const DriveCost& cost, const DriveLimits& limits) {
  if (!stance.is_on_ground) return Hazard::no_ground;
  if (stance.slope_rad > limits.slope_max_rad) return Hazard::slope;
  if (stance.unevenness_m > limits.unevenness_max_m) return Hazard::uneven;
  if (stance.clearance_m < limits.clearance_min_m) return Hazard::clearance;
  const SoilDrive& soil = cost.soils[static_cast<std::size_t>(stance.soil)];
  // The rover may descend what it cannot climb. Where the soil cannot hold it up a slope, it cannot
  // hold it across that slope either.
  if (soil.last_rad() < 0) return Hazard::climb;
  if (stance.pitch_rad > 0 && stance.slope_rad > climb_max_rad(soil)) return Hazard::climb;
  if (std::abs(stance.bank_rad) > soil.last_rad() ||
      side_slip(soil, stance.bank_rad) > side_slip_max ||
      braking_slip(soil, stance.pitch_rad) > braking_slip_max) {
    return Hazard::slide;
  }
  return Hazard::none;
}

double climb_max_rad(const SoilDrive& soil) {
  constexpr double climb_share = 0.95;
  return soil.last_rad() > 0 ? climb_share * soil.last_rad() : soil.last_rad();
}

bool can_stop(const Stance& stance, const DriveCost& cost) {
  return stance.slope_rad <= climb_max_rad(cost.soils[static_cast<std::size_t>(stance.soil)]);
}

double limit_use(const Stance& stance, const DriveCost& cost) {
  const DriveLimits& limits = cost.limits;
  const SoilDrive& soil = cost.soils[static_cast<std::size_t>(stance.soil)];
  return std::max({stance.slope_rad / limits.slope_max_rad,
                   (underside_level_m(cost) - stance.clearance_m) / clearance_left_m(cost),
                   stance.unevenness_m / limits.unevenness_max_m,
                   stance.pitch_rad > 0 ? soil.at(stance.slope_rad).slip / limits.slip_max : 0,
                   side_slip(soil, stance.bank_rad) / side_slip_max,
                   braking_slip(soil, stance.pitch_rad) / braking_slip_max});
}

}  // namespace lsos
