// How much better the model foretells the pull of a wheel than simpler answers do.
#pragma once

#include "validation/report.h"
#include "validation/tables.h"

namespace lsos::validation {

// Root mean square errors of the pull, as shares of the load, over parts of a set of points. NaN:
// there are no such points.
struct PullErrors {
  double all = 0, driving = 0, braking = 0, small_slip = 0;
};
PullErrors pull_errors(const std::vector<MeasuredPoint>& points, const std::vector<double>& pulls);

// Tables of those errors: for the model with the fitted and with the published soil, and for three
// simpler answers: no pull at all, the best constant, and rim_integrals.h with the published soil.
void skill(Text& t, const Cases& cases);

}  // namespace lsos::validation
