// Times of a plan moved by a span, written as they were.
#pragma once

#include <string>
#include <string_view>

#include "base/sim_time.h"

namespace lsos {

// A UTC time that parse_utc() reads, later by `by`. Its form is kept (a date alone, no seconds, a
// blank for the T, a zone) where it is a usual one that can say the new time.
std::string shifted_utc(const std::string& utc, SimTime by);

// A duration that parse_quantity() reads, longer by `by`, in seconds.
std::string shifted_duration(std::string_view duration, SimTime by);

}  // namespace lsos
