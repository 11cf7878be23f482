// How a vehicle is placed on the ground, and settles there.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "vehicle/plane_fit.h"
#include "vehicle/vehicle.h"

namespace lsos {

namespace {

constexpr SimTime settle_least{1'000'000}, settle_longest{20'000'000};
constexpr double settled_mps = 1e-4;

}  // namespace

// On limbs, the chassis is as high over the middle of the ground under the wheels as its stance
// says; with posture control each limb reaches to the ground under its own wheel.
Vehicle::Placement Vehicle::on_feet(Placement placement, const Mat3& R_SB,
                                    const std::vector<Vec3>& feet_S_m) const {
  if (!posture_) return placement;
  const auto count = static_cast<double>(limb_wheels_.size());
  const Vec3 p_SB_m = placement.p_SB_m;
  std::vector<Vec3> hubs_B_m;  // over the ground, seen from p_SB_m
  double rise_m = 0;
  for (std::size_t i = 0; i < limb_wheels_.size(); ++i) {
    const std::size_t wheel = limb_wheels_[i];
    const Vec3 foot_B_m = R_SB.transpose() * (feet_S_m[wheel] - p_SB_m);
    hubs_B_m.push_back(posture_->hubs_B_m()[i]);
    const double nominal_m = hubs_B_m[i].z();
    hubs_B_m[i].z() = foot_B_m.z() + parts_[wheel].shape->radius_m;
    rise_m += (hubs_B_m[i].z() - nominal_m) / count;
  }
  placement.p_SB_m += rise_m * R_SB.col(2);
  if (!config_.posture) return placement;
  for (std::size_t i = 0; i < limb_wheels_.size(); ++i) {
    const std::vector<int>& joints = config_.limbs[i].joints;
    std::vector<double> angles_rad;
    for (const int joint : joints) {
      angles_rad.push_back(placement.joints[static_cast<std::size_t>(joint)]);
    }
    const Vec3 goal_B_m = hubs_B_m[i] - rise_m * Vec3::UnitZ();
    angles_rad = posture_->chains()[i].reach(goal_B_m, angles_rad).angles_rad;
    for (std::size_t j = 0; j < joints.size(); ++j) {
      placement.joints[static_cast<std::size_t>(joints[j])] = angles_rad[j];
    }
  }
  return placement;
}

std::vector<double> Vehicle::initial_joints() const {
  std::vector<double> joints;
  for (const LinkConfig& link : config_.links) joints.push_back(link.initial);
  return joints;
}

std::string Vehicle::put_down(const Geodetic& at, double heading_rad,
                              const std::vector<double>& joints) {
  const SiteFrame& site = ground_->site();
  const std::optional<double> elevation_m = ground_->elevation_m(at);
  if (!elevation_m) return "the terrain is not known there";
  const Vec3 p_S_m = site.p_S_m({at.lon_rad, at.lat_rad, *elevation_m});
  const Vec3 up = site.up_S(p_S_m);
  const Vec3 ahead = site.horizontal_S(heading_rad, p_S_m);

  // The plane through the ground under the wheels gives the initial attitude.
  std::vector<Vec3> feet_S_m;
  for (const Vec2& wheel_B_m : wheel_places_B_m()) {
    const Vec3 over = p_S_m + wheel_B_m.x() * ahead + wheel_B_m.y() * up.cross(ahead);
    const GroundSample ground = probe_.sample(over);
    if (!ground.is_ground()) return "the terrain is not known under one of its wheels";
    feet_S_m.push_back(over - ground.gap_m * up);
  }
  const PlaneFit plane = fit_plane(feet_S_m, up);
  const Vec3 above = stands_level() ? up : plane.normal;
  Mat3 R_SB;
  R_SB.col(2) = above;
  // `ahead` is moved vertically onto the plane: projected along the plane's normal it would change
  // the heading on a slope that also falls to the side.
  const double rise = -ahead.dot(above) / up.dot(above);
  R_SB.col(0) = (ahead + rise * up).normalized();
  R_SB.col(1) = R_SB.col(2).cross(R_SB.col(0));
  const double height_m = (plane.point - p_S_m).dot(plane.normal) / up.dot(plane.normal);
  const Placement placement =
      on_feet({p_S_m + height_m * up, joints.empty() ? initial_joints() : joints}, R_SB, feet_S_m);
  bodies_.place(placement.p_SB_m, R_SB, placement.joints);
  // With joints that do not begin at rest, wheels may be below the ground: below the plane, but
  // where limbs reach to the ground under their own wheels, below that.
  double deepest_m = 0;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Vec3& hub_S_m = bodies_.motion(parts_[i].link).p_C_S_m;
    const Vec3& foot_S_m = posture_ && config_.posture ? feet_S_m[i] : plane.point;
    deepest_m =
        std::max(deepest_m, parts_[i].shape->radius_m - (hub_S_m - foot_S_m).dot(plane.normal));
  }
  bodies_.place(placement.p_SB_m + deepest_m * plane.normal, R_SB, placement.joints);
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    const WheelMode mode = wheels_[i].mode;
    wheels_[i] = {};
    wheels_[i].mode = mode;
    wheels_[i].brake_anchor_rad = bodies_.joint_position(parts_[i].link);
    wheels_[i].search_S = plane.normal;
  }
  for (std::size_t i = 0; i < steerings_.size(); ++i) {
    const double angle_rad = bodies_.joint_position(layout_.steerings[i].link);
    steerings_[i] = {angle_rad, angle_rad, steerings_[i].is_stuck};
  }
  hold_limbs();
  command({});
  return "";
}

std::string Vehicle::place(const Geodetic& at, double heading_rad,
                           const std::vector<double>& joints) {
  std::string hindrance = put_down(at, heading_rad, joints);
  if (!hindrance.empty()) return hindrance;
  // Limbs have all the time that they need to level the chassis.
  const SimTime longest = settle_longest + (posture_ ? PostureControl::longest : SimTime{});
  bool is_settled = false;
  for (SimTime t{}; t < longest && !is_settled; t += exchange_period) {
    advance(exchange_period);
    is_settled =
        t >= settle_least && !is_adjusting() && reference_velocity_S_mps().norm() < settled_mps;
    if (!fault_.empty()) return fault_;
  }
  if (!is_settled) {
    return fmt::format(
        "it does not come to rest there: after {} s it still moves at {:.2g} m/s; the plane under "
        "its wheels slopes by {:.0f} deg",
        seconds(longest), reference_velocity_S_mps().norm(), degrees(report().slope_rad));
  }
  halt();
  distance_m_ = drive_j_ = drive_w_ = 0;
  work_ = {};
  steps_ = 0;
  return "";
}

std::string Vehicle::place_again(const Geodetic& at, double heading_rad,
                                 const std::vector<double>& joints) {
  const double distance_m = distance_m_, drive_j = drive_j_;
  const WorkDone work = work_;
  const auto steps = steps_;
  std::string hindrance = place(at, heading_rad, joints);
  distance_m_ = distance_m;
  drive_j_ = drive_j;
  work_ = work;
  steps_ = steps;
  return hindrance;
}

}  // namespace lsos
