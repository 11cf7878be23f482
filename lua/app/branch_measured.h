// What was measured of the rovers that a branch goes on from.
#pragma once

#include <string>

#include "product/comparison/last_measured.h"
#include "record/log.h"

namespace lsos {

class Ground;
class Simulation;

// Reads a table of telemetry for a branch that leaves the run of `log` at `moment`. Throws
// InputError where it has nothing of any rover.
MeasuredStates read_measured(const std::string& file, const LogReader& log, SimTime moment,
                             const Ground& ground);

// Puts the rovers where they were measured to be, with a note in the log about each, and prints
// what that changed unless `is_quiet`. Throws InputError.
void go_on_from_measured(Simulation& simulation, const MeasuredStates& measured,
                         const std::string& file, bool is_quiet);

}  // namespace lsos
