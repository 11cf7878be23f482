// What keeps the limbs of a vehicle from standing as they are told.
#pragma once

#include <string>

#include "vehicle/vehicle.h"

namespace lsos {

// Why a limb does not go on: "limb_1_knee is locked"; "" when nothing hinders it.
std::string limb_hindrance(const Vehicle& vehicle, std::size_t limb);
// The same of the first limb that is hindered.
std::string limbs_hindrance(const Vehicle& vehicle);

// How far a vehicle may stand from its stance, m: hubs give way under their loads.
inline constexpr double stance_within_m = 0.05;

// Why a vehicle that no longer adjusts does not stand as its stance says, by where its joints
// really are: "its chassis is 1.72 m over the ground instead of 1.90 m: limb_1_knee is locked". ""
// when it does, and for a vehicle without limbs.
std::string stance_fault(const Vehicle& vehicle);

}  // namespace lsos
