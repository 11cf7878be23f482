// Plane geometry of closed rings: containment, distances, and intersections.
#pragma once

#include <vector>

#include "base/segment.h"

namespace lsos {

using Ring = std::vector<Vec2>;  // vertices in order, each once; three or more

// The end of the side that begins at vertex `i`.
inline const Vec2& after(const Ring& ring, std::size_t i) { return ring[(i + 1) % ring.size()]; }

// Whether the point lies in the ring, by counting the sides that a ray crosses. For a point on a
// side the result may be either.
bool contains(const Ring& ring, const Vec2& p_m);

// The point of the segment from a to b that is nearest to p.
Vec2 nearest_on_segment(const Vec2& a_m, const Vec2& b_m, const Vec2& p_m);
// The point on the ring's sides that is nearest to p.
Vec2 nearest_on_ring(const Ring& ring, const Vec2& p_m);

// Shortest distance between the segments ab and cd; 0 where they cross.
double segment_distance_m(const Vec2& a_m, const Vec2& b_m, const Vec2& c_m, const Vec2& d_m);
// Shortest distance from the segment ab to the ring's sides.
double ring_distance_m(const Ring& ring, const Vec2& a_m, const Vec2& b_m);

// Whether any side of one ring meets a side of the other.
bool do_touch(const Ring& a, const Ring& b);
// Whether two sides that are not neighbours cross properly.
bool crosses_itself(const Ring& ring);
// Whether two sides that are not neighbours share a point, crossing or touching.
bool touches_itself(const Ring& ring);

// Twice the signed area, positive for counter-clockwise rings.
double doubled_area_m2(const Ring& ring);

}  // namespace lsos
