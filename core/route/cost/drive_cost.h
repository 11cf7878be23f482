// What driving costs a rover, and where it can stand: all that planning knows of it. Plain values;
// mission/routes/drive_table.h makes them with the wheel code of the simulation.
#pragma once

#include <vector>

#include "base/archive.h"
#include "base/vector.h"

namespace lsos {

// Steady driving on an even slope.
struct SlopeDrive {
  double slip = 0;        // 0..1
  double energy_jpm = 0;  // electrical, for each metre along the ground
  double speed_mps = 0;   // that the rover asks for and its motors can keep
  // What gravity gives downhill beyond what rolling takes, as the electrical energy that it stands
  // for: brakes take it, unless something else holds the rover back.
  double spare_jpm = 0;

  void archive(Archive& a) { a(slip)(energy_jpm)(speed_mps)(spare_jpm); }
};

// On one soil, straight up slopes from `first_rad` (negative: down) in even steps; the last is the
// steepest that it climbs; none where its wheels do not drive it at all.
struct SoilDrive {
  double first_rad = 0, step_rad = 0;
  std::vector<SlopeDrive> by_slope;

  // Below `first_rad` where there is none.
  double last_rad() const {
    return first_rad + step_rad * (static_cast<double>(by_slope.size()) - 1);
  }
  // Linear between. Above last_rad() nothing climbs: ask first. Below the first slope as on it.
  SlopeDrive at(double slope_rad) const;

  void archive(Archive& a) { a(first_rad)(step_rad)(by_slope); }
};

// Limits of where it may stand, and what it may demand of itself.
struct DriveLimits {
  double slope_max_rad = 0.35;    // of the plane under its wheels, in any direction
  double slip_max = 0.6;          // steady, climbing
  double clearance_min_m = 0.05;  // between its underside and the ground
  double unevenness_max_m = 0.1;  // of the ground at a wheel from the plane under the others

  void archive(Archive& a) { a(slope_max_rad)(slip_max)(clearance_min_m)(unevenness_max_m); }
};

struct DriveCost {
  std::vector<SoilDrive> soils;     // as Ground::soils()
  std::vector<Vec2> wheels_B_m;     // where they touch level ground: ahead, left
  std::vector<Vec3> underside_B_m;  // of the chassis, over the plane of the wheels' contacts
  DriveLimits limits;
  double turning_radius_min_m = 0;
  bool can_turn_on_spot = true;
  double speed_mps = 1;
  // That it stops from on the level as it does downhill from less, see driving/downhill.h.
  double full_speed_mps = 1;
  // For each metre of way and of `Stance::roughness_m`: wheels that climb one bump while others
  // come down from theirs give back less than they take. At a crawl, and with the square of speed.
  double rough_jpm2 = 0, rough_js2pm4 = 0;
  // Of stopping at a corner and driving off again, and of turning there on the spot.
  double stop_j = 0, stop_s = 0;
  // Of slowing down for an arc and speeding up again, from full speed to next to none: what the
  // soil's drag does not take.
  double slow_j = 0;
  double turn_jprad = 0, turn_sprad = 0;
  // Of steering wheels to where they turn the rover on the spot, and back.
  double steer_s = 0;
  // Greatest acceleration, along the way as across it in an arc. Of a radian of one at full speed,
  // times its radius: wheels that hold the rover in it roll at an angle.
  double acceleration_mps2 = 0.2, arc_drag_jmprad = 0;
  // Taken besides by its drives: what it takes longer in an arc costs that. Without it a rover that
  // has slowed down once would wind on slowly for nothing. Where a slope slows it down it is not
  // counted.
  double load_w = 0;
  // Angle of its travel to its heading for each m/s2 across, which a slope takes of gravity and an
  // arc of speed.
  double drift_s2pm = 0, gravity_mps2 = 9.81;
  // Of rough ground, for each metre of `Stance::roughness_m`: the sine of a slope across that slows
  // the rover down as much, for it drifts to and fro.
  double rough_tilt_1pm = 0;

  void archive(Archive& a) {
    a(soils)(wheels_B_m)(
        underside_B_m)(limits)(turning_radius_min_m)(can_turn_on_spot)(speed_mps)(full_speed_mps)(stop_j)(stop_s)(slow_j)(turn_jprad)(turn_sprad)(steer_s)(acceleration_mps2)(arc_drag_jmprad)(drift_s2pm)(gravity_mps2)(rough_jpm2)(rough_js2pm4)(rough_tilt_1pm)(load_w);
  }
};

}  // namespace lsos
