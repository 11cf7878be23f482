#include "view/ground/viewshed.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lsos {

namespace {

constexpr double turn_rad = 2 * std::numbers::pi;

// Sample spacing: near the eye a share of the distance, from a fraction of a cell to a cell; before
// a distant map a share of the distance to the nearer end.
constexpr double near_share = 0.05, near_cells = 0.02;
// On small maps a missed edge matters, so each cell gets its own line as long as the crossings of
// all lines are no more than this.
constexpr double crossings_max = 4e6;
constexpr double straight_px = 0.02;

// Cells between samples, and between rays at the far end: from `finest_cells` up to a whole cell at
// a distance of `cells_to_whole` cells, which limits the time that large maps take.
constexpr double finest_cells = 0.25, cells_to_whole = 1000;
constexpr double viewshed_far_share = 0.005;
constexpr double viewshed_coarse_share = 0.25;  // of a step: finer detail is left out

// Ground next to a place does not hide it: that is its own slope.
constexpr double own_cells = 0.75;

// Ground can be sampled within 60 degrees of the site, which is at the observer or near it.
constexpr double reach_rad = 0.9;

constexpr float no_slope = -std::numeric_limits<float>::infinity();

// Clockwise from north.
double azimuth_rad(const Vec3& direction, const Vec3& east, const Vec3& north) {
  return std::atan2(direction.dot(east), direction.dot(north));
}

// The same direction as an angle of 0..2 pi.
double from_zero_rad(double angle_rad) {
  return angle_rad - turn_rad * std::floor(angle_rad / turn_rad);
}

bool holds(const MapGrid& grid, const RasterMap& map, const Geodetic& place) {
  const auto at = map.coordinates(place);
  if (!at) return false;
  const double period = map.period_px();
  const double u = period > 0 ? at->u - period * std::floor((at->u + 0.5) / period) : at->u;
  return u >= -0.5 && u <= grid.columns - 0.5 && at->v >= -0.5 && at->v <= grid.rows - 0.5;
}

// Cells along the map's edge, once around.
std::vector<GridCoordinates> edge_of(int columns, int rows) {
  const double right = columns - 1, bottom = rows - 1;
  std::vector<GridCoordinates> edge;
  for (double u = 0; u < right; ++u) edge.push_back({u, 0});
  for (double v = 0; v < bottom; ++v) edge.push_back({right, v});
  for (double u = right; u > 0; --u) edge.push_back({u, bottom});
  for (double v = bottom; v > 0; --v) edge.push_back({0, v});
  if (edge.empty()) edge.push_back({0, 0});
  return edge;
}

}  // namespace

ViewSector sector_of(const MapGrid& grid, const SiteFrame& site, const Geodetic& observer) {
  const Body& body = site.body();
  const RasterMap map = grid.map(body);
  const Vec3 eye_S_m = site.p_S_m(observer);
  const Vec3 east_S = site.east_S(eye_S_m), north_S = site.north_S(eye_S_m);
  const double half_turn_m = std::numbers::pi * body.equatorial_radius_m;
  ViewSector sector{0, turn_rad, half_turn_m, 0};
  bool is_all_round = holds(grid, map, observer);
  std::optional<double> before_rad;
  double turned_rad = 0, low_rad = 0, high_rad = 0;
  for (const GridCoordinates& cell : edge_of(grid.columns, grid.rows)) {
    const std::optional<Geodetic> place = map.place(cell);
    if (!place) {  // the map ends before the grid: it may hold anything
      is_all_round = true;
      sector.farthest_m = half_turn_m;
      continue;
    }
    const double away_m = surface_distance_m(body, observer, *place);
    sector.nearest_m = std::min(sector.nearest_m, away_m);
    sector.farthest_m = std::max(sector.farthest_m, away_m);
    const double azimuth = azimuth_rad(site.p_S_m(*place) - eye_S_m, east_S, north_S);
    if (!before_rad) sector.azimuth_low_rad = azimuth;
    turned_rad += std::remainder(azimuth - before_rad.value_or(azimuth), turn_rad);
    before_rad = azimuth;
    low_rad = std::min(low_rad, turned_rad);
    high_rad = std::max(high_rad, turned_rad);
  }
  // A map of the whole globe holds places farther away than its edge.
  if (map.period_px() > 0 && grid.columns >= map.period_px()) sector.farthest_m = half_turn_m;
  if (is_all_round) sector.nearest_m = 0;
  if (!is_all_round && high_rad - low_rad < turn_rad) {
    sector.azimuth_low_rad += low_rad;
    sector.width_rad = high_rad - low_rad;
  }
  return sector;
}

Viewshed::Viewshed(const Ground& ground, const MapHeights* heights, const Observer& observer,
                   const ViewSector& sector)
    : ground_(&ground), heights_(heights), observer_(observer), sector_(sector) {
  const SiteFrame& site = ground.site();
  eye_S_m_ = site.p_S_m(observer.place);
  up_S_ = site.up_S(eye_S_m_);
  north_S_ = site.north_S(eye_S_m_);
  east_S_ = site.east_S(eye_S_m_);
  radius_m_ = site.body().equatorial_radius_m + observer.place.height_m;
  // Distances of cell centres are widened by more than a cell's diagonal.
  sector_.farthest_m = std::min(sector_.farthest_m + 2 * observer.cell_m, reach_m());
  sector_.nearest_m = std::max(0.0, sector_.nearest_m - 4 * observer.cell_m);
  eye_px_ = eye_of_lines();
  if (!eye_px_) spread_rays();
}

void Viewshed::spread_rays() {
  const double cell_m = observer_.cell_m;
  cells_per_sample_ = std::clamp(sector_.farthest_m / cell_m / cells_to_whole, finest_cells, 1.0);
  const double wanted_rad =
      std::min(turn_rad / 64, cells_per_sample_ * cell_m / std::max(sector_.farthest_m, cell_m));
  if (sector_.width_rad < turn_rad) {
    sector_.azimuth_low_rad -= wanted_rad;
    sector_.width_rad = std::min(turn_rad, sector_.width_rad + 2 * wanted_rad);
  }
  const double gaps = std::ceil(sector_.width_rad / wanted_rad);
  spacing_rad_ = sector_.width_rad / gaps;
  ray_count_ = static_cast<std::size_t>(gaps) + 1;
  add_distances();
  max_slopes_.resize(ray_count_);
}

double Viewshed::reach_m() const { return reach_rad * radius_m_; }

void Viewshed::add_distances() {
  const double cell_m = observer_.cell_m;
  const auto step_m = [&](double x_m) {
    const double plain_m =
        std::clamp(near_share * x_m, near_cells * cell_m, cells_per_sample_ * cell_m);
    return std::max(plain_m, viewshed_far_share * std::min(x_m, sector_.nearest_m - x_m));
  };
  for (double x_m = step_m(0); x_m <= sector_.farthest_m; x_m += step_m(x_m)) {
    distances_m_.push_back(x_m);
  }
}

Viewshed::Polar Viewshed::polar(const Vec3& p_S_m) const {
  const Vec3 line_m = p_S_m - eye_S_m_;
  const double east_m = line_m.dot(east_S_), north_m = line_m.dot(north_S_),
               up_m = line_m.dot(up_S_);
  const double level_m = std::hypot(east_m, north_m);
  Polar polar;
  polar.azimuth_rad = std::atan2(east_m, north_m);
  polar.distance_m = radius_m_ * std::atan2(level_m, radius_m_ + up_m);
  polar.slope = observer_.is_flat ? (ground_->site().height_m(p_S_m) - observer_.place.height_m) /
                                        polar.distance_m
                                  : up_m / level_m;
  return polar;
}

Vec3 Viewshed::p_S_m(double azimuth_rad, double distance_m) const {
  const double away_rad = distance_m / radius_m_;
  const Vec3 along_S = std::cos(azimuth_rad) * north_S_ + std::sin(azimuth_rad) * east_S_;
  const double half_sine = std::sin(away_rad / 2);
  return eye_S_m_ + radius_m_ * (std::sin(away_rad) * along_S - 2 * half_sine * half_sine * up_S_);
}

std::optional<GridCoordinates> Viewshed::on_map(double azimuth_rad, double distance_m) const {
  return heights_->map().coordinates(ground_->site().geodetic(p_S_m(azimuth_rad, distance_m)));
}

double Viewshed::ground_slope(const Vec3& over_S_m, double height_m) const {
  const Vertical vertical = ground_->site().vertical(over_S_m);
  return polar(over_S_m - (vertical.height_m - height_m) * vertical.up_S).slope;
}

std::optional<GridCoordinates> Viewshed::eye_of_lines() const {
  if (heights_ == nullptr) return {};
  const double columns = heights_->columns(), rows = heights_->rows();
  if (columns * rows * (columns + rows) > crossings_max) return {};
  const auto eye = place_px(observer_.place, columns / 2);
  if (!eye || !heights_->height_m(*eye)) return {};
  for (const GridCoordinates& cell : edge_of(heights_->columns(), heights_->rows())) {
    const std::optional<Geodetic> place = heights_->map().place(cell);
    if (!place) return {};
    const Polar end = polar(ground_->site().p_S_m(*place));
    const auto middle =
        place_px(ground_->site().geodetic(p_S_m(end.azimuth_rad, end.distance_m / 2)), eye->u);
    if (!middle || !(std::hypot((eye->u + cell.u) / 2 - middle->u,
                                (eye->v + cell.v) / 2 - middle->v) < straight_px)) {
      return {};
    }
  }
  return eye;
}

std::optional<GridCoordinates> Viewshed::place_px(const Geodetic& place, double near_u) const {
  auto at = heights_->coordinates(place);
  const double period = heights_->map().period_px();
  if (at && period > 0) at->u -= period * std::round((at->u - near_u) / period);
  return at;
}

double Viewshed::steepest_before(const Polar& target, const GridCoordinates& target_px) const {
  double steepest = no_slope;
  const auto cross = [&](double begin, double end, double GridCoordinates::*along) {
    for (double line = std::floor(std::min(begin, end)) + 1; line < std::max(begin, end); ++line) {
      const double share = (line - begin) / (end - begin);
      GridCoordinates at{eye_px_->u + share * (target_px.u - eye_px_->u),
                         eye_px_->v + share * (target_px.v - eye_px_->v)};
      at.*along = line;
      const auto height_m = heights_->height_m(at);
      if (!height_m) continue;
      const Vec3 over_S_m = p_S_m(target.azimuth_rad, share * target.distance_m);
      steepest = std::max(steepest, ground_slope(over_S_m, *height_m));
    }
  };
  cross(eye_px_->u, target_px.u, &GridCoordinates::u);
  cross(eye_px_->v, target_px.v, &GridCoordinates::v);
  return steepest;
}

// A ray is nearly straight on a map: only its ends are projected, and its middle, which shows
// whether that holds. Where it does not, each half is treated the same.
void Viewshed::add_between(std::size_t first, std::size_t last, double azimuth_rad,
                           Track& track) const {
  if (last - first < 2) return;
  const std::size_t middle = (first + last) / 2;
  track[middle] = on_map(azimuth_rad, distances_m_[middle]);
  const auto &a = track[first], &b = track[last], &m = track[middle];
  const auto part = [&](std::size_t from, std::size_t to, std::size_t k) {
    return (distances_m_[k] - distances_m_[from]) / (distances_m_[to] - distances_m_[from]);
  };
  const auto is_straight = [&] {
    if (!a || !b || !m) return false;
    const double share = part(first, last, middle);
    return std::hypot(a->u + share * (b->u - a->u) - m->u, a->v + share * (b->v - a->v) - m->v) <
           straight_px;
  };
  if (!is_straight()) {
    add_between(first, middle, azimuth_rad, track);
    add_between(middle, last, azimuth_rad, track);
    return;
  }
  const auto fill = [&](std::size_t from, std::size_t to) {
    const GridCoordinates begin = *track[from], end = *track[to];
    for (std::size_t k = from + 1; k < to; ++k) {
      const double share = part(from, to, k);
      track[k] = {begin.u + share * (end.u - begin.u), begin.v + share * (end.v - begin.v)};
    }
  };
  fill(first, middle);
  fill(middle, last);
}

Viewshed::Track Viewshed::track(double azimuth_rad) const {
  Track track(distances_m_.size());
  if (heights_ == nullptr || track.empty()) return track;
  constexpr std::size_t stretch = 64;
  track[0] = on_map(azimuth_rad, distances_m_[0]);
  for (std::size_t first = 0; first + 1 < track.size(); first += stretch) {
    const std::size_t last = std::min(first + stretch, track.size() - 1);
    track[last] = on_map(azimuth_rad, distances_m_[last]);
    add_between(first, last, azimuth_rad, track);
  }
  return track;
}

void Viewshed::march(std::size_t ray, GroundProbes& probes) {
  const double azimuth_rad = sector_.azimuth_low_rad + spacing_rad_ * static_cast<double>(ray);
  const Track track = this->track(azimuth_rad);
  // Ground beyond the map hides nothing on it.
  std::size_t count = track.size();
  while (heights_ != nullptr && count > 0 && !heights_->holds(track[count - 1])) --count;
  std::vector<float>& highest = max_slopes_[ray];
  highest.resize(count);
  float so_far = no_slope;
  double before_m = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double x_m = distances_m_[k];
    const Vec3 over_S_m = p_S_m(azimuth_rad, x_m);
    const auto height_m = track[k] ? heights_->height_m(*track[k]) : std::nullopt;
    double slope = no_slope;
    if (height_m) {
      slope = ground_slope(over_S_m, *height_m);
    } else {
      const double resolution_m =
          octave_above_m(observer_.cell_m, viewshed_coarse_share * (x_m - before_m));
      const GroundSample ground = probes.at(resolution_m).sample(over_S_m);
      if (ground.is_ground()) slope = polar(over_S_m - ground.gap_m * ground.up_S).slope;
    }
    so_far = std::max(so_far, static_cast<float>(slope));
    highest[k] = so_far;
    before_m = x_m;
  }
}

bool Viewshed::sees(const Vec3& target_S_m) const {
  const Polar target = polar(target_S_m);
  if (target.distance_m > sector_.farthest_m) return false;
  if (eye_px_) {
    const auto at = place_px(ground_->site().geodetic(target_S_m), eye_px_->u);
    // At the eye itself the slope is undefined; the comparison lets it count as seen.
    return at && !(target.slope < steepest_before(target, *at));
  }
  const double before_m = target.distance_m - own_cells * observer_.cell_m;
  const auto beyond = std::ranges::upper_bound(distances_m_, before_m);
  if (beyond == distances_m_.begin()) return true;
  const auto sample = static_cast<std::size_t>(beyond - distances_m_.begin()) - 1;
  const double at = from_zero_rad(target.azimuth_rad - sector_.azimuth_low_rad) / spacing_rad_;
  const std::size_t ray = std::min(static_cast<std::size_t>(at), ray_count_ - 2);
  const double share = std::clamp(at - static_cast<double>(ray), 0.0, 1.0);
  const auto highest_of = [&](const std::vector<float>& highest) {
    return highest.empty() ? no_slope : highest[std::min(sample, highest.size() - 1)];
  };
  const float left = highest_of(max_slopes_[ray]), right = highest_of(max_slopes_[ray + 1]);
  // Without ground on one side the other side decides.
  if (left == no_slope || right == no_slope) return target.slope >= std::max(left, right);
  return target.slope >= (1 - share) * left + share * right;
}

}  // namespace lsos
