// Distributions of numbers, as functions of the share of values that lie below.
#pragma once

#include <variant>

namespace lsos {

struct Uniform {
  double from = 0, to = 1;
};
// Cut off at both ends: values beyond do not occur, those between keep their proportions.
struct Normal {
  double mean = 0, deviation = 1, min = 0, max = 0;
};
struct Triangular {
  double min = 0, mode = 0, max = 1;
};

using Distribution = std::variant<Uniform, Normal, Triangular>;

// The value below which `share`, in [0, 1), of all values lie; within the distribution's bounds.
double quantile(const Distribution& distribution, double share);

// Least and greatest value.
double least(const Distribution& distribution);
double greatest(const Distribution& distribution);

}  // namespace lsos
