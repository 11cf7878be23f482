#include "product/report_map.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "picture/jpeg.h"
#include "picture/png.h"
#include "view/ground/ground_end.h"
#include "view/ground/report_shadow.h"

namespace lsos {

namespace {

constexpr double map_margin_share = 0.14, map_margin_least_m = 25;
constexpr double aspect_min = 0.62, aspect_max = 1.1;  // height over width
constexpr int relief_px = 600, shadow_px = 200;        // along the longer side
constexpr double light_azimuth_rad = radians(315), light_elevation_rad = radians(45);
constexpr double wanted_slope = 0.35;  // slope to which steep places are exaggerated
constexpr double exaggeration_most = 6;
constexpr double darkest = 0.62;  // cover of full shadow
// Stripes where no ground is known: period and width in cells.
constexpr int stripe_cells = 8, stripe_width_cells = 3;
constexpr std::uint8_t stripe = 176, between_stripes = 250;

MapCells cells_over(const ReportMap& map, int longer_px) {
  const double width_m = map.right_m - map.left_m, height_m = map.top_m - map.bottom_m;
  MapCells cells{map.left_m, map.top_m, std::max(width_m, height_m) / longer_px, 0, 0};
  cells.columns = static_cast<int>(std::lround(width_m / cells.cell_m));
  cells.rows = static_cast<int>(std::lround(height_m / cells.cell_m));
  return cells;
}

class Bounds {
 public:
  void add(double x_m, double y_m) {
    left_m_ = std::min(left_m_, x_m);
    right_m_ = std::max(right_m_, x_m);
    bottom_m_ = std::min(bottom_m_, y_m);
    top_m_ = std::max(top_m_, y_m);
  }
  void add(const std::vector<ReportLine>& lines) {
    for (const ReportLine& line : lines) {
      for (const ReportPoint& point : line) add(point.x_m, point.y_m);
    }
  }
  bool is_empty() const { return !(left_m_ <= right_m_); }
  ReportMap map() const {
    ReportMap map;
    double width_m = right_m_ - left_m_, height_m = top_m_ - bottom_m_;
    const double margin_m =
        std::max(map_margin_least_m, map_margin_share * std::max(width_m, height_m));
    width_m += 2 * margin_m;
    height_m += 2 * margin_m;
    height_m = std::max(height_m, aspect_min * width_m);
    width_m = std::max(width_m, height_m / aspect_max);
    const double x_m = (left_m_ + right_m_) / 2, y_m = (bottom_m_ + top_m_) / 2;
    map.left_m = x_m - width_m / 2;
    map.right_m = x_m + width_m / 2;
    map.bottom_m = y_m - height_m / 2;
    map.top_m = y_m + height_m / 2;
    return map;
  }

 private:
  double left_m_ = 1e300, right_m_ = -1e300, bottom_m_ = 1e300, top_m_ = -1e300;
};

Bounds bounds_of(const ReportData& data) {
  Bounds bounds;
  for (const ReportRover& rover : data.rovers) {
    for (std::size_t k = 0; k < rover.position.size(); ++k) {
      bounds.add(rover.position.column(position_x)[k], rover.position.column(position_y)[k]);
    }
    bounds.add(rover.drawn);
    bounds.add(rover.planned);
  }
  for (const ReportAsset& asset : data.assets) bounds.add(asset.place.x_m, asset.place.y_m);
  return bounds;
}

struct Slope {
  double east = not_modelled, north = not_modelled;
  double steepness() const { return std::hypot(east, north); }
};

std::vector<Slope> slopes(const std::vector<double>& heights_m, const MapCells& grid) {
  std::vector<Slope> found(grid.size());
  const auto height_m = [&](int column, int row) {
    column = std::clamp(column, 0, grid.columns - 1);
    row = std::clamp(row, 0, grid.rows - 1);
    return heights_m[grid.index(column, row)];
  };
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      found[grid.index(column, row)] = {
          (height_m(column + 1, row) - height_m(column - 1, row)) / (2 * grid.cell_m),
          (height_m(column, row - 1) - height_m(column, row + 1)) / (2 * grid.cell_m)};
    }
  }
  return found;
}

// Relief lit from the north-west, as on maps; flat ground is pale, so that lines stand out.
EmbeddedPicture relief(const std::vector<double>& heights_m, const MapCells& grid) {
  const std::vector<Slope> all = slopes(heights_m, grid);
  std::vector<double> steep;
  for (const Slope& slope : all) {
    if (!std::isnan(slope.steepness())) steep.push_back(slope.steepness());
  }
  double factor = 1;
  if (!steep.empty()) {
    const auto tenth = steep.begin() + static_cast<std::ptrdiff_t>(steep.size() * 9 / 10);
    std::ranges::nth_element(steep, tenth);
    if (*tenth > 0) factor = std::clamp(wanted_slope / *tenth, 1.0, exaggeration_most);
  }
  const Vec3 light(std::sin(light_azimuth_rad) * std::cos(light_elevation_rad),
                   std::cos(light_azimuth_rad) * std::cos(light_elevation_rad),
                   std::sin(light_elevation_rad));
  std::vector<std::uint8_t> grey(grid.size());
  for (std::size_t k = 0; k < grey.size(); ++k) {
    if (std::isnan(all[k].steepness())) {
      const int column = static_cast<int>(k) % grid.columns,
                row = static_cast<int>(k) / grid.columns;
      grey[k] = (column + row) % stripe_cells < stripe_width_cells ? stripe : between_stripes;
      continue;
    }
    const Vec3 normal = Vec3(-factor * all[k].east, -factor * all[k].north, 1).normalized();
    grey[k] = static_cast<std::uint8_t>(std::clamp(64 + 218 * normal.dot(light), 40.0, 252.0));
  }
  return {"image/jpeg", jpeg_bytes(grid.columns, grid.rows, 1, grey, 84)};
}

void add_ground_end(ReportMap& map, const Ground& ground, const MapCells& grid, Instant at) {
  const SiteFrame& site = ground.site();
  Geodetic eye = site.geodetic(grid.p_S_m(grid.columns / 2, grid.rows / 2));
  const auto height_m = ground.elevation_m(eye);
  if (!height_m) return;
  eye.height_m = *height_m;
  const Sunlight sun = sunlight(site.body(), eye, at, 0);
  const Vec3 eye_S_m = site.p_S_m(eye);
  const auto end =
      GroundEndProbe(ground).towards(eye_S_m, direction_S(site, eye_S_m, sun.seen), sun.disc_rad);
  if (!end) return;
  map.ground_reaches_m = end->reaches_m;
  map.ground_matters_m = end->matters_m;
}

void add_shadow(ReportMap& map, const Ground& ground, Instant at, int threads) {
  const MapCells grid = cells_over(map, shadow_px);
  const std::vector<double> lit = sunlit_shares(ground, grid, at, threads);
  std::vector<std::uint8_t> grey_alpha(2 * grid.size(), 0);
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < lit.size(); ++k) {
    if (std::isnan(lit[k])) continue;
    sum += lit[k];
    ++count;
    grey_alpha[2 * k] = 18;
    grey_alpha[2 * k + 1] = static_cast<std::uint8_t>(std::lround(255 * darkest * (1 - lit[k])));
  }
  if (count == 0) return;
  map.sunlit_share = sum / count;
  add_ground_end(map, ground, grid, at);
  map.shadow = {"image/png", png_bytes(grid.columns, grid.rows, grey_alpha, true)};
}

}  // namespace

std::optional<ReportMap> report_map(const Ground& ground, const ReportData& data,
                                    std::optional<SimTime> shadow_at, int threads,
                                    const ReportLine& also) {
  Bounds bounds = bounds_of(data);
  bounds.add({also});
  if (bounds.is_empty()) return std::nullopt;
  ReportMap map = bounds.map();
  const MapCells grid = cells_over(map, relief_px);
  const std::vector<double> heights_m =
      elevations_m(ground, grid, grid.cell_m, threads, MapDetail::sparse);
  map.lowest_m = 1e300;
  map.highest_m = -1e300;
  for (const double height_m : heights_m) {
    if (std::isnan(height_m)) {
      map.missing_share += 1.0 / static_cast<double>(heights_m.size());
      continue;
    }
    map.lowest_m = std::min(map.lowest_m, height_m);
    map.highest_m = std::max(map.highest_m, height_m);
  }
  map.relief = relief(heights_m, grid);
  if (!shadow_at) return map;
  map.shadow_s = seconds(*shadow_at);
  add_shadow(map, ground, data.start + *shadow_at, threads);
  return map;
}

}  // namespace lsos
