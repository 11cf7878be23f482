// What rough ground does to the loads of a rover's wheels, and what driving with uneven loads
// takes.
#pragma once

#include <vector>

#include "mission/routes/soil_drive.h"
#include "route/cost/drive_cost.h"
#include "vehicle/vehicle_config.h"

namespace lsos {

// Standard deviation of a wheel's load over its mean load, per metre of `Stance::roughness_m`: the
// springs that bear a wheel, its own included, are compressed by as much as the ground under it
// lies above the plane under all wheels. Wheels on one axle share what bears them; between them the
// ground differs as on a self-affine surface of Hurst exponent 0.7, which is the roughness of
// natural ground (Shepard and others 2001, 0.5 to 0.9). It is 0 where joints that turn freely keep
// loads even, as in a rocker-bogie suspension. Limbs count as rigid, although posture control may
// even out slow changes. It is 0 too where a plane fits all axles whatever the ground, as with
// three: the roughness then says nothing. `cost`: its wheels and gravity are set.
double uneven_load_1pm(const VehicleConfig& vehicle, const DriveCost& cost);

// Sets `SoilDrive::uneven`: half of the wheels bear the load of all, so that they sink deeper. A
// wheel whose load comes and goes must shear the soil anew each time, by which it slips more. Up
// slopes that half of the wheels do not climb driving costs as many times more as on the last that
// they climb, twice as much where they climb none. No row costs less than with even loads.
// `wheels`: all of them.
void add_uneven_loads(SoilDrive& drive, const VehicleConfig& vehicle,
                      const std::vector<WheelDrive>& wheels, const Soil& soil, double gravity_mps2,
                      double speed_mps, double slip_max);

}  // namespace lsos
