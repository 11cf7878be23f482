// Stances of a vehicle on limbs, and the vehicle as it stands in one.
#pragma once

#include <string>
#include <vector>

#include "vehicle/limb_chain.h"

namespace lsos {

// The vehicle as it stands with its limbs' joints at their initial positions: frame B is moved to
// the ground centre of its wheels there, and the limbs' joints are at 0. What is computed "at rest"
// (footprint, clearance, balance, stability) then holds for this stance. Products of inertia of
// turned segments are neglected. A vehicle without limbs stays as it is.
VehicleConfig as_it_stands(const VehicleConfig& vehicle);

// Places of the hubs, by limb, with the limbs' joints at their initial positions.
std::vector<Vec3> hubs_B_m(const VehicleConfig& vehicle);

// Places of the hubs at which the chassis' underside is `height_m` over the ground: where
// `hubs_B_m` are, higher or lower.
std::vector<Vec3> at_height(const VehicleConfig& vehicle, std::vector<Vec3> hubs_B_m,
                            double height_m);
// Its inverse: height of the chassis' underside over the ground.
double height_m(const VehicleConfig& vehicle, const std::vector<Vec3>& hubs_B_m);

// Least and greatest height of the chassis' underside over the ground, to a millimetre, with the
// wheels where they stand. The chassis stays above the ground.
struct HeightRange {
  double least_m = 0, greatest_m = 0;
};
HeightRange height_range(const VehicleConfig& vehicle);

// Sets the initial positions of the limbs' joints so that the hubs are at these places. Returns ""
// or the first limb that cannot reach its place, with the joint that hinders it.
std::string stand(VehicleConfig& vehicle, const std::vector<Vec3>& hubs_B_m);

}  // namespace lsos
