// Contents of core/vehicle/VALIDATION.md and its figures.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "validation/cases.h"

namespace lsos::validation {

struct Cases {
  Case cmu, ding, kls;
};
Cases fit_all(const std::string& data_folder);

// Grousers of the predicted wheels, which otherwise are the measured wheels.
struct GrouserSet {
  double height_m = 0;
  int count = 0;
};
inline constexpr GrouserSet cmu_grousers{0.006, 15};
inline constexpr GrouserSet ding_grousers[] = {{0.005, 24}, {0.010, 24}, {0.015, 24}};
Wheel with_grousers(Wheel wheel, const GrouserSet& grousers);
double mean_load_n(const Case& c);  // mean over its straight rolling

// One aim of the model, and the result.
struct Aim {
  std::string what, aim, found;
  bool is_reached = false;
};
std::vector<Aim> aims(const Cases& cases);

Errors errors_of(const Case& c, const Soil& soil, const std::vector<MeasuredPoint>& points);

// Text of each file, by its path relative to the root of the sources.
using Files = std::map<std::string, std::string>;
Files figures(const Cases& cases);
Files report(const Cases& cases);  // including the figures

}  // namespace lsos::validation
