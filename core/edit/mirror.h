// `edit mirror`: another rover's events, for a rover.
#pragma once

#include <string>
#include <vector>

#include "base/vector.h"
#include "edit/copied_events.h"

namespace lsos {

struct Mirror {
  std::string from, to;          // ids of rovers
  Vec2 offset_m = Vec2::Zero();  // of its places, east and north
};

struct Mirrored {
  int count = 0;
  CopyPlaces copies;
  std::vector<std::string> warnings;
};

// Copies the events of the rover `from` for the rover `to`, behind its own. Where they name one of
// the two (a leader, whom to meet), they name the other; so do labels that have one of the two ids
// as a word, where both ids have two letters or more. Throws InputError where a place that is to be
// moved stands in no <coordinates>.
Mirrored mirror(PlanDocument& document, const Mirror& mirror);

}  // namespace lsos
