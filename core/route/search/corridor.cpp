#include "route/search/corridor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lsos {

namespace {

constexpr double squares_off = 4;

}  // namespace

Corridor::Corridor(const GroundMap& map, const Line2& line, double off_m)
    : low_m_(map.low_m()), square_m_(off_m / squares_off) {
  const Vec2 high_m = map.place_m(map.columns() - 1, map.rows() - 1);
  const Vec2 squares = (high_m - low_m_) / square_m_;
  columns_ = static_cast<std::size_t>(squares.x()) + 1;
  rows_ = static_cast<std::size_t>(squares.y()) + 1;
  is_in_.resize(columns_ * rows_, false);
  // Points of the line are at most a square apart. A square belongs to the corridor if its middle
  // is within `reach_m` of one: half a square and half its diagonal more than `off_m`.
  const double reach_m = off_m + square_m_ / 2 + square_m_ / std::numbers::sqrt2;
  const auto mark = [&](const Vec2& about_m) {
    const Vec2 low = (about_m - low_m_ - Vec2::Constant(reach_m)) / square_m_;
    const Vec2 high = (about_m - low_m_ + Vec2::Constant(reach_m)) / square_m_;
    const auto row_first = static_cast<std::size_t>(std::max(0.0, low.y()));
    const auto row_last = std::min(rows_ - 1, static_cast<std::size_t>(std::max(0.0, high.y())));
    for (std::size_t row = row_first; row <= row_last; ++row) {
      const auto first = static_cast<std::size_t>(std::max(0.0, low.x()));
      const auto last = std::min(columns_ - 1, static_cast<std::size_t>(std::max(0.0, high.x())));
      for (std::size_t column = first; column <= last; ++column) {
        const Vec2 middle_m = low_m_ + square_m_ * Vec2(static_cast<double>(column) + 0.5,
                                                        static_cast<double>(row) + 0.5);
        if ((middle_m - about_m).norm() < reach_m) is_in_[row * columns_ + column] = true;
      }
    }
  };
  mark(line.front());
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const Vec2 delta_m = line[k + 1] - line[k];
    const int pieces = std::max(1, static_cast<int>(std::ceil(delta_m.norm() / square_m_)));
    for (int piece = 1; piece <= pieces; ++piece) mark(line[k] + delta_m * piece / pieces);
  }
}

}  // namespace lsos
