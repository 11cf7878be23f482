// Checks the outline and the holes of a polygon, and measures distances to it.
#pragma once

#include <string>
#include <vector>

#include "planet/body.h"

namespace lsos {

// Distance of a place from a polygon, m; 0 inside its outline. Accurate for places near it only.
double outside_m(const Body& body, const std::vector<Geodetic>& outline, const Geodetic& place);

// What is wrong with an outline: "crosses itself" or "touches itself"; "" when nothing is.
std::string outline_fault(const std::vector<Geodetic>& outline);

// What is wrong with a polygon's holes; "" when each lies inside the outline, apart from it and
// from the others. `hole` is set to the first that is wrong, counted from 0.
std::string hole_fault(const std::vector<Geodetic>& outline,
                       const std::vector<std::vector<Geodetic>>& holes, std::size_t& hole);

}  // namespace lsos
