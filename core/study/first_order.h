// How much of a result's variance goes when one parameter is held: its first-order (Sobol) share,
// from the cases as they were drawn. Cases are put into classes by the parameter; the variance of
// the classes' means, less what chance gives them, is compared with that of the result (the
// correlation ratio; Plischke, Borgonovo and Smith 2013, with Kelley's correction of 1935). It asks
// of the sampling only that parameters are drawn independently of each other, as they are by
// random, Latin hypercube and Sobol sampling and on a whole grid.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace lsos {

struct FirstOrderShare {
  double share = 0;  // 0..1
  double p = 1;      // of chance giving as much, by Fisher's distribution
  std::size_t classes = 0;
  std::size_t cases = 0;  // whose result is finite
};

// With fewer the share is mostly chance.
inline constexpr std::size_t first_order_cases_min = 30;

// The class of each case by a parameter's value: a value of its own class where there are few
// values, else about sqrt(n) classes of about as many cases; equal values share a class.
// `values` must be finite.
std::vector<std::size_t> classes_of(const std::vector<double>& values);

// `classes`, `result`: of the same cases. Cases whose result is not finite are left out. Absent
// where fewer than first_order_cases_min are left, the result does not vary, or all lie in one
// class.
std::optional<FirstOrderShare> first_order_share(const std::vector<std::size_t>& classes,
                                                 const std::vector<double>& result);

}  // namespace lsos
