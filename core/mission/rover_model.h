// All that a script in rovers/ says: of a rover, or of a thing that stands on the ground.
#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "base/shape.h"
#include "power/power_spec.h"
#include "vehicle/rover_spec.h"

namespace lsos {

struct RoverModel {
  RoverSpec spec;
  PowerSpec power;
  std::vector<Shape> shapes;  // wheels are drawn without being named; none: the chassis' box
};

// A habitat, a comm station.
struct AssetModel {
  std::string name = {};
  std::string doc = {};
  Place place = {};
  std::vector<Shape> shapes = {};
  double antenna_height_m = 0;  // above the ground
  double supply_w = 0;          // power to give, besides that of its panels
  std::vector<PanelSpec> panels = {};
  std::vector<std::string> assumptions = {};
};

}  // namespace lsos
