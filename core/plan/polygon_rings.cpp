#include "plan/polygon_rings.h"

#include <fmt/format.h>

#include <cmath>

#include "base/polygon.h"

namespace lsos {

namespace {

// Orthographic projection of the corners onto the plane that touches the unit sphere at `about`.
// In longitude and latitude, a polygon could contain neither a pole nor the antimeridian.
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

std::string self_fault(const Ring& ring) {
  if (crosses_itself(ring)) return "crosses itself";
  return touches_itself(ring) ? "touches itself" : "";
}

}  // namespace

double outside_m(const Body& body, const std::vector<Geodetic>& outline, const Geodetic& place) {
  const Ring ring = on_plane(outline, place);
  const Vec2 here(0, 0);
  return contains(ring, here) ? 0 : nearest_on_ring(ring, here).norm() * body.equatorial_radius_m;
}

std::string outline_fault(const std::vector<Geodetic>& outline) {
  return self_fault(on_plane(outline, outline.front()));
}

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
    if (const std::string fault = self_fault(ring); !fault.empty()) return fault;
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
