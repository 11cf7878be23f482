// What a rover may query about other rovers, assets and the sky, as of the last exchange.
#pragma once

#include <optional>
#include <string>

#include "mission/port/rover_port.h"
#include "planet/site_frame.h"

namespace lsos {

class Surroundings {
 public:
  virtual ~Surroundings() = default;

  // Position of a rover or an asset; absent: nothing has that id.
  virtual std::optional<Vec3> place_S_m(const std::string& id) const = 0;
  virtual bool has_rover(const std::string& id) const = 0;
  // The ground that a rover covers now; absent: there is no such rover.
  virtual std::optional<Obstacle> obstacle(const std::string& rover_id) const = 0;
  virtual SkyView sky(const Geodetic& place) const = 0;
  // Line of sight between two of rovers, assets and Earth, as last evaluated.
  virtual std::optional<PairSight> sight(const std::string& id, const std::string& other) const = 0;
};

}  // namespace lsos
