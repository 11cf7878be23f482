// `edit enable` and `edit disable`.
#pragma once

#include <vector>

#include "edit/plan_document.h"

namespace lsos {

// Sets Enabled of these events. Returns how many were otherwise before.
int set_enabled(PlanDocument& document, const std::vector<const PlanEvent*>& events,
                bool is_enabled);

}  // namespace lsos
