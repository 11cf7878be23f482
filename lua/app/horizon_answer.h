// `lsos-host sight --horizon`: how high the ground stands all around a place.
#pragma once

#include "lua/app/instrument_answer.h"
#include "terrain/ground.h"

namespace lsos {

// One row an azimuth, clockwise from true north in steps of `step_deg`: azimuth_deg, elevation_deg
// and the distance_m of the ground that is seen highest; null
// where that is assumed, beyond the end of the ground. `from`: height above the ground. Warns
// where the ground ends nearer than what may stand higher. Throws InputError where there is no
// ground.
AnswerRow horizon_answer(const Ground& ground, const Geodetic& from, double step_deg);

}  // namespace lsos
