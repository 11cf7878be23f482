#include "vehicle/vehicle_config.h"

#include <fmt/format.h>

#include <cmath>

#include "vehicle/vehicle_checks.h"

namespace lsos {

double VehicleConfig::mass_kg() const {
  double mass = chassis.mass_kg;
  for (const LinkConfig& link : links) mass += link.inertia.mass_kg;
  return mass;
}

namespace {

double moment_about_axis(const LinkConfig& link) {
  return (link.axis.array().square() * link.inertia.moments_kgm2.array()).sum();
}

}  // namespace

std::vector<std::string> stability_faults(const VehicleConfig& vehicle) {
  const double step_s = seconds(vehicle.step);
  std::vector<std::string> faults;
  const auto check = [&](const LinkConfig& link, const char* what, double stiffness,
                         double inertia) {
    const double mode = std::sqrt(stiffness / inertia) * step_s;
    if (mode > 1) {
      faults.push_back(fmt::format(
          "step_s = {}: too long for the {} of {}: omega x step is {:.2f}, at most 1 is stable; "
          "a step of {:.4f} s or less, or a softer spring",
          step_s, what, link.name, mode, step_s / mode));
    }
  };
  for (const LinkConfig& link : vehicle.links) {
    const double mass = link.inertia.mass_kg, moment = moment_about_axis(link);
    if (link.wheel) check(link, "wheel's normal spring", link.wheel->normal_stiffness_npm, mass);
    if (link.steering) check(link, "steering servo", link.steering->stiffness_n_m_prad, moment);
    if (link.drive) check(link, "brake", link.drive->brake_stiffness_n_m_prad, moment);
    if (link.spring) {
      check(link, "suspension spring", link.spring->stiffness, mass);
      check(link, "suspension's stops", link.spring->stop_stiffness, mass);
    }
  }
  return faults;
}

}  // namespace lsos
