#include "vehicle/drive_control.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "vehicle/limb_stance.h"
#include "vehicle/part_pose.h"

namespace lsos {

namespace {

constexpr double steering_free_rad = 0.2;  // error up to which wheels turn at full speed
constexpr double steering_stop_rad = 0.8;  // error from which they stand still

// Velocity over the ground of a point of the body under the commanded motion.
Vec2 velocity_at(const WheelLayout& layout, const DriveCommand& command, const Vec2& p_B_m) {
  return {command.speed_mps - command.yaw_rate_radps * p_B_m.y(),
          command.left_mps + command.yaw_rate_radps * (p_B_m.x() - layout.turning_x_B_m)};
}

double nearest_angle_rad(double wanted, double now, double max) {
  double best = std::clamp(wanted, -max, max);
  double best_turn = std::numeric_limits<double>::infinity();
  for (const double turn : {0.0, -std::numbers::pi, std::numbers::pi}) {
    const double candidate = wanted + turn;
    if (std::abs(candidate) > max) continue;
    if (std::abs(candidate - now) < best_turn) {
      best = candidate;
      best_turn = std::abs(candidate - now);
    }
  }
  return best;
}

}  // namespace

WheelLayout wheel_layout(const VehicleConfig& vehicle) {
  const VehicleConfig config = as_it_stands(vehicle);
  const std::vector<Vec3> joints_B_m = joints_at_rest_B_m(config);
  WheelLayout layout;
  std::vector<int> steering_of_link(config.links.size(), -1);
  for (std::size_t i = 0; i < config.links.size(); ++i) {
    const LinkConfig& link = config.links[i];
    const int inherited =
        link.parent < 0 ? -1 : steering_of_link[static_cast<std::size_t>(link.parent)];
    steering_of_link[i] = inherited;
    const Vec2 p_B_m = joints_B_m[i].head<2>();
    if (link.steering) {
      steering_of_link[i] = static_cast<int>(layout.steerings.size());
      layout.steerings.push_back({static_cast<int>(i), p_B_m, link.steering->angle_max_rad, 0});
    }
    if (link.wheel) {
      const Vec2 axle_B = link.axis.head<2>();
      double offset_m = 0;
      const double heading_rad = std::atan2(-axle_B.x(), axle_B.y());
      if (inherited >= 0) {
        WheelLayout::Steering& steering = layout.steerings[static_cast<std::size_t>(inherited)];
        offset_m = axle_B.dot(p_B_m - steering.p_B_m);
        steering.heading_rad = heading_rad;
      }
      layout.wheels.push_back({static_cast<int>(i), inherited, offset_m, p_B_m,
                               link.wheel->radius_m, link.wheel_mode, heading_rad});
    }
  }
  double fixed = 0, sum_m = 0;
  for (const WheelLayout::WheelPlace& wheel : layout.wheels) {
    if (wheel.steering >= 0) continue;
    ++fixed;
    sum_m += wheel.p_B_m.x();
  }
  if (fixed > 0) layout.turning_x_B_m = sum_m / fixed;
  if (layout.steerings.empty()) layout.skid_track_ratio = config.skid_track_ratio;
  return layout;
}

WheelTargets wheel_targets(const WheelLayout& layout, const DriveCommand& command,
                           const std::vector<double>& steering_now_rad,
                           const std::vector<bool>& are_stuck) {
  WheelTargets targets{steering_now_rad, std::vector<double>(layout.wheels.size(), 0.0)};
  double error_rad = 0;
  for (std::size_t i = 0; i < layout.steerings.size(); ++i) {
    if (i < are_stuck.size() && are_stuck[i]) continue;
    const WheelLayout::Steering& steering = layout.steerings[i];
    const Vec2 v = velocity_at(layout, command, steering.p_B_m);
    if (v.norm() < 1e-9) continue;
    const double wanted_rad = std::atan2(v.y(), v.x()) - steering.heading_rad;
    targets.steering_angle_rad[i] =
        nearest_angle_rad(wanted_rad, steering_now_rad[i], steering.angle_max_rad);
    error_rad = std::max(error_rad, std::abs(targets.steering_angle_rad[i] - steering_now_rad[i]));
  }
  const double share = std::clamp(
      (steering_stop_rad - error_rad) / (steering_stop_rad - steering_free_rad), 0.0, 1.0);
  for (std::size_t i = 0; i < layout.wheels.size(); ++i) {
    const WheelLayout::WheelPlace& wheel = layout.wheels[i];
    double angle_rad = wheel.heading_rad;
    Vec2 p_B_m = wheel.p_B_m;
    if (wheel.steering >= 0) {
      const auto s = static_cast<std::size_t>(wheel.steering);
      angle_rad += targets.steering_angle_rad[s];
      p_B_m = layout.steerings[s].p_B_m +
              wheel.offset_m * Vec2(-std::sin(angle_rad), std::cos(angle_rad));
    }
    const Vec2 heading(std::cos(angle_rad), std::sin(angle_rad));
    p_B_m.y() *= layout.skid_track_ratio;
    targets.spin_radps[i] =
        share * velocity_at(layout, command, p_B_m).dot(heading) / wheel.radius_m;
  }
  return targets;
}

}  // namespace lsos
