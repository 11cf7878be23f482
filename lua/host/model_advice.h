// Advice about the models that a plan uses: soil that was assumed, and numbers of rovers, assets
// and soils that are likely to be mistakes.
#pragma once

#include "lua/host/mission_files.h"

namespace lsos {

// Adds warnings and assumptions. `is_soil_given`: the caller names the soil, not the plan.
void add_model_advice(MissionFiles& files, bool is_soil_given);

}  // namespace lsos
