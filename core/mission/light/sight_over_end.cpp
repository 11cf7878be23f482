#include "mission/light/sight_over_end.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/rounded_distance.h"
#include "base/units.h"
#include "planet/site_frame.h"

namespace lsos {

std::string end_text(const GroundEnd& end, const std::string& seen, double elevation_rad) {
  return fmt::format(
      "the ground ends {} away towards {}, {:.1f} deg high, which ground up to {} "
      "away may hide",
      rounded_distance(end.reaches_m), seen, degrees(elevation_rad),
      rounded_distance(end.matters_m));
}

void SightOverEnd::add(const std::optional<GroundEnd>& end, double elevation_rad,
                       const std::string& id, SimTime now) {
  ++sight_count_;
  if (!end) return;
  ++over_end_count_;
  if (end->matters_m <= matters_m_) return;
  id_ = id;
  time_ = now;
  reaches_m_ = end->reaches_m;
  matters_m_ = end->matters_m;
  elevation_rad_ = elevation_rad;
}

void SightOverEnd::add_towards(const Vec3& eye_S_m, const Vec3& direction_S, double disc_rad,
                               const std::string& id, SimTime now) {
  add(probe_.towards(eye_S_m, direction_S, disc_rad),
      std::asin(std::clamp(direction_S.dot(probe_.site().up_S(eye_S_m)), -1.0, 1.0)), id, now);
}

void SightOverEnd::add_between(const Vec3& from_S_m, const Vec3& to_S_m, const std::string& id,
                               SimTime now) {
  add(probe_.between(from_S_m, to_S_m), 0, id, now);
  elevation_rad_.reset();
}

std::optional<std::string> SightOverEnd::warning(Instant start) const {
  if (over_end_count_ == 0) return {};
  const GroundEnd end{reaches_m_, matters_m_};
  const double share = static_cast<double>(over_end_count_) / static_cast<double>(sight_count_);
  const std::string where =
      elevation_rad_ ? end_text(end, seen_, *elevation_rad_)
                     : fmt::format("the ground is not known from {} away on, on a line of {}",
                                   rounded_distance(reaches_m_), rounded_distance(matters_m_));
  return fmt::format(
      "{} of {}: in {} of {} looks ({:.0f} %) that saw {}, ground that is not known "
      "could have hidden it; at the most, at {}, {}; TerrainBeyond lays a coarser "
      "terrain around the ground",
      seen_ == "the Sun" ? "light" : "sight", id_, over_end_count_, sight_count_,
      std::max(1.0, std::floor(100 * share)), seen_, format_utc(start + time_), where);
}

}  // namespace lsos
