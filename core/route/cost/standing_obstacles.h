// The objects that stand on the map of a leg, such as assets, and where a rover would touch them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "route/cost/leg_request.h"
#include "route/map/ground_map.h"

namespace lsos {

class StandingObstacles {
 public:
  StandingObstacles(const Obstacles& obstacles, const MapFrame& frame);

  const std::vector<Footprint>& footprints() const { return footprints_; }
  const std::string& id(std::size_t thing) const { return obstacles_.standing[thing].id; }

  // "where 'Hab' stands" if the rover would come too near to that object at any heading, else "".
  std::string fault_at(const Vec2& at_m) const;
  // The first object that would come nearer than `clearance_m` to a rover turning at a place.
  std::optional<std::size_t> near(const Vec2& at_m, double clearance_m) const;

 private:
  const Obstacles& obstacles_;
  std::vector<Footprint> footprints_;  // on the map
};

}  // namespace lsos
