// Everything that a script in rovers/ declares of a rover, or of an asset that stands on the
// ground.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/shape.h"
#include "mission/model/antenna.h"
#include "power/power_spec.h"
#include "route/map/ground_limits.h"
#include "vehicle/limb_stance.h"
#include "vehicle/suspension/rover_spec.h"

namespace lsos {

struct RoverModel {
  RoverSpec spec;
  PowerSpec power;
  // Wheels and struts are drawn in any case; if empty, a box as large as the chassis.
  std::vector<Shape> shapes;
  // In the order of preference; if empty, one antenna on top of the shapes.
  std::vector<AntennaSpec> antennas;
  GroundLimits limits;
  std::optional<HeightRange> heights = {};  // on limbs: how low and high it can stand
  std::optional<std::int64_t> crew = {};    // number carried; absent: not given

  // Crew aboard in one of its configurations; absent: not given.
  std::optional<std::int64_t> crew_of(const std::string& configuration) const {
    for (const RoverConfiguration& each : spec.configurations) {
      if (each.name == configuration && each.crew) return each.crew;
    }
    return crew;
  }
};

// An asset, such as a habitat or a comm station.
struct AssetModel {
  std::string name = {};
  std::string doc = {};
  Place place = {};  // where its script declares it
  std::vector<Shape> shapes = {};
  double antenna_height_m = 0;  // above the ground
  double antenna_range_max_m = std::numeric_limits<double>::infinity();
  bool reaches_earth = true;
  double supply_w = 0;  // power to give, besides that of its panels
  std::vector<PanelSpec> panels = {};
  std::vector<std::string> assumptions = {};
};

}  // namespace lsos
