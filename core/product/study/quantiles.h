// Quantiles of the values that cases have.
#pragma once

#include <cstddef>
#include <vector>

namespace lsos {

struct Quantiles {
  double p5 = 0, p50 = 0, p95 = 0;
  std::size_t count = 0;  // of finite values; 0: the others say nothing
};

// Between two of the values, which are sorted here, as far as the share lies between theirs
// (Hyndman and Fan 1996, type 7: what pandas and R take). Values that are not finite are left out.
Quantiles quantiles_of(std::vector<double>& values);

// The same for one share, 0..1; `sorted`: finite, ascending and not empty.
double quantile_of(const std::vector<double>& sorted, double share);

}  // namespace lsos
