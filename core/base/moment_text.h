// Times of a mission as messages tell them.
#pragma once

#include <string>

#include "base/sim_time.h"

namespace lsos {

// "1200.5 s"; from the second day on with the day and the clock since the start, as the report
// counts them: "384471.6 s (day 5, 10:47:51)".
std::string moment_text(SimTime time);

}  // namespace lsos
