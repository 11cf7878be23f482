// What a rover knows of all that is not it: others as they were at the last exchange.
#pragma once

#include <optional>
#include <string>

#include "mission/port/rover_port.h"
#include "planet/site_frame.h"

namespace lsos {

class Surroundings {
 public:
  virtual ~Surroundings() = default;

  // Of a rover or an asset; absent: there is none with that id.
  virtual std::optional<Vec3> place_S_m(const std::string& id) const = 0;
  virtual SkyView sky(const Geodetic& place) const = 0;
  // Between two of rovers, assets and Earth, when they were last looked at.
  virtual std::optional<PairSight> sight(const std::string& id, const std::string& other) const = 0;
};

}  // namespace lsos
