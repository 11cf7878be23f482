// Routes that are kept between runs of a plan, so that planning them again takes no time.
#pragma once

#include <string>
#include <vector>

#include "base/error.h"

namespace lsos {

// Legs planned in earlier runs of this very program lie beside the plan: NAME.kml.routes.
std::string read_cached_legs(const std::string& plan_file);
// A warning where something else has that name: then nothing is kept.
std::vector<Fault> cached_legs_advice(const std::string& plan_file);
// Adds legs to those that are kept, also where several processes do so at once. Where the plan's
// folder is not ours to write to, nothing is kept, and the answer is a warning of
// that: the next run plans again.
std::vector<Fault> cache_legs(const std::string& plan_file, const std::string& bytes);

}  // namespace lsos
