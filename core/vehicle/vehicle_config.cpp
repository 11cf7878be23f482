#include "vehicle/vehicle_config.h"

namespace lsos {

double VehicleConfig::mass_kg() const {
  double mass = chassis.mass_kg;
  for (const LinkConfig& link : links) mass += link.inertia.mass_kg;
  return mass;
}

}  // namespace lsos
