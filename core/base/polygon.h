// Plane geometry of closed rings of corners: what lies in them, how far they are, and whether they
// touch.
#pragma once

#include <vector>

#include "base/vector.h"

namespace lsos {

using Ring = std::vector<Vec2>;  // corners in order, each once; three or more

// The end of the side that begins at corner `i`.
inline const Vec2& after(const Ring& ring, std::size_t i) { return ring[(i + 1) % ring.size()]; }

// Positive where b points to the left of a.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

// Whether the point lies in the ring, by the number of sides that a ray crosses. Either answer is
// right for a point on a side.
bool contains(const Ring& ring, const Vec2& p_m);

// The place on the straight line from a to b that is nearest to the point.
Vec2 nearest_on_segment(const Vec2& a_m, const Vec2& b_m, const Vec2& p_m);
// The place on the ring's sides that is nearest to the point.
Vec2 nearest_on_ring(const Ring& ring, const Vec2& p_m);

// Shortest distance between two straight lines; 0 where they cross.
double segment_distance_m(const Vec2& a_m, const Vec2& b_m, const Vec2& c_m, const Vec2& d_m);
// Shortest distance from a straight line to the ring's sides.
double ring_distance_m(const Ring& ring, const Vec2& a_m, const Vec2& b_m);

// Whether any side of one meets a side of the other.
bool do_touch(const Ring& a, const Ring& b);
// Whether two sides that are not neighbours lead through each other.
bool crosses_itself(const Ring& ring);
// Whether two sides that are not neighbours share a place, crossed or not.
bool touches_itself(const Ring& ring);

// Twice the area, positive where the corners go round counter-clockwise.
double doubled_area_m2(const Ring& ring);

}  // namespace lsos
