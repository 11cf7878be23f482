// Where the cases of a study lie in the unit cube. A case's share of a dimension depends on the
// root seed, the case's number and the dimension's name alone; with a Latin hypercube also on the
// number of cases. Dimensions of a Sobol sequence are counted in byte order of their names.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "study/study.h"

namespace lsos {

struct Dimension {
  std::string name;
  std::int64_t choices = 0;  // of a list or range; 0: continuous
};

class Sampler {
 public:
  // `cases`: how many there are. A grid has dimensions with choices only; there are at most
  // sobol_dimensions_max for Sobol.
  Sampler(Sampling sampling, std::uint64_t seed, std::int64_t cases,
          std::vector<Dimension> dimensions);

  // Shares in [0, 1) by dimension's name. `number`: of the case, from 1. On a grid the shares lie
  // in the middle of each choice, and the last dimension in byte order changes fastest.
  std::map<std::string, double> shares(std::int64_t number) const;

 private:
  std::vector<double> sobol_shares(std::int64_t number) const;
  std::vector<double> grid_shares(std::int64_t number) const;

  Sampling sampling_;
  std::uint64_t seed_;
  std::int64_t cases_;
  std::vector<Dimension> dimensions_;                // in byte order of their names
  std::vector<std::vector<std::int64_t>> permuted_;  // of a Latin hypercube: strata by case
};

inline constexpr std::size_t sobol_dimensions_max = 3667;

// Number of points of the grid; cases_max + 1 where there are more.
std::int64_t grid_size(const std::vector<Dimension>& dimensions);

}  // namespace lsos
