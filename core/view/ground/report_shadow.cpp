#include "view/ground/report_shadow.h"

#include <algorithm>
#include <cmath>

#include "base/worker_pool.h"
#include "view/ground/disc_share.h"

namespace lsos {

namespace {

constexpr double level_factor = 4;  // size and cell of each grid over those of the previous one
constexpr double shadow_farthest_m = 250'000;  // visibility of a rise of 10 km on the Moon
constexpr double level_share = 0.45;  // share of a grid's shorter side marched before the next

constexpr double far_cells = 8;  // resolution of the larger grids, in their cells

struct Level {
  MapCells cells;
  std::vector<double> heights_m;
  double reach_m = 0;

  // Interpolated between cell centres; NaN outside.
  double height_m(double x_m, double y_m) const {
    const double u = (x_m - cells.left_m) / cells.cell_m - 0.5;
    const double v = (cells.top_m - y_m) / cells.cell_m - 0.5;
    const int column = static_cast<int>(std::floor(u)), row = static_cast<int>(std::floor(v));
    if (column < 0 || row < 0 || column + 1 >= cells.columns || row + 1 >= cells.rows) {
      return not_modelled;
    }
    const double s = u - column, t = v - row;
    const double* at = heights_m.data() + cells.index(column, row);
    return (1 - t) * ((1 - s) * at[0] + s * at[1]) +
           t * ((1 - s) * at[cells.columns] + s * at[cells.columns + 1]);
  }
};

std::vector<Level> levels_of(const Ground& ground, const MapCells& cells, int threads) {
  std::vector<Level> levels;
  MapCells now = cells;
  for (;;) {
    Level& level = levels.emplace_back();
    level.cells = now;
    // Small craters far away cast no shadow on the map.
    const double resolution_m = levels.size() == 1 ? now.cell_m : far_cells * now.cell_m;
    level.heights_m = elevations_m(ground, now, resolution_m, threads);
    // From any cell of the map the grid reaches at least this far in any direction.
    level.reach_m = level_share * std::min(now.columns, now.rows) * now.cell_m;
    if (levels.size() == 1) level.reach_m = 2 * now.cell_m * std::max(now.columns, now.rows);
    if (level.reach_m > shadow_farthest_m) return levels;
    const double x_m = now.left_m + now.columns * now.cell_m / 2;
    const double y_m = now.top_m - now.rows * now.cell_m / 2;
    now.cell_m *= level_factor;
    now.left_m = x_m - now.columns * now.cell_m / 2;
    now.top_m = y_m + now.rows * now.cell_m / 2;
  }
}

// Tangent of the elevation of the highest ground in direction (direction_x, direction_y), beyond
// the map's edge too. Past its end the ground is taken to continue level. Ground at distance d that
// is higher by h counts as h / d - d / (2 R), R = radius_m.
double horizon(const std::vector<Level>& levels, const Vec3& from_S_m, double height_m,
               double direction_x, double direction_y, double radius_m) {
  double highest = -1;
  double distance_m = levels.front().cells.cell_m, known_m = height_m;
  for (const Level& level : levels) {
    for (; distance_m < level.reach_m; distance_m += level.cells.cell_m) {
      double there_m = level.height_m(from_S_m.x() + distance_m * direction_x,
                                      from_S_m.y() + distance_m * direction_y);
      if (std::isnan(there_m) && &level == &levels.front()) break;  // its edge
      if (std::isnan(there_m)) there_m = known_m;
      known_m = there_m;
      highest = std::max(highest, (there_m - height_m) / distance_m - distance_m / (2 * radius_m));
    }
  }
  return highest;
}

}  // namespace

std::vector<double> elevations_m(const Ground& ground, const MapCells& cells, double resolution_m,
                                 int threads, MapDetail detail) {
  constexpr double sparse_share = 0.25;
  std::vector<double> heights_m(cells.size());
  WorkerPool pool(threads);
  pool.for_each(static_cast<std::size_t>(threads), [&](std::size_t part) {
    Ground::Probe probe = detail == MapDetail::sparse ? Ground::Probe::with_sparse_detail(
                                                            ground, sparse_share * resolution_m)
                                                      : Ground::Probe(ground, resolution_m);
    for (int row = static_cast<int>(part); row < cells.rows; row += threads) {
      for (int column = 0; column < cells.columns; ++column) {
        heights_m[cells.index(column, row)] = probe.sample(cells.p_S_m(column, row)).elevation_m;
      }
    }
  });
  return heights_m;
}

std::vector<double> sunlit_shares(const Ground& ground, const MapCells& cells, Instant at,
                                  int threads) {
  const SiteFrame& site = ground.site();
  const Vec3 middle_S_m = cells.p_S_m(cells.columns / 2, cells.rows / 2);
  const Sunlight sun = sunlight(site.body(), site.geodetic(middle_S_m), at, 0);
  const Vec3 sun_S = direction_S(site, middle_S_m, sun.seen);
  const double level = std::max(1e-9, std::hypot(sun_S.x(), sun_S.y()));
  const double direction_x = sun_S.x() / level, direction_y = sun_S.y() / level;
  const std::vector<Level> levels = levels_of(ground, cells, threads);
  const std::vector<double>& heights_m = levels.front().heights_m;
  std::vector<double> shares(cells.size(), not_modelled);
  WorkerPool pool(threads);
  pool.for_each(static_cast<std::size_t>(threads), [&](std::size_t part) {
    for (int row = static_cast<int>(part); row < cells.rows; row += threads) {
      for (int column = 0; column < cells.columns; ++column) {
        const double height_m = heights_m[cells.index(column, row)];
        if (std::isnan(height_m)) continue;
        const Vec3 p_S_m = cells.p_S_m(column, row);
        const double elevation_rad = std::asin(std::clamp(sun_S.dot(site.up_S(p_S_m)), -1.0, 1.0));
        const double over_rad = std::atan(horizon(levels, p_S_m, height_m, direction_x, direction_y,
                                                  site.body().equatorial_radius_m));
        shares[cells.index(column, row)] =
            disc_share((elevation_rad - over_rad) / sun.disc_rad) * (1 - sun.eclipsed);
      }
    }
  });
  return shares;
}

}  // namespace lsos
