// Corridor around a line, to which a search that is to improve the line is restricted.
#pragma once

#include <algorithm>
#include <vector>

#include "route/cost/route_cost.h"

namespace lsos {

// All places within `off_m` of the line, and some up to half as far again, since the corridor is
// stored in squares.
class Corridor {
 public:
  Corridor(const GroundMap& map, const Line2& line, double off_m);

  // Whether a place on the map lies in the corridor; beyond the edges of the map as at them.
  bool holds(const Vec2& at_m) const { return is_in_[index(at_m)]; }

 private:
  std::size_t index(const Vec2& at_m) const {
    const Vec2 squares = ((at_m - low_m_) / square_m_).cwiseMax(0.0);
    const auto column = std::min(static_cast<std::size_t>(squares.x()), columns_ - 1);
    const auto row = std::min(static_cast<std::size_t>(squares.y()), rows_ - 1);
    return row * columns_ + column;
  }

  Vec2 low_m_;
  double square_m_;
  std::size_t columns_, rows_;
  std::vector<bool> is_in_;
};

}  // namespace lsos
