#include "vehicle/suspension/skid_steer.h"

#include <fmt/format.h>

#include "vehicle/suspension/link_parts.h"

namespace lsos {

namespace {

void add_rigid(VehicleConfig& vehicle, const SkidSteer& s) {
  Inertia inertia = disc(s.wheel_mass_kg, s.wheel.radius_m, s.wheel.width_m);
  inertia.moments_kgm2 = s.wheel_moments_kgm2.value_or(inertia.moments_kgm2);
  for (const double sign : {1.0, -1.0}) {
    for (const WheelStation& station : s.stations) {
      const int link =
          add_wheel(vehicle, station.name + (sign > 0 ? "_left_wheel" : "_right_wheel"), -1,
                    {station.p_B_m.x(), sign * station.p_B_m.y(), s.wheel.radius_m}, inertia,
                    s.wheel, s.drive);
      if (!station.is_driven) {
        vehicle.links[static_cast<std::size_t>(link)].wheel_mode = WheelMode::free;
      }
    }
  }
}

RockerBogie on_rockers(const SkidSteer& s) {
  RockerBogie rockers;
  rockers.rocker = *s.rocker;
  rockers.differential = s.differential.value_or(Differential{});
  rockers.stations = s.stations;
  rockers.wheel_mass_kg = s.wheel_mass_kg;
  rockers.wheel_moments_kgm2 = s.wheel_moments_kgm2;
  rockers.wheel = s.wheel;
  rockers.drive = s.drive;
  return rockers;
}

}  // namespace

void add_skid_steer(VehicleConfig& vehicle, const SkidSteer& suspension) {
  vehicle.skid_track_ratio = suspension.turning_track_ratio;
  if (suspension.rocker) {
    add_rocker_bogie(vehicle, on_rockers(suspension));
  } else {
    add_rigid(vehicle, suspension);
  }
}

std::vector<std::string> skid_steer_faults(const SkidSteer& suspension) {
  std::vector<std::string> faults =
      suspension.rocker ? rocker_bogie_faults(on_rockers(suspension))
                        : station_faults(suspension.stations, suspension.wheel.width_m);
  for (const WheelStation& station : suspension.stations) {
    if (station.is_steered) {
      faults.push_back(
          fmt::format("station '{}' is steered: lsos.skid_steer steers none", station.name));
    }
    if (station.arm == Arm::bogie && !suspension.rocker) {
      faults.push_back(
          fmt::format("station '{}' is on the bogie: lsos.skid_steer has none", station.name));
    }
  }
  if (suspension.rocker && !suspension.differential) {
    faults.push_back("the rockers turn freely: they need a differential to hold the chassis");
  }
  if (suspension.differential && !suspension.rocker) {
    faults.push_back("a differential ties rockers, and there is no rocker");
  }
  return faults;
}

}  // namespace lsos
