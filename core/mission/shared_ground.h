// The ground that the cases of a study have in common.
#pragma once

#include "mission/simulation.h"

namespace lsos {

// Samples the ground along the ways of the rovers, and what of it stands before the Sun there, and
// has the grounds of processes that are forked from this one share it (Ground::share_layers()). It
// stops after `longest_s` of wall time. `prepared`: SimulationSetup::is_preparation. Returns the
// number of places sampled; 0: its ground cannot be shared.
int share_ground(const Simulation& prepared, double longest_s);

}  // namespace lsos
