// A flat solar panel that turns about two axes: its orientation, the orientation that it should
// have, and its electrical power.
#pragma once

#include <numbers>
#include <optional>
#include <string>

#include "base/archive.h"
#include "base/sim_time.h"
#include "base/vector.h"

namespace lsos {

// Orientation of a panel relative to its rover: azimuth clockwise from the nose, elevation above
// the deck (pi/2: straight up).
struct PanelAngles {
  double azimuth_rad = 0;
  double elevation_rad = std::numbers::pi / 2;

  void archive(Archive& a) { LSOS_ARCHIVE(a, azimuth_rad, elevation_rad); }
};

struct AngleLimits {
  double least_rad = 0, most_rad = 0;  // equal: the axis does not turn
};

struct PanelSpec {
  std::string name;
  Vec3 p_B_m = Vec3::Zero();  // centre, about which it turns: forward, left, up
  double length_m = 0;        // along the nose when it faces straight up at azimuth 0
  double width_m = 0;
  double efficiency = 0;  // electrical out / light in, 0..1
  double factor = 1;      // share left after dust, wiring and conversion, 0..1
  PanelAngles rest;       // before the first command
  AngleLimits azimuth, elevation;
  double rate_radps = 0;  // of either axis
  double motor_w = 0;     // while the panel turns
  bool is_stowable = false;
  bool is_stowed = false;  // at the start
  double deploy_s = 0;     // duration of deploying and of stowing
  double deploy_w = 0;     // while deploying or stowing

  double area_m2() const { return length_m * width_m; }
  bool can_turn() const;
};

// The panel's centre and half sides in frame B; the side towards half_u x half_v is the lit one.
struct PanelPose {
  Vec3 p_B_m;
  Vec3 half_u_B_m, half_v_B_m;

  Vec3 normal_B() const { return half_u_B_m.cross(half_v_B_m).normalized(); }
};
PanelPose pose(const PanelSpec& panel, const PanelAngles& angles);

// The allowed angles that face a direction (unit, frame B) best: exactly where both axes turn
// freely, else with the greatest cosine of incidence within the limits.
PanelAngles facing(const PanelSpec& panel, const PanelAngles& now, const Vec3& direction_B);

// The wanted angles, clamped to the panel's limits.
PanelAngles limited(const PanelSpec& panel, const PanelAngles& wanted);

// Duration of a turn between two orientations, s: both axes turn at once, at the panel's rate.
double turn_s(const PanelSpec& panel, const PanelAngles& from, const PanelAngles& to);
// Orientation after `time_s` of such a turn.
PanelAngles turned(const PanelSpec& panel, const PanelAngles& from, const PanelAngles& to,
                   double time_s);

// Electrical power, W. `cosine`: of the angle of incidence; `irradiance_wpm2`: W/m2 on a surface
// across the light; `sun_fraction`: visible share of the Sun's disc.
double panel_power_w(const PanelSpec& panel, double sun_fraction, double cosine,
                     double irradiance_wpm2);
// The same of light that comes from all sides, W/m2 on the panel's surface. Cells are taken to use
// it as well as direct light.
double panel_diffuse_power_w(const PanelSpec& panel, double diffuse_wpm2);

}  // namespace lsos
