// A flat solar panel that turns about two axes: where it faces, where it should, and what it makes
// of light.
#pragma once

#include <numbers>
#include <optional>
#include <string>

#include "base/archive.h"
#include "base/sim_time.h"
#include "base/vector.h"

namespace lsos {

// Where a panel faces, seen from its rover: azimuth clockwise from the nose, elevation above the
// deck (pi/2: straight up).
struct PanelAngles {
  double azimuth_rad = 0;
  double elevation_rad = std::numbers::pi / 2;

  void archive(Archive& a) { a(azimuth_rad)(elevation_rad); }
};

struct AngleLimits {
  double least_rad = 0, most_rad = 0;  // equal: the axis does not turn
};

struct PanelSpec {
  std::string name;
  Vec3 p_B_m = Vec3::Zero();  // its middle, about which it turns: forward, left, up
  double length_m = 0;        // along the nose when it faces straight up at azimuth 0
  double width_m = 0;
  double efficiency = 0;  // electrical out / light in, 0..1
  double factor = 1;      // what is left after dust, wiring and conversion, 0..1
  PanelAngles rest;       // before anything is told to it
  AngleLimits azimuth, elevation;
  double rate_radps = 0;  // either axis
  double motor_w = 0;     // while it turns
  bool is_stowable = false;
  bool is_stowed = false;  // at the start
  double deploy_s = 0;     // how long deploying and stowing take
  double deploy_w = 0;     // meanwhile

  double area_m2() const { return length_m * width_m; }
  bool can_turn() const;
};

// The panel's middle and half sides in frame B; it is lit on the side of half_u x half_v.
struct PanelPose {
  Vec3 p_B_m;
  Vec3 half_u_B_m, half_v_B_m;

  Vec3 normal_B() const { return half_u_B_m.cross(half_v_B_m).normalized(); }
};
PanelPose pose(const PanelSpec& panel, const PanelAngles& angles);

// The angles nearest to facing a direction (unit, frame B) that its limits allow: where both axes
// turn freely it faces it, where one does, the cosine of incidence is the greatest there is.
PanelAngles facing(const PanelSpec& panel, const PanelAngles& now, const Vec3& direction_B);

// Within its limits.
PanelAngles limited(const PanelSpec& panel, const PanelAngles& wanted);

// How long it turns from one to the other, s: both axes at once, at its rate.
double turn_s(const PanelSpec& panel, const PanelAngles& from, const PanelAngles& to);
// Where it is after so long.
PanelAngles turned(const PanelSpec& panel, const PanelAngles& from, const PanelAngles& to,
                   double time_s);

// W, in light of that irradiance (W/m2, across it) from a direction whose cosine of incidence it
// is.
double panel_power_w(const PanelSpec& panel, double sun_fraction, double cosine,
                     double irradiance_wpm2);

}  // namespace lsos
