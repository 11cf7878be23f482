// What is told of the models that a plan uses: soil that was assumed for it, and numbers of rovers,
// assets and soils that are likely to be slips.
#pragma once

#include "lua/host/mission_files.h"

namespace lsos {

// Adds warnings and assumptions. `is_soil_given`: whoever asks names the soil, not the plan.
void add_model_advice(MissionFiles& files, bool is_soil_given);

}  // namespace lsos
