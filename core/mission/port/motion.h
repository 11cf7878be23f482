// Motion of a rover, or near one, at an exchange: it decides when light and sight are evaluated
// again.
#pragma once

#include "base/sim_time.h"

namespace lsos {

enum class Motion { none, goes_on, has_ended };

// Period between evaluations while something moves, at whole multiples.
inline constexpr SimTime moving_update_period{2'000'000};

}  // namespace lsos
