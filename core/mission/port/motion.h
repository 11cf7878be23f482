// What goes on with a rover, or near one, at an exchange: when light and sight are looked at again.
#pragma once

#include "base/sim_time.h"

namespace lsos {

enum class Motion { none, goes_on, has_ended };

// While something moves, looks are this far apart, at whole multiples.
inline constexpr SimTime moving_look_period{2'000'000};

}  // namespace lsos
