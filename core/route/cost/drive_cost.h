// What driving costs a rover, and where it can stand: all that planning knows of it. Plain values,
// which mission/routes/drive_cost_model.h computes with the wheel code of the simulation.
#pragma once

#include <vector>

#include "base/archive.h"
#include "base/vector.h"

namespace lsos {

// Steady driving on an even slope.
struct SlopeDrive {
  double slip = 0;        // 0..1
  double energy_jpm = 0;  // electrical energy per metre along the ground
  double speed_mps = 0;   // over ground, at the requested rim speed or what motors sustain
  // What gravity supplies per metre downhill beyond the rolling resistance, as equivalent
  // electrical energy. Brakes dissipate it, unless something else holds the rover back.
  double spare_jpm = 0;
  // The part of the energy that the motors' windings and friction lose; it is no drag.
  double lost_jpm = 0;
  // Side slip angle per m/s2 of lateral acceleration where that is small, and the greatest lateral
  // acceleration that the wheels bear, see driving/side_slip.h. Wheels that pull hard have less
  // strength left for the side.
  double side_slip_s2pm = 0, side_grip_mps2 = 1;

  void archive(Archive& a) {
    LSOS_ARCHIVE(a, slip, energy_jpm, speed_mps, spare_jpm, lost_jpm, side_slip_s2pm,
                 side_grip_mps2);
  }
};

// Driving on one soil, straight up slopes from `first_rad` (negative: down) in equal steps. The
// last slope is the steepest that the rover climbs; the table is empty where its wheels cannot
// drive on the soil at all.
struct SoilDrive {
  double first_rad = 0, step_rad = 0;
  std::vector<SlopeDrive> by_slope;
  // The same slopes with the load of all wheels on half of them, as rough ground leaves it; empty
  // where that is not known.
  std::vector<SlopeDrive> uneven;

  // Steepest slope of the table; below `first_rad` where the table is empty.
  double last_rad() const {
    return first_rad + step_rad * (static_cast<double>(by_slope.size()) - 1);
  }
  // Linear interpolation. Slopes beyond the table have the values of its ends, although nothing
  // climbs above last_rad(): check that first.
  SlopeDrive at(double slope_rad) const;
  // The same with loads that are uneven to this share, see uneven_share().
  SlopeDrive at(double slope_rad, double uneven_share) const;
  // Speed at which wheels without slip roll, from the table's level row: the requested rim speed
  // times rolling over rim radius, or what motors sustain.
  double rolling_speed_mps() const {
    const SlopeDrive level = at(0);
    return level.speed_mps / (1 - level.slip);
  }

  void archive(Archive& a) { LSOS_ARCHIVE(a, first_rad, step_rad, by_slope, uneven); }
};

// Limits on where the rover may stand and on how hard it may work.
struct DriveLimits {
  double slope_max_rad = 0.35;    // of the plane under its wheels, in any direction
  double slip_max = 0.6;          // steady slip while climbing
  double clearance_min_m = 0.05;  // between its underside and the ground
  double unevenness_max_m = 0.1;  // of the ground at a wheel from the plane under the others

  void archive(Archive& a) {
    LSOS_ARCHIVE(a, slope_max_rad, slip_max, clearance_min_m, unevenness_max_m);
  }
};

// Share of the way from even loads to half of the wheels that bear all, by the mean square of a
// load's deviation over its mean. It is that square while no wheel leaves the ground; it grows more
// slowly as wheels do, and beyond 1 as neighbouring axles bear unequal loads too. Fitted to SEV on
// rough planes (the test RoughPlanes says how well).
inline double uneven_share(double square) {
  constexpr double lifting = 0.55;
  return square / (1 + lifting * square);
}

struct DriveCost {
  std::vector<SoilDrive> soils;     // in the order of Ground::soils()
  std::vector<Vec2> wheels_B_m;     // contact points on level ground: ahead, left
  std::vector<Vec3> underside_B_m;  // points of the chassis; z above the plane of the contacts
  DriveLimits limits;
  double turning_radius_min_m = 0;
  bool can_turn_on_spot = true;
  double speed_mps = 1;
  // Speed from which the rover can stop on level ground; on a descent it is lowered so that the
  // stopping distance stays the same, see driving/slope_speed.h.
  double level_speed_mps = 1;
  // Energy that the dampers of the suspension take on rough ground, per metre of route, per metre
  // of `Stance::roughness_m` and per m/s of speed.
  double rough_jspm3 = 0;
  // Standard deviation of a wheel's load over its mean, per metre of `Stance::roughness_m`.
  double uneven_1pm = 0;
  // Energy and time of stopping at a corner and setting off again.
  double stop_j = 0, stop_s = 0;
  // Energy of slowing down for an arc and speeding up again, from full speed to almost zero: the
  // part that brakes take, without that of the soil's drag.
  double slow_j = 0;
  // Electrical energy per v^2 / 2 of speeding up.
  double speeding_kg = 1;
  // Energy and time per radian of turning on the spot.
  double turn_jprad = 0, turn_sprad = 0;
  // Time of steering the wheels to where they turn the rover on the spot, and back.
  double steer_s = 0;
  // Greatest acceleration, along the route and, in an arc, across it. At full speed a radian of an
  // arc costs arc_drag_jmprad / radius: wheels that hold the rover in it roll at a slip angle.
  double acceleration_mps2 = 0.2, arc_drag_jmprad = 0;
  // Power of the drives' controllers while the rover drives or turns.
  double idle_w = 0;
  // Power of all loads but the drives, charged for the time that an arc takes longer. Without it a
  // rover that has slowed down once would wind on slowly at no cost. Time lost on slopes is not
  // charged.
  double load_w = 0;
  // Those of SlopeDrive on the level, for arcs.
  double side_slip_s2pm = 0, side_grip_mps2 = 1;
  double gravity_mps2 = 9.81;
  // Standard deviation of the cross slope's sine on rough ground, per metre of
  // `Stance::roughness_m`.
  double rough_tilt_1pm = 0;

  // uneven_share() of a place.
  double uneven_share_at(double roughness_m) const {
    return uneven_share(uneven_1pm * roughness_m * uneven_1pm * roughness_m);
  }
  // Energy of a metre on the level, controllers included, J/m; 0 where its wheels cannot drive.
  double level_jpm() const;

  void archive(Archive& a) {
    LSOS_ARCHIVE(a, soils, wheels_B_m, underside_B_m, limits, turning_radius_min_m,
                 can_turn_on_spot, speed_mps, level_speed_mps, stop_j, stop_s, slow_j, speeding_kg,
                 turn_jprad, turn_sprad, steer_s, acceleration_mps2, arc_drag_jmprad,
                 side_slip_s2pm, side_grip_mps2, gravity_mps2, rough_jspm3, uneven_1pm,
                 rough_tilt_1pm, idle_w, load_w);
  }
};

}  // namespace lsos
