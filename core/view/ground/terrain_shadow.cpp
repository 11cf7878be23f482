#include "view/ground/terrain_shadow.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "view/ground/disc_share.h"
#include "view/ground/highest_ground.h"
#include "view/ground/lod_probes.h"
#include "view/ground/parallel_rows.h"

namespace lsos {

namespace {

constexpr int nodes = 225;  // a side: one more than a multiple of four, so that squares nest
constexpr double finest_half_m = 24;
constexpr double farthest_half_m = 7e3;
constexpr double resolution_cells = 16;  // detail is then drawn on nodes not much closer than these
// Beyond the squares rays towards the Sun are marched, from this many places of their edge.
constexpr int edge_rays = 33;
constexpr double march_share = 0.01, march_resolution_share = 0.01;  // of the distance
constexpr double ray_slope_max = 30;  // slope of rays; a higher Sun casts negligible shadows
constexpr double soft_cells = 0.02;   // shadow edges are no sharper than the nodes resolve
constexpr double sector_margin_cells = 4;
constexpr double faded_from = 0.6;  // of a square's half width
constexpr float no_ground_m = -1e30f;

std::size_t node_at(int row, int column) { return static_cast<std::size_t>(row * nodes + column); }

// Rows are swept independently: without smoothing the ends of their shadows would form a comb.
void smooth(std::vector<float>& share) {
  std::vector<float> before = share;
  const auto pass = [&](int rows, int columns) {
    for (int j = rows; j < nodes - rows; ++j) {
      for (int i = columns; i < nodes - columns; ++i) {
        share[node_at(j, i)] = 0.25f * before[node_at(j - rows, i - columns)] +
                               0.5f * before[node_at(j, i)] +
                               0.25f * before[node_at(j + rows, i + columns)];
      }
    }
    before = share;
  };
  pass(1, 0);
  pass(1, 0);
  pass(0, 1);
}

double slope_of(double elevation_rad) {
  const double highest_rad = std::atan(ray_slope_max);
  return std::tan(std::clamp(elevation_rad, -highest_rad, highest_rad));
}

template <class Limits>
std::array<double, std::tuple_size_v<Limits>> between(const Limits& a, const Limits& b,
                                                      double share) {
  std::array<double, std::tuple_size_v<Limits>> found;
  for (std::size_t k = 0; k < found.size(); ++k) {
    found[k] = std::lerp(static_cast<double>(a[k]), static_cast<double>(b[k]), share);
  }
  return found;
}

template <std::size_t count>
std::array<float, count> as_floats(const std::array<double, count>& limits_m) {
  std::array<float, count> floats;
  std::ranges::transform(limits_m, floats.begin(), [](double h) { return static_cast<float>(h); });
  return floats;
}

}  // namespace

TerrainShadow::TerrainShadow(const Ground& ground, const Vec3& eye_S_m, const Vec3& sun_S,
                             double disc_rad, const GroundSector& sector)
    : up_S_(ground.site().up_S(eye_S_m)),
      radius_m_(ground.site().body().equatorial_radius_m),
      sector_(sector) {
  const double sine = std::clamp(sun_S.dot(up_S_), -1.0, 1.0);
  const Vec3 level_S = sun_S - sine * up_S_;
  along_S_ = level_S.norm() > 1e-6 ? level_S.normalized() : ground.site().north_S(eye_S_m);
  across_S_ = up_S_.cross(along_S_);
  const double elevation_rad = std::asin(sine);
  const auto level_of = [](int edge) { return 2.0 * edge / slices - 1; };
  for (int k = 0; k <= slices; ++k) slopes_[k] = slope_of(elevation_rad + level_of(k) * disc_rad);
  for (int k = 0; k < slices; ++k)
    areas_[k] = disc_share(level_of(k + 1)) - disc_share(level_of(k));
  const Body& body = ground.site().body();
  const double over_m = body.highest_ground_m - ground.site().height_m(eye_S_m);
  for (double half_m = finest_half_m; half_m < farthest_half_m; half_m *= 2) {
    levels_.push_back(sampled(ground, eye_S_m, half_m));
    const double drop_m = half_m * half_m / (2 * body.equatorial_radius_m);
    if (half_m * slopes_.front() + drop_m > over_m) break;
  }
  march(ground, eye_S_m);
  for (std::size_t k = levels_.size(); k-- > 0;) {
    sweep(levels_[k], k + 1 < levels_.size() ? &levels_[k + 1] : nullptr);
  }
}

TerrainShadow::Level TerrainShadow::sampled(const Ground& ground, const Vec3& eye_S_m,
                                            double half_m) const {
  Level level{half_m, 2 * half_m / (nodes - 1), {}, {}, {}};
  level.ground_m.assign(node_at(nodes, 0), no_ground_m);
  const double radius_m = ground.site().body().equatorial_radius_m;
  const Level* finer = levels_.empty() ? nullptr : &levels_.back();
  const auto row = [&](LodProbes& probes, int j) {
    for (int i = first_seen(level, j); i < nodes; ++i) {
      float& height_m = level.ground_m[node_at(j, i)];
      // The finer square has nodes at the same places.
      const int fine_i = 2 * i - (nodes - 1) / 2, fine_j = 2 * j - (nodes - 1) / 2;
      if (finer && fine_i >= 0 && fine_i < nodes && fine_j >= 0 && fine_j < nodes) {
        height_m = finer->ground_m[node_at(fine_j, fine_i)];
        if (height_m > no_ground_m) continue;
      }
      const double x_m = i * level.cell_m - half_m, y_m = j * level.cell_m - half_m;
      const double drop_m = (x_m * x_m + y_m * y_m) / (2 * radius_m);
      const Vec3 p_m = x_m * along_S_ + y_m * across_S_ - drop_m * up_S_;
      const GroundSample sample = probes.at_octave(eye_S_m + p_m, resolution_cells * level.cell_m);
      if (!sample.is_ground()) continue;
      height_m = static_cast<float>((p_m - sample.gap_m * sample.up_S).dot(up_S_));
    }
  };
  parallel_for_rows(
      nodes, [&] { return LodProbes(ground); }, row);
  return level;
}

int TerrainShadow::first_seen(const Level& level, int row) const {
  if (sector_.half_rad >= std::numbers::pi / 2) return 0;
  // The sector is widened by some nodes by moving its apex back.
  const double ahead_x = sector_.ahead_S.dot(along_S_), ahead_y = sector_.ahead_S.dot(across_S_);
  const double back_m = sector_margin_cells * level.cell_m / std::sin(sector_.half_rad);
  for (int i = 0; i < nodes; ++i) {
    const double x_m = i * level.cell_m - level.half_m + back_m * ahead_x;
    const double y_m = row * level.cell_m - level.half_m + back_m * ahead_y;
    const double forward_m = x_m * ahead_x + y_m * ahead_y;
    const double aside_m = std::abs(x_m * ahead_y - y_m * ahead_x);
    if (forward_m > 0 && aside_m <= forward_m * std::tan(sector_.half_rad)) return i;
  }
  return nodes;
}

void TerrainShadow::march(const Ground& ground, const Vec3& eye_S_m) {
  const Level& last = levels_.back();
  const Body& body = ground.site().body();
  const double over_m = body.highest_ground_m - ground.site().height_m(eye_S_m);
  edge_.assign(edge_rays, unobstructed());
  const auto one = [&](LodProbes& probes, int k) {
    Limits& limits_m = edge_[static_cast<std::size_t>(k)];
    const double y_m = last.half_m * (2.0 * k / (edge_rays - 1) - 1);
    for (double x_m = last.half_m;; x_m *= 1 + march_share) {
      const double drop_m = (x_m * x_m + y_m * y_m) / (2 * body.equatorial_radius_m);
      const double from_edge_m = x_m - last.half_m;
      if (from_edge_m * slopes_.front() + drop_m > over_m + last.half_m) break;
      const Vec3 p_m = x_m * along_S_ + y_m * across_S_ - drop_m * up_S_;
      const GroundSample sample = probes.at_octave(eye_S_m + p_m, march_resolution_share * x_m);
      if (!sample.is_ground()) continue;
      const double height_m = (p_m - sample.gap_m * sample.up_S).dot(up_S_);
      for (int s = 0; s <= slices; ++s) {
        limits_m[s] = std::max(limits_m[s], height_m - slopes_[s] * from_edge_m);
      }
    }
  };
  parallel_for_rows(
      edge_rays, [&] { return LodProbes(ground); }, one);
}

TerrainShadow::Limits TerrainShadow::at_edge(double across_m) const {
  const double k = (across_m / levels_.back().half_m + 1) / 2 * (edge_rays - 1);
  const auto low = static_cast<std::size_t>(std::clamp(k, 0.0, edge_rays - 2.0));
  const double up = k - static_cast<double>(low);
  return between(edge_[low], edge_[low + 1], up);
}

void TerrainShadow::raise(Limits& limits_m, double ground_m) const {
  for (double& limit_m : limits_m) limit_m = std::max(limit_m, ground_m);
}

void TerrainShadow::lower(Limits& limits_m, double by_m) const {
  for (int k = 0; k <= slices; ++k) limits_m[k] -= slopes_[k] * by_m;
}

double TerrainShadow::share_of(double height_m, const Limits& limits_m, double cell_m) const {
  double share = 0;
  for (int k = 0; k < slices; ++k) {
    const double all_m = limits_m[k], none_m = limits_m[k + 1];
    const double rise_m = std::max(all_m - none_m, soft_cells * cell_m);
    share += areas_[k] * std::clamp((height_m - none_m) / rise_m, 0.0, 1.0);
  }
  return share;
}

void TerrainShadow::sweep(Level& level, const Level* coarser) const {
  level.limits_m.assign(level.ground_m.size(), as_floats(unobstructed()));
  level.share.assign(level.ground_m.size(), 1);
  const double under_eye_m =
      std::max<double>(-10, levels_.front().ground_m[node_at((nodes - 1) / 2, (nodes - 1) / 2)]);
  for (int j = 0; j < nodes; ++j) {
    const double across_m = j * level.cell_m - level.half_m;
    Limits limits_m =
        coarser ? limits_at(grid_position(level.half_m, across_m,
                                          static_cast<std::size_t>(coarser - levels_.data())))
                : at_edge(across_m);
    for (int i = nodes - 1, end = first_seen(level, j); i >= end; --i) {
      const std::size_t k = node_at(j, i);
      const double ground_m = level.ground_m[k];
      if (ground_m <= no_ground_m) {
        // Unknown ground is taken to lie as high as that below the eye, and casts no shadow.
        const double along_m = i * level.cell_m - level.half_m;
        const double drop_m = (along_m * along_m + across_m * across_m) / (2 * radius_m_);
        level.limits_m[k] = as_floats(limits_m);
        level.share[k] = static_cast<float>(share_of(under_eye_m - drop_m, limits_m, level.cell_m));
        lower(limits_m, level.cell_m);
        continue;
      }
      level.limits_m[k] = as_floats(limits_m);
      level.share[k] = static_cast<float>(share_of(ground_m, limits_m, level.cell_m));
      raise(limits_m, ground_m);
      lower(limits_m, level.cell_m);
    }
  }
  smooth(level.share);
}

TerrainShadow::GridPosition TerrainShadow::grid_position(double along_m, double across_m,
                                                         std::size_t from) const {
  for (std::size_t k = from; k < levels_.size(); ++k) {
    const Level& level = levels_[k];
    const double i = (along_m + level.half_m) / level.cell_m;
    const double j = (across_m + level.half_m) / level.cell_m;
    if (i < 0 || j < 0 || i > nodes - 1 || j > nodes - 1) continue;
    const int column = std::min(static_cast<int>(i), nodes - 2);
    const int row = std::min(static_cast<int>(j), nodes - 2);
    return {&level, node_at(row, column), i - column, j - row};
  }
  return {nullptr, 0, 0, 0};
}

TerrainShadow::Limits TerrainShadow::unobstructed() {
  Limits limits_m;
  limits_m.fill(no_ground_m);
  return limits_m;
}

TerrainShadow::Limits TerrainShadow::limits_at(const GridPosition& grid_position) {
  const std::vector<StoredLimits>& at = grid_position.level->limits_m;
  const std::size_t k = grid_position.node;
  return between(between(at[k], at[k + 1], grid_position.right),
                 between(at[k + nodes], at[k + nodes + 1], grid_position.right), grid_position.up);
}

double TerrainShadow::share_at(const GridPosition& at) {
  const std::vector<float>& share = at.level->share;
  const std::size_t k = at.node;
  return std::lerp(std::lerp(share[k], share[k + 1], at.right),
                   std::lerp(share[k + nodes], share[k + nodes + 1], at.right), at.up);
}

double TerrainShadow::on_ground(const Vec3& p_m) const {
  const double along_m = p_m.dot(along_S_), across_m = p_m.dot(across_S_);
  const GridPosition at = grid_position(along_m, across_m);
  if (!at.level) return slopes_.front() > 0 ? 1 : 0;
  // Blends into the coarser square, in which small features cast no shadow.
  const double out = std::max(std::abs(along_m), std::abs(across_m)) / at.level->half_m;
  const double coarse = (out - faded_from) / (1 - faded_from);
  const auto next = static_cast<std::size_t>(at.level - levels_.data()) + 1;
  if (coarse <= 0 || next == levels_.size()) return share_at(at);
  return std::lerp(share_at(at), share_at(grid_position(along_m, across_m, next)), coarse);
}

double TerrainShadow::at(const Vec3& p_m) const {
  const GridPosition at = grid_position(p_m.dot(along_S_), p_m.dot(across_S_));
  if (!at.level) return slopes_.front() > 0 ? 1 : 0;
  return share_of(p_m.dot(up_S_), limits_at(at), at.level->cell_m);
}

}  // namespace lsos
