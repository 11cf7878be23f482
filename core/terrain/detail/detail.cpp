#include "terrain/detail/detail.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/rounding.h"
#include "terrain/detail/crater_rows.h"
#include "terrain/detail/rocks.h"

namespace lsos {

namespace {

constexpr int cells = HeightTile::cells;
constexpr int nodes = HeightTile::nodes;
constexpr int first_node = HeightTile::first_node;

// Longest wave of roughness over a raster, in cells, for the reason given at largest_over_raster().
constexpr double longest_wave_cells = 0.5;
// Craters and rocks smaller than this are so many that their mean stands for what they add at the
// raster's scale.
constexpr double smallest_counted_cells = 1.0 / 8;

// Craters of fewer nodes are kept as exact shapes: nodes would make squares of them. On levels
// above 0 nodes serve all craters.
constexpr double nodes_across_crater = 8;

// Nodes per cell: a power of two, so that cells and tiles end together; at least 8, so that nodes
// hold the waves of a quarter cell that count on the lattice of half a cell; at most 512: beyond, a
// cell takes too long to compute.
int subdivision_for(double cell_m, double spacing_m) {
  const double wanted = std::round(std::log2(cell_m / spacing_m));
  return 1 << static_cast<int>(std::clamp(wanted, 3.0, 9.0));
}

NodeLattice nodes_of(const TileKey& key) {
  const std::int64_t stride = std::int64_t{1} << key.level;
  return {(key.column * cells + first_node) * stride, (key.row * cells + first_node) * stride,
          stride, key.level};
}

NodeRectangle rectangle(const NodeLattice& at) {
  const auto U = static_cast<double>(at.column), V = static_cast<double>(at.row);
  const auto across = static_cast<double>((nodes - 1) * at.stride);
  return {U, V, U + across, V + across};
}

}  // namespace

TileTop tile_top(const DetailTile& tile) {
  TileTop top = tile_top(tile.heights);
  for (std::size_t square = 0; square < top.highest_m.size(); ++square) {
    top.highest_m[square] += tile.craters.top_m(square) + tile.rocks.top_m(square);
  }
  return top;
}

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
  const double own_m = setting.is_over_raster ? largest_over_raster(setting.cell_m) : 1e9;
  if (detail_.craters) {
    largest_crater_m_ = std::min({detail_.craters->diameter_max_m, setting.crater_max_m, own_m});
  }
  if (detail_.rocks) largest_rock_m_ = std::min(detail_.rocks->diameter_max_m, own_m);
  if (detail_.roughness) {
    Roughness& roughness = *detail_.roughness;
    if (setting.is_over_raster) {
      roughness.longest_m = std::min(roughness.longest_m, longest_wave_cells * setting.cell_m);
    }
    roughness_.emplace(roughness, seed,
                       RoughnessGrid{spacing_m(), setting.height_to_width, period_});
  }
  if (setting.is_over_raster) set_lattice();
}

// Sets the lattice's spacing to half a cell, as square on the ground as powers of two allow; where
// the grid goes around the body, so does the lattice.
void DetailField::set_lattice() {
  const int half_cell_log2 = std::countr_zero(static_cast<unsigned>(subdivision_)) - 1;
  const double stretch_log2 = std::log2(setting_.height_to_width);
  lattice_column_log2_ = half_cell_log2 + static_cast<int>(std::lround(stretch_log2 / 2 + 0.25));
  lattice_row_log2_ = half_cell_log2 - static_cast<int>(std::lround(stretch_log2 / 2 - 0.25));
  if (period_ > 0) {
    const int whole_log2 = std::countr_zero(static_cast<std::uint64_t>(period_));
    lattice_column_log2_ = std::min(lattice_column_log2_, whole_log2);
  }
  lattice_column_log2_ = std::max(lattice_column_log2_, 0);
  lattice_row_log2_ = std::max(lattice_row_log2_, 0);
  const double high_m = smallest_counted_cells * setting_.cell_m;
  for (int level = 0; 2 * std::ldexp(spacing_m(), level) < high_m; ++level) {
    double mean_m = 0;
    if (detail_.craters) {
      mean_m += crater_volume_pm2(*detail_.craters, smallest_crater_m(level),
                                  std::min(high_m, largest_crater_m_));
    }
    if (detail_.rocks) {
      mean_m += rock_volume_pm2(*detail_.rocks, smallest_rock_m(level),
                                std::min(high_m, largest_rock_m_));
    }
    mean_of_small_m_.push_back(mean_m);
  }
}

// Point (U, V) of the finer grid, on the map of landforms.
std::optional<PlanePoint> DetailField::map_point(double U, double V) const {
  const auto place = grid_.place({U / subdivision_ - 0.5, V / subdivision_ - 0.5});
  return place ? std::optional(map_.at(*place)) : std::nullopt;
}

// Rectangle on the map of landforms that holds the piece of the finer grid.
PlaneRectangle DetailField::map_rectangle(const NodeRectangle& on_grid) const {
  PlaneRectangle box{{infinite, infinite}, {-infinite, -infinite}};
  const double U_step = (on_grid.U_high - on_grid.U_low) / 4;
  const double V_step = (on_grid.V_high - on_grid.V_low) / 4;
  bool is_cut = false;
  for (int j = 0; j <= 4; ++j) {
    for (int i = 0; i <= 4; ++i) {
      const auto p = map_point(on_grid.U_low + i * U_step, on_grid.V_low + j * V_step);
      is_cut |= !p;
      if (!p) continue;
      box.low = {std::min(box.low.x_m, p->x_m), std::min(box.low.y_m, p->y_m)};
      box.high = {std::max(box.high.x_m, p->x_m), std::max(box.high.y_m, p->y_m)};
    }
  }
  if (box.low.x_m > box.high.x_m) return {};
  // The edge may bulge between sampled points; at the map's end the next point may just miss it.
  double margin_m = 0.05 * std::max(box.high.x_m - box.low.x_m, box.high.y_m - box.low.y_m);
  if (is_cut) {
    const double stretch = std::max(setting_.height_to_width, 1 / setting_.height_to_width);
    margin_m += std::max(U_step, V_step) * spacing_m() * std::sqrt(2 * stretch);
  }
  box.low = {box.low.x_m - margin_m, box.low.y_m - margin_m};
  box.high = {box.high.x_m + margin_m, box.high.y_m + margin_m};
  return box;
}

std::optional<GridPoint> DetailField::grid_point(const PlanePoint& at) const {
  const auto patch = patches_.patch(at);
  return patch->is_good() ? std::optional(patch->at(at)) : exact_grid_point(exact_, at);
}

// Returns the same column, counted next to the tile where the grid goes around the body.
double DetailField::near_tile(double U, const NodeLattice& at) const {
  if (period_ == 0) return U;
  const std::int64_t middle = nodes / 2;
  const auto centre = static_cast<double>(at.column + middle * at.stride);
  const auto period = static_cast<double>(period_);
  return U - period * std::round((U - centre) / period);
}

// A crater of less than two nodes would be a stray node or none.
double DetailField::smallest_crater_m(int level) const {
  return 2 * std::ldexp(spacing_m(), level);
}

double DetailField::smallest_rock_m(int level) const {
  return level == 0 ? 0 : 2 * std::ldexp(spacing_m(), level);
}

ShapePlace DetailField::shape_place(const GridPoint& centre, double radius_m, double reach,
                                    const NodeLattice& at) const {
  const auto stride = static_cast<double>(at.stride);
  const double N = subdivision_ / stride;
  ShapePlace place;
  place.U = (near_tile(to_fine_grid(centre.u), at) - static_cast<double>(at.column)) / stride +
            first_node;
  place.V = (to_fine_grid(centre.v) - static_cast<double>(at.row)) / stride + first_node;
  const double det = centre.u_by_x * centre.v_by_y - centre.u_by_y * centre.v_by_x;
  const double k = 1 / (det * N * radius_m);
  const double x_by_U = k * centre.v_by_y, x_by_V = -k * centre.u_by_y;
  const double y_by_U = -k * centre.v_by_x, y_by_V = k * centre.u_by_x;
  place.a = x_by_U * x_by_U + y_by_U * y_by_U;
  place.b = x_by_U * x_by_V + y_by_U * y_by_V;
  place.c = x_by_V * x_by_V + y_by_V * y_by_V;
  place.half_U = reach * radius_m * N * std::hypot(centre.u_by_x, centre.u_by_y);
  place.half_V = reach * radius_m * N * std::hypot(centre.v_by_x, centre.v_by_y);
  return place;
}

void DetailField::add_craters(DetailTile& tile, const NodeLattice& at) const {
  const double shapes_m = at.level == 0 ? nodes_across_crater * spacing_m() : 0;
  for (const Crater& crater :
       craters_touching(*detail_.craters, seed_, map_rectangle(rectangle(at)),
                        smallest_crater_m(at.level), largest_crater_m_)) {
    const auto centre = grid_point(crater.centre);
    if (!centre) continue;
    if (crater.diameter_m >= shapes_m) {
      add_to_nodes(tile.heights, crater, *centre, at);
    } else {
      tile.craters.add({shape_place(*centre, crater.diameter_m / 2, crater_reach, at),
                        crater.depth_m, crater.rim_m});
    }
  }
  tile.craters.finish();
}

void DetailField::add_to_nodes(HeightTile& tile, const Crater& crater, const GridPoint& centre,
                               const NodeLattice& at) const {
  const auto stride = static_cast<double>(at.stride);
  const double N = subdivision_;
  // Centre in nodes of the tile, from its first.
  const double U =
      (near_tile(to_fine_grid(centre.u), at) - static_cast<double>(at.column)) / stride;
  const double V = (to_fine_grid(centre.v) - static_cast<double>(at.row)) / stride;
  const double radius_m = crater.diameter_m / 2, reach_m = crater_reach * radius_m;
  const double half_V = reach_m * N / stride * std::hypot(centre.v_by_x, centre.v_by_y);
  const int j_low = static_cast<int>(std::max(0.0, std::ceil(V - half_V)));
  const int j_high = static_cast<int>(std::min(nodes - 1.0, std::floor(V + half_V)));
  // Jacobian from nodes to crater radii.
  const double det = centre.u_by_x * centre.v_by_y - centre.u_by_y * centre.v_by_x;
  const double k = stride / (det * N * radius_m);
  const double x_by_U = k * centre.v_by_y, x_by_V = -k * centre.u_by_y;
  const double y_by_U = -k * centre.v_by_x, y_by_V = k * centre.u_by_x;
  // Each row changes within reach of the centre: a chord about the row's point nearest to it.
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

void DetailField::add_rocks(DetailTile& tile, const NodeLattice& at) const {
  for (const Rock& rock : rocks_touching(*detail_.rocks, seed_, map_rectangle(rectangle(at)),
                                         smallest_rock_m(at.level), largest_rock_m_)) {
    const auto centre = grid_point(rock.centre);
    if (!centre) continue;
    tile.rocks.add({shape_place(*centre, rock.diameter_m / 2, 1, at), rock.height_m});
  }
  tile.rocks.finish();
}

// Adds the volume of a crater or rock at that place.
void DetailField::add_volume(VolumeLattice& lattice, const NodeLattice& at,
                             const PlanePoint& centre, double volume_m3) const {
  const auto on_grid = grid_point(centre);
  if (!on_grid) return;
  const double cells_pm2 =
      std::abs(on_grid->u_by_x * on_grid->v_by_y - on_grid->u_by_y * on_grid->v_by_x);
  lattice.add(near_tile(to_fine_grid(on_grid->u), at), to_fine_grid(on_grid->v),
              volume_m3 * cells_pm2 * subdivision_ * subdivision_);
}

void DetailField::subtract_volumes(HeightTile& tile, const NodeLattice& at) const {
  VolumeLattice lattice(at, lattice_column_log2_, lattice_row_log2_);
  if (roughness_) roughness_->add_volumes(lattice, at.level);
  const PlaneRectangle area = map_rectangle(lattice.reach());
  const double counted_m = smallest_counted_cells * setting_.cell_m;
  if (detail_.craters) {
    const double low_m = std::max(counted_m, smallest_crater_m(at.level));
    for (const Crater& crater :
         craters_touching(*detail_.craters, seed_, area, low_m, largest_crater_m_)) {
      add_volume(lattice, at, crater.centre, crater_volume_m3(crater));
    }
  }
  if (detail_.rocks) {
    const double low_m = std::max(counted_m, smallest_rock_m(at.level));
    for (const Rock& rock : rocks_touching(*detail_.rocks, seed_, area, low_m, largest_rock_m_)) {
      add_volume(lattice, at, rock.centre, rock_volume_m3(rock));
    }
  }
  lattice.subtract_from(tile);
  const auto level = static_cast<std::size_t>(at.level);
  if (level >= mean_of_small_m_.size()) return;
  for (int row = first_node; row < first_node + nodes; ++row) {
    for (int column = first_node; column < first_node + nodes; ++column) {
      tile.height_m(column, row) -= mean_of_small_m_[level];
    }
  }
}

double DetailField::largest_m() const {
  const double longest_m = detail_.roughness ? detail_.roughness->longest_m : 0;
  return std::max({longest_m, largest_crater_m_, largest_rock_m_});
}

DetailTile DetailField::tile(const TileKey& key) const {
  const NodeLattice at = nodes_of(key);
  DetailTile tile(key);
  tile.heights.set_ground_everywhere();
  if (roughness_) roughness_->add_to(tile.heights, at);
  if (detail_.craters) add_craters(tile, at);
  if (detail_.rocks) add_rocks(tile, at);
  if (setting_.is_over_raster) subtract_volumes(tile.heights, at);
  return tile;
}

}  // namespace lsos
