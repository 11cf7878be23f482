// Whether the outline and the holes of a polygon are what they are to be.
#pragma once

#include <string>
#include <vector>

#include "planet/body.h"

namespace lsos {

// How far a place lies from a polygon, m; 0 inside its outline. For places near it.
double outside_m(const Body& body, const std::vector<Geodetic>& outline, const Geodetic& place);

// What is wrong with an outline: "crosses itself"; "" when nothing is.
std::string outline_fault(const std::vector<Geodetic>& outline);

// What is wrong with a polygon's holes; "" when each lies inside the outline, apart from it and
// from the others. `hole`: the first that is wrong, from 0.
std::string hole_fault(const std::vector<Geodetic>& outline,
                       const std::vector<std::vector<Geodetic>>& holes, std::size_t& hole);

}  // namespace lsos
