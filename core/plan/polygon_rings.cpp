#include "plan/polygon_rings.h"

#include <fmt/format.h>

#include <cmath>

#include "base/polygon.h"

namespace lsos {

namespace {

// Corners on the plane that touches the unit sphere at a place, seen from infinity: in lon and lat
// alone neither the antimeridian nor a pole could lie in a polygon.
Ring on_plane(const std::vector<Geodetic>& corners, const Geodetic& about) {
  Ring ring;
  for (const Geodetic& corner : corners) {
    const double away_rad = corner.lon_rad - about.lon_rad;
    ring.emplace_back(std::cos(corner.lat_rad) * std::sin(away_rad),
                      std::cos(about.lat_rad) * std::sin(corner.lat_rad) -
                          std::sin(about.lat_rad) * std::cos(corner.lat_rad) * std::cos(away_rad));
  }
  return ring;
}

}  // namespace

std::string hole_fault(const std::vector<Geodetic>& outline,
                       const std::vector<std::vector<Geodetic>>& holes, std::size_t& hole) {
  const Ring outer = on_plane(outline, outline.front());
  std::vector<Ring> inner;
  for (hole = 0; hole < holes.size(); ++hole) {
    inner.push_back(on_plane(holes[hole], outline.front()));
    const Ring& ring = inner.back();
    if (do_touch(ring, outer)) {
      return "touches or crosses its outline; a hole lies inside, and what reaches the edge is cut "
             "out of the outline";
    }
    if (!contains(outer, ring.front())) return "lies outside its outline";
    if (crosses_itself(ring)) return "crosses itself";
    for (std::size_t other = 0; other < hole; ++other) {
      const std::string name = fmt::format("hole {}", other + 1);
      if (do_touch(ring, inner[other])) {
        return fmt::format("touches or crosses {}; draw both as one hole", name);
      }
      if (contains(inner[other], ring.front())) return fmt::format("lies in {}", name);
      if (contains(ring, inner[other].front())) {
        return fmt::format("has {} in it; nothing is kept within a hole", name);
      }
    }
  }
  return "";
}

}  // namespace lsos
