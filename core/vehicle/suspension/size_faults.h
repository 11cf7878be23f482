// Bounds of what a rover script describes, before anything is made of it: the ground under a
// chassis is sampled, and each link costs time in each step.
#pragma once

#include <string>
#include <vector>

#include "vehicle/suspension/rover_spec.h"

namespace lsos {

// From the reference point to any part.
inline constexpr double reach_max_m = 100;
// Arms, knuckles, limb segments and wheels together.
inline constexpr std::size_t links_max = 200;
inline constexpr std::size_t configurations_max = 100;

// One sentence each; empty if there are none.
std::vector<std::string> size_faults(const RoverSpec& spec);

}  // namespace lsos
