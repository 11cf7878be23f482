// Lines of sight to the Sun, Earth or other antennas that pass over the end of the known ground:
// ground that is not known may hide what counts as visible.
#pragma once

#include <optional>
#include <string>

#include "base/archive.h"
#include "planet/utc.h"
#include "view/ground/ground_end.h"

namespace lsos {

class SightOverEnd {
 public:
  // `ground` must outlive it. `seen`: name of the target in messages, as "the Sun".
  SightOverEnd(const Ground& ground, std::string seen) : probe_(ground), seen_(std::move(seen)) {}

  // Counts a disc about a direction (unit, site axes) that is visible from `eye_S_m`; `id`: the
  // observer.
  void add_towards(const Vec3& eye_S_m, const Vec3& direction_S, double disc_rad,
                   const std::string& id, SimTime now);
  // Counts an antenna that is visible from another.
  void add_between(const Vec3& from_S_m, const Vec3& to_S_m, const std::string& id, SimTime now);
  // Names the line of sight that ground farthest away could hide; absent: none passed over the end.
  std::optional<std::string> warning(Instant start) const;

  void archive(Archive& a) {
    a.tag("over_end");
    LSOS_ARCHIVE(a, sight_count_, over_end_count_, id_, time_, reaches_m_, matters_m_,
                 elevation_rad_);
  }

 private:
  void add(const std::optional<GroundEnd>& end, double elevation_rad, const std::string& id,
           SimTime now);

  GroundEndProbe probe_;
  std::string seen_;
  std::int64_t sight_count_ = 0, over_end_count_ = 0;
  std::string id_;
  SimTime time_{};
  double reaches_m_ = 0, matters_m_ = 0;
  std::optional<double> elevation_rad_;  // elevation of a disc; absent for antennas
};

// "the ground ends 480 m away towards the Sun, 5.2 deg high, which ground up to 94 km away may
// hide"
std::string end_text(const GroundEnd& end, const std::string& seen, double elevation_rad);

}  // namespace lsos
