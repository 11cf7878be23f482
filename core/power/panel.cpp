#include "power/panel.h"

#include <algorithm>
#include <cmath>

namespace lsos {

namespace {

constexpr double pi = std::numbers::pi;

bool is_all_round(const AngleLimits& limits) {
  return limits.most_rad - limits.least_rad >= 2 * pi;
}

double wrapped(double angle_rad) { return std::remainder(angle_rad, 2 * pi); }

// The angle within limits that is nearest to a wanted one, in either direction of rotation.
double nearest(const AngleLimits& limits, double wanted_rad) {
  if (is_all_round(limits)) return wrapped(wanted_rad);
  const double middle_rad = (limits.least_rad + limits.most_rad) / 2;
  const double half_rad = (limits.most_rad - limits.least_rad) / 2;
  return middle_rad + std::clamp(wrapped(wanted_rad - middle_rad), -half_rad, half_rad);
}

// Signed rotation of an axis from one angle to another, rad.
double signed_turn_rad(const AngleLimits& limits, double from_rad, double to_rad) {
  return is_all_round(limits) ? wrapped(to_rad - from_rad) : to_rad - from_rad;
}

double turned(const AngleLimits& limits, double from_rad, double to_rad, double reach_rad) {
  const double turn_rad = signed_turn_rad(limits, from_rad, to_rad);
  if (std::abs(turn_rad) <= reach_rad) return to_rad;
  const double at_rad = from_rad + std::copysign(reach_rad, turn_rad);
  return is_all_round(limits) ? wrapped(at_rad) : at_rad;
}

}  // namespace

bool PanelSpec::can_turn() const {
  return azimuth.most_rad > azimuth.least_rad || elevation.most_rad > elevation.least_rad;
}

PanelPose pose(const PanelSpec& panel, const PanelAngles& angles) {
  const double tilt_rad = pi / 2 - angles.elevation_rad;
  const Mat3 R = (Eigen::AngleAxisd(-angles.azimuth_rad, Vec3::UnitZ()) *
                  Eigen::AngleAxisd(tilt_rad, Vec3::UnitY()))
                     .toRotationMatrix();
  return {panel.p_B_m, R.col(0) * (panel.length_m / 2), R.col(1) * (panel.width_m / 2)};
}

PanelAngles limited(const PanelSpec& panel, const PanelAngles& wanted) {
  return {nearest(panel.azimuth, wanted.azimuth_rad),
          std::clamp(wanted.elevation_rad, panel.elevation.least_rad, panel.elevation.most_rad)};
}

PanelAngles facing(const PanelSpec& panel, const PanelAngles& now, const Vec3& direction_B) {
  const double level = std::hypot(direction_B.x(), direction_B.y());
  PanelAngles angles;
  // Straight above the deck every azimuth faces the direction.
  angles.azimuth_rad =
      nearest(panel.azimuth,
              level > 1e-9 ? std::atan2(-direction_B.y(), direction_B.x()) : now.azimuth_rad);
  // For that azimuth the elevation e that maximises the cosine, cos(e) ahead + sin(e) up.
  const double ahead = direction_B.x() * std::cos(angles.azimuth_rad) -
                       direction_B.y() * std::sin(angles.azimuth_rad);
  const double best_rad = std::atan2(direction_B.z(), ahead);
  // A best elevation beyond the limits is replaced by the nearer limit.
  const AngleLimits& limits = panel.elevation;
  angles.elevation_rad = nearest(limits, best_rad);
  return angles;
}

double turn_s(const PanelSpec& panel, const PanelAngles& from, const PanelAngles& to) {
  const double turn_rad =
      std::max(std::abs(signed_turn_rad(panel.azimuth, from.azimuth_rad, to.azimuth_rad)),
               std::abs(to.elevation_rad - from.elevation_rad));
  return turn_rad == 0 ? 0 : turn_rad / panel.rate_radps;
}

PanelAngles turned(const PanelSpec& panel, const PanelAngles& from, const PanelAngles& to,
                   double time_s) {
  const double reach_rad = panel.rate_radps * time_s;
  return {turned(panel.azimuth, from.azimuth_rad, to.azimuth_rad, reach_rad),
          turned(AngleLimits{}, from.elevation_rad, to.elevation_rad, reach_rad)};
}

double panel_power_w(const PanelSpec& panel, double sun_fraction, double cosine,
                     double irradiance_wpm2) {
  return sun_fraction * std::max(0.0, cosine) * panel.area_m2() * panel.efficiency * panel.factor *
         irradiance_wpm2;
}

double panel_diffuse_power_w(const PanelSpec& panel, double diffuse_wpm2) {
  return panel_power_w(panel, 1, 1, diffuse_wpm2);
}

}  // namespace lsos
