// `edit renumber`: other Sequences in the same order.
#pragma once

#include <cstdint>
#include <string>

#include "edit/plan_document.h"

namespace lsos {

// Gives the events of each rover the sequences step, 2 step, ..., in order; `rover_id` "": of all
// rovers. References by ROVER/SEQUENCE follow, as do those by a default label, which has the
// sequence in it. Returns how many events have another sequence.
int renumber(PlanDocument& document, std::int64_t step, const std::string& rover_id);

}  // namespace lsos
