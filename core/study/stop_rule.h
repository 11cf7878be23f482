// How well cases say what a study's stop_when asks.
#pragma once

#include <optional>
#include <vector>

#include "study/study.h"

namespace lsos {

struct QuantileInterval {
  double low = 0, high = 0;
};

// The 95 % interval of a quantile, whatever the distribution: between two of the values in their
// order, so chosen by the binomial distribution that at most 2.5 % of samples lie beyond either
// (Conover 1999). `sorted`: ascending and finite. Absent where there are too few.
std::optional<QuantileInterval> quantile_interval(const std::vector<double>& sorted,
                                                  double quantile);

// Half the width of the 95 % interval of what the rule asks. `values`: by case, 1 or 0 of
// share_completed; those that are not finite are left out. Absent where there are too few.
std::optional<double> half_width(const StopRule& rule, const std::vector<double>& values);

// Faults of a stop_when that the study cannot follow; what is gathered must have its names.
void check_stop_rule(const Study& study, Faults& faults);

}  // namespace lsos
