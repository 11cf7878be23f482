#include "terrain/detail.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <tuple>

#include "terrain/crater_rows.h"
#include "terrain/rocks.h"

namespace lsos {

namespace {

constexpr int cells = HeightTile::cells;
constexpr int nodes = HeightTile::nodes;
constexpr int first_node = HeightTile::first_node;

// A power of two, so that cells and tiles end together; eight at least, for the correction of a
// cell's mean needs room inside it; 512 at most: beyond, a cell takes too long to look through.
int subdivision_for(double cell_m, double spacing_m) {
  const double wanted = std::round(std::log2(cell_m / spacing_m));
  return 1 << static_cast<int>(std::clamp(wanted, 3.0, 9.0));
}

NodeLattice nodes_of(const TileKey& key) {
  const std::int64_t stride = std::int64_t{1} << key.level;
  return {(key.column * cells + first_node) * stride, (key.row * cells + first_node) * stride,
          stride, key.level};
}

// Integral of the Catmull-Rom cubics through equidistant nodes over the cell between nodes 0 and 1,
// by the values at -1, 0, 1, 2.
constexpr double integral_weights[] = {-1.0 / 24, 13.0 / 24, 13.0 / 24, -1.0 / 24};

// Weight of each node in the integral over the cells [from, to) of one axis.
std::array<double, nodes> axis_weights(int from, int to) {
  std::array<double, nodes> weights{};
  for (int cell = from; cell < to; ++cell) {
    for (int k = 0; k < 4; ++k) weights[cell - 1 - first_node + k] += integral_weights[k];
  }
  return weights;
}

// Of the surface through the nodes over the square of cells from (column, row) on, in cells^2.
double integral(const HeightTile& tile, int column, int row, int size) {
  const auto by_column = axis_weights(column, column + size);
  const auto by_row = axis_weights(row, row + size);
  double sum = 0;
  for (int j = row; j < row + size + 3; ++j) {
    double line = 0;
    for (int i = column; i < column + size + 3; ++i) {
      line += by_column[i] * tile.height_m(i + first_node, j + first_node);
    }
    sum += by_row[j] * line;
  }
  return sum;
}

// A smooth ring within a cell of `size` nodes a side: zero at its centre, at its edge and at the
// nodes next to the edge, so that the surface beyond the edge does not feel it; where only every
// 2^level-th node is looked at, what those feel beyond a tile is left out. With s and t from
// -1 to 1 it is (1 - s^2)^2 (1 - t^2)^2 (s^2 + t^2); of node i along one axis:
struct RingAxis {
  RingAxis(int size, std::int64_t i) {
    const double half = size / 2.0, s = (static_cast<double>(i) - half) / (half - 1);
    if (std::abs(s) >= 1) return;
    low = (1 - s * s) * (1 - s * s);
    high = low * s * s;
  }
  double low = 0, high = 0;
};

double ring(const RingAxis& u, const RingAxis& v) { return u.high * v.low + u.low * v.high; }

// Over every `stride`-th node of a cell.
double ring_mean(int size, int stride) {
  double low = 0, high = 0;
  for (int i = 0; i < size; i += stride) {
    const RingAxis axis(size, i);
    low += axis.low;
    high += axis.high;
  }
  const int count = size / stride;
  return 2 * low * high / count / count;
}

std::array<double, 4> catmull_rom(double t) {
  const double t2 = t * t, t3 = t2 * t;
  return {0.5 * (2 * t2 - t3 - t), 0.5 * (3 * t3 - 5 * t2) + 1, 0.5 * (4 * t2 - 3 * t3 + t),
          0.5 * (t3 - t2)};
}

}  // namespace

DetailField::DetailField(const Detail& detail, const HeightGrid& grid, const Stereographic& map,
                         const DetailSetting& setting, std::uint64_t seed)
    : detail_(detail),
      grid_(grid),
      map_(map),
      setting_(setting),
      seed_(seed),
      subdivision_(subdivision_for(setting.cell_m, detail.spacing_m)),
      period_(grid.extent().goes_around() ? std::llround(grid.extent().period) * subdivision_ : 0),
      exact_{[this](const PlanePoint& at) { return grid_.coordinates(map_.place(at)); },
             grid.extent().period},
      patches_([this](const PatchKey& key) { return Patch(key, exact_); }) {
  if (detail_.roughness) {
    Roughness roughness = *detail_.roughness;
    // Longer waves are the grid's own.
    if (setting_.keeps_cells)
      roughness.longest_m = std::min(roughness.longest_m, 2 * setting.cell_m);
    roughness_.emplace(roughness, seed, RoughGrid{spacing_m(), setting_.height_to_width, period_});
  }
}

// Of a point of the finer grid, on the map of landforms.
std::optional<PlanePoint> DetailField::map_point(double U, double V) const {
  const auto place = grid_.place({U / subdivision_ - 0.5, V / subdivision_ - 0.5});
  return place ? std::optional(map_.at(*place)) : std::nullopt;
}

// Of all that may reach the nodes, on the map of landforms.
PlaneRectangle DetailField::rectangle(const NodeLattice& at) const {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  PlaneRectangle box{{infinite, infinite}, {-infinite, -infinite}};
  const double reach = static_cast<double>((nodes - 1) * at.stride) / 4;
  bool is_cut = false;
  for (int j = 0; j <= 4; ++j) {
    for (int i = 0; i <= 4; ++i) {
      const auto p = map_point(static_cast<double>(at.column) + i * reach,
                               static_cast<double>(at.row) + j * reach);
      is_cut |= !p;
      if (!p) continue;
      box.low = {std::min(box.low.x_m, p->x_m), std::min(box.low.y_m, p->y_m)};
      box.high = {std::max(box.high.x_m, p->x_m), std::max(box.high.y_m, p->y_m)};
    }
  }
  if (box.low.x_m > box.high.x_m) return {};
  // Between the points looked at, the edge may bulge; at the map's end one more may just miss it.
  double margin_m = 0.05 * std::max(box.high.x_m - box.low.x_m, box.high.y_m - box.low.y_m);
  if (is_cut) {
    const double stretch = std::max(setting_.height_to_width, 1 / setting_.height_to_width);
    margin_m += reach * spacing_m() * std::sqrt(2 * stretch);
  }
  box.low = {box.low.x_m - margin_m, box.low.y_m - margin_m};
  box.high = {box.high.x_m + margin_m, box.high.y_m + margin_m};
  return box;
}

std::optional<GridPoint> DetailField::grid_point(const PlanePoint& at) const {
  const auto patch = patches_.patch(at);
  return patch->is_good() ? std::optional(patch->at(at)) : exact_grid_point(exact_, at);
}

// The same column, counted next to the tile where the grid goes around.
double DetailField::near_tile(double U, const NodeLattice& at) const {
  if (period_ == 0) return U;
  const std::int64_t middle = nodes / 2;
  const auto centre = static_cast<double>(at.column + middle * at.stride);
  const auto period = static_cast<double>(period_);
  return U - period * std::round((U - centre) / period);
}

double DetailField::largest_crater_m() const {
  const double largest_m = std::min(detail_.craters->diameter_max_m, setting_.crater_max_m);
  return setting_.keeps_cells ? std::min(largest_m, 2 * setting_.cell_m) : largest_m;
}

std::vector<Crater> DetailField::craters(const NodeLattice& at) const {
  const double largest_m = largest_crater_m();
  // A smaller one is a stray node or none.
  const double smallest_m = 2 * std::ldexp(spacing_m(), at.level);
  const auto touching = [&](const PlaneRectangle& area) {
    return craters_touching(*detail_.craters, seed_, area, smallest_m, largest_m);
  };
  constexpr std::int64_t near = 64;
  if (at.stride <= near << at.level) return touching(rectangle(at));
  // Between nodes far apart lie very many that touch none of them.
  std::vector<Crater> found;
  for (int j = 0; j < nodes; ++j) {
    for (int i = 0; i < nodes; ++i) {
      const auto node = map_point(static_cast<double>(at.column + i * at.stride),
                                  static_cast<double>(at.row + j * at.stride));
      if (!node) continue;
      const auto here = touching({*node, *node});
      found.insert(found.end(), here.begin(), here.end());
    }
  }
  const auto key = [](const Crater& c) {
    return std::tuple(c.diameter_m, c.centre.x_m, c.centre.y_m);
  };
  std::ranges::sort(found, {}, key);
  const auto is_same = [&](const Crater& a, const Crater& b) { return key(a) == key(b); };
  found.erase(std::unique(found.begin(), found.end(), is_same), found.end());
  return found;
}

void DetailField::add_craters(HeightTile& tile, const NodeLattice& at) const {
  const auto stride = static_cast<double>(at.stride);
  for (const Crater& crater : craters(at)) {
    const auto centre = grid_point(crater.centre);
    if (!centre) continue;
    const double N = subdivision_;
    // Nodes of the tile, from its first.
    const double U = (near_tile(fine(centre->u), at) - static_cast<double>(at.column)) / stride;
    const double V = (fine(centre->v) - static_cast<double>(at.row)) / stride;
    const double radius_m = crater.diameter_m / 2, reach_m = crater_reach * radius_m;
    const double half_V = reach_m * N / stride * std::hypot(centre->v_by_x, centre->v_by_y);
    const int j_low = static_cast<int>(std::max(0.0, std::ceil(V - half_V)));
    const int j_high = static_cast<int>(std::min(nodes - 1.0, std::floor(V + half_V)));
    // From nodes to radii.
    const double det = centre->u_by_x * centre->v_by_y - centre->u_by_y * centre->v_by_x;
    const double k = stride / (det * N * radius_m);
    const double x_by_U = k * centre->v_by_y, x_by_V = -k * centre->u_by_y;
    const double y_by_U = -k * centre->v_by_x, y_by_V = k * centre->u_by_x;
    // The part of a row within reach, about the point of the row that is nearest to the centre.
    const double growth = x_by_U * x_by_U + y_by_U * y_by_U;
    for (int j = j_low; j <= j_high; ++j) {
      double* row_m = &tile.height_m(first_node, j + first_node);
      const double x_V = x_by_V * (j - V), y_V = y_by_V * (j - V);
      const double nearest = U - (x_by_U * x_V + y_by_U * y_V) / growth;
      const double across = x_by_U * y_V - y_by_U * x_V;
      const double left = crater_reach * crater_reach - across * across / growth;
      if (left <= 0) continue;
      const double half = std::sqrt(left / growth);
      const int i_low = static_cast<int>(std::max(0.0, std::ceil(nearest - half)));
      const int i_high = static_cast<int>(std::min(nodes - 1.0, std::floor(nearest + half)));
      const CraterLine line{x_V - x_by_U * U, y_V - y_by_U * U, x_by_U, y_by_U};
      add_crater(row_m, i_low, i_high, line, crater.depth_m, crater.rim_m);
    }
  }
}

void DetailField::add_rocks(RockTile& tile, const NodeLattice& at) const {
  const double smallest_m = at.level == 0 ? 0 : 2 * std::ldexp(spacing_m(), at.level);
  for (const Rock& rock : rocks_touching(*detail_.rocks, seed_, rectangle(at), smallest_m)) {
    const auto centre = grid_point(rock.centre);
    if (!centre) continue;
    const double N = subdivision_ / static_cast<double>(at.stride), radius_m = rock.diameter_m / 2;
    RockTile::PlacedRock placed;
    const auto stride = static_cast<double>(at.stride);
    placed.U =
        (near_tile(fine(centre->u), at) - static_cast<double>(at.column)) / stride + first_node;
    placed.V = (fine(centre->v) - static_cast<double>(at.row)) / stride + first_node;
    const double det = centre->u_by_x * centre->v_by_y - centre->u_by_y * centre->v_by_x;
    const double k = 1 / (det * N * radius_m);
    const double x_by_U = k * centre->v_by_y, x_by_V = -k * centre->u_by_y;
    const double y_by_U = -k * centre->v_by_x, y_by_V = k * centre->u_by_x;
    placed.a = x_by_U * x_by_U + y_by_U * y_by_U;
    placed.b = x_by_U * x_by_V + y_by_U * y_by_V;
    placed.c = x_by_V * x_by_V + y_by_V * y_by_V;
    placed.height_m = rock.height_m;
    placed.half_U = radius_m * N * std::hypot(centre->u_by_x, centre->u_by_y);
    placed.half_V = radius_m * N * std::hypot(centre->v_by_x, centre->v_by_y);
    tile.add(placed);
  }
  tile.finish();
}

HeightTile DetailField::raw(const TileKey& key, const NodeLattice& at) const {
  HeightTile tile(key);
  tile.set_ground_everywhere();
  if (roughness_) roughness_->add_to(tile, at);
  if (detail_.craters) add_craters(tile, at);
  return tile;
}

namespace {

// Where the nodes of one axis fall among the grid's nodes: the first of four that the cubic through
// them takes, counted from `low`, and its weights.
struct CentreAxis {
  CentreAxis(std::int64_t first, std::int64_t stride, int subdivision) {
    const double per_node = 1.0 / subdivision;
    for (int k = 0; k < nodes; ++k) {
      const CellPoint cell(static_cast<double>(first + k * stride) * per_node - 0.5, 0);
      if (k == 0) low = cell.column - 1;
      start[k] = static_cast<int>(cell.column - 1 - low);
      weights[k] = catmull_rom(cell.along_u);
    }
    count = start[nodes - 1] + 4;
  }
  std::int64_t low = 0;
  int count = 0;
  std::array<int, nodes> start{};
  std::array<std::array<double, 4>, nodes> weights{};
};

}  // namespace

// The raw heights less a smooth surface through them at the grid's nodes.
HeightTile DetailField::zero_at_centres(const TileKey& key) const {
  const NodeLattice at = nodes_of(key);
  HeightTile tile = raw(key, at);
  const CentreAxis columns(at.column, at.stride, subdivision_);
  const CentreAxis rows(at.row, at.stride, subdivision_);
  std::shared_ptr<const HeightTile> kept;
  const auto centre_m = [&](std::int64_t column, std::int64_t row) {
    const TileKey wanted{column >> CellPoint::tile_bits, row >> CellPoint::tile_bits, key.level};
    if (!kept || kept->key() != wanted)
      kept = centres_.get(wanted, [this](const TileKey& of) {
        const std::int64_t N = subdivision_;
        return raw(of, {(of.column * cells + first_node) * N + N / 2,
                        (of.row * cells + first_node) * N + N / 2, N, of.level});
      });
    return kept->height_m(static_cast<int>(column & (cells - 1)),
                          static_cast<int>(row & (cells - 1)));
  };
  std::vector<double> values(static_cast<std::size_t>(columns.count));
  std::vector<std::array<double, nodes>> lines(static_cast<std::size_t>(rows.count));
  for (int j = 0; j < rows.count; ++j) {
    for (int i = 0; i < columns.count; ++i) {
      values[static_cast<std::size_t>(i)] = centre_m(columns.low + i, rows.low + j);
    }
    for (int k = 0; k < nodes; ++k) {
      const double* v = &values[static_cast<std::size_t>(columns.start[k])];
      const auto& w = columns.weights[k];
      lines[static_cast<std::size_t>(j)][k] =
          w[0] * v[0] + w[1] * v[1] + (w[2] * v[2] + w[3] * v[3]);
    }
  }
  for (int k = 0; k < nodes; ++k) {
    const auto* line = &lines[static_cast<std::size_t>(rows.start[k])];
    const auto& w = rows.weights[k];
    double* row_m = &tile.height_m(first_node, k + first_node);
    for (int i = 0; i < nodes; ++i) {
      row_m[i] -= w[0] * line[0][i] + w[1] * line[1][i] + (w[2] * line[2][i] + w[3] * line[3][i]);
    }
  }
  return tile;
}

// Over a cell of the grid that is larger than a tile of that level.
double DetailField::mean_of_cell_m(const TileKey& cell) const {
  return *means_.get(cell, [this](const TileKey& wanted) {
    const int N = subdivision_ >> wanted.level, across = N / cells;
    double sum = 0;
    for (int j = 0; j < across; ++j) {
      for (int i = 0; i < across; ++i) {
        const TileKey key{wanted.column * across + i, wanted.row * across + j, wanted.level};
        sum += integral(zero_at_centres(key), 0, 0, cells);
      }
    }
    return sum / N / N;
  });
}

void DetailField::correct_means(HeightTile& tile) const {
  const int level = tile.key().level;
  const int N = subdivision_ >> level;  // of this level's nodes a cell
  if (N < 4) return;                    // all at cells' centres and edges: the ring is zero there
  const int size = std::min(N, cells);  // of a cell's part in this tile
  const double per_ring = 1 / ring_mean(subdivision_, 1 << level);
  const HeightTile before = tile;
  for (int row = 0; row < cells; row += size) {
    for (int column = 0; column < cells; column += size) {
      const std::int64_t U = tile.key().column * cells + column;
      const std::int64_t V = tile.key().row * cells + row;
      const TileKey cell{U >> std::countr_zero(static_cast<unsigned>(N)),
                         V >> std::countr_zero(static_cast<unsigned>(N)), level};
      const double mean_m =
          N <= cells ? integral(before, column, row, N) / N / N : mean_of_cell_m(cell);
      // Nodes next to the part belong to it where the cell goes on beyond the tile.
      for (int j = -1; j <= size + 1; ++j) {
        const RingAxis of_row(subdivision_, (V + j - cell.row * N) << level);
        for (int i = -1; i <= size + 1; ++i) {
          if (N <= cells && (i < 0 || j < 0 || i >= size || j >= size)) continue;
          const RingAxis of_column(subdivision_, (U + i - cell.column * N) << level);
          tile.height_m(column + i, row + j) -= mean_m * per_ring * ring(of_column, of_row);
        }
      }
    }
  }
}

double DetailField::largest_m() const {
  double largest_m = detail_.roughness ? detail_.roughness->longest_m : 0;
  if (setting_.keeps_cells) largest_m = std::min(largest_m, 2 * setting_.cell_m);
  if (detail_.craters) largest_m = std::max(largest_m, largest_crater_m());
  return detail_.rocks ? std::max(largest_m, detail_.rocks->diameter_max_m) : largest_m;
}

DetailTile DetailField::tile(const TileKey& key) const {
  DetailTile tile(key);
  if (setting_.keeps_cells) {
    tile.heights = zero_at_centres(key);
    correct_means(tile.heights);
  } else {
    tile.heights = raw(key, nodes_of(key));
  }
  if (detail_.rocks) add_rocks(tile.rocks, nodes_of(key));
  return tile;
}

}  // namespace lsos
