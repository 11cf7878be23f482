#include "terrain/rock_tile.h"

#include <algorithm>
#include <cmath>

#include "terrain/rocks.h"

namespace lsos {

namespace {

constexpr int cells = HeightTile::cells;

}  // namespace

void RockTile::add(const PlacedRock& rock) { rocks_.push_back(rock); }

void RockTile::finish() {
  std::array<std::vector<std::uint32_t>, std::size_t{squares} * squares> lists;
  const auto square = [](double at) {
    return std::clamp(static_cast<int>(std::floor(at / square_cells)), 0, squares - 1);
  };
  for (std::uint32_t k = 0; k < rocks_.size(); ++k) {
    const PlacedRock& r = rocks_[k];
    if (r.U + r.half_U < 0 || r.U - r.half_U > cells) continue;
    if (r.V + r.half_V < 0 || r.V - r.half_V > cells) continue;
    for (int j = square(r.V - r.half_V); j <= square(r.V + r.half_V); ++j) {
      for (int i = square(r.U - r.half_U); i <= square(r.U + r.half_U); ++i) {
        lists[static_cast<std::size_t>(j * squares + i)].push_back(k);
      }
    }
  }
  for (std::size_t k = 0; k < lists.size(); ++k) {
    in_square_.insert(in_square_.end(), lists[k].begin(), lists[k].end());
    first_[k + 1] = static_cast<std::uint32_t>(in_square_.size());
  }
}

SurfaceHeight RockTile::at(const CellPoint& at) const {
  SurfaceHeight sum{0, 0, 0};
  if (rocks_.empty()) return sum;
  const int i = static_cast<int>(at.column & (cells - 1));
  const int j = static_cast<int>(at.row & (cells - 1));
  const double U = i + at.along_u, V = j + at.along_v;
  const int square = j / square_cells * squares + i / square_cells;
  for (std::uint32_t k = first_[square]; k < first_[square + 1]; ++k) {
    const PlacedRock& r = rocks_[in_square_[k]];
    const double away_U = U - r.U, away_V = V - r.V;
    const double by_U = r.a * away_U + r.b * away_V, by_V = r.b * away_U + r.c * away_V;
    const double q = by_U * away_U + by_V * away_V;
    if (q >= 1) continue;
    const RockShape shape = rock_shape(q);
    sum.height_m += r.height_m * shape.height;
    sum.by_u_m += 2 * r.height_m * shape.by_q * by_U;
    sum.by_v_m += 2 * r.height_m * shape.by_q * by_V;
  }
  return sum;
}

}  // namespace lsos
