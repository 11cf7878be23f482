// What a rover script says, as values.
#pragma once

#include <map>
#include <string>

#include "base/error.h"
#include "vehicle/wishbone.h"

namespace lsos {

struct RoverSpec {
  std::string name;
  std::string doc;
  Place place;
  VehicleConfig vehicle;  // without links: the template adds them at the site's gravity
  Wishbone suspension;
};

}  // namespace lsos
