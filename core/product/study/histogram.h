// How often values of a result occur among cases.
#pragma once

#include <cstddef>
#include <vector>

namespace lsos {

struct HistogramBar {
  // Values of [from, to); the last bar of a row of intervals has its end too. Of one value: equal.
  double from = 0, to = 0;
  std::size_t completed = 0, other = 0;  // cases by whether their missions completed
};

// A bar a value where there are few whole ones, else intervals of one round width about that of
// Freedman and Diaconis (1981). Values that are not finite are left out. `is_completed`: of the
// same cases.
std::vector<HistogramBar> histogram(const std::vector<double>& values,
                                    const std::vector<bool>& is_completed);

}  // namespace lsos
