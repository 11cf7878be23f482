#include "view/exposure/diffuse_view.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace lsos {

namespace {

constexpr int drawn = std::tuple_size_v<OpenShares>;
constexpr int fine = 1024;

struct DiscPoint {
  double x, y;
};

// Points of equal area in a unit disc, on a sunflower spiral (Vogel 1979). Raised onto the
// hemisphere above it they are directions of equal weight for an even light on the disc.
DiscPoint point_of_disc(int k, int count) {
  const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
  const double radius = std::sqrt((k + 0.5) / count), angle = k * golden_angle;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

Vec3 direction(const PanelFace& panel, const DiscPoint& at) {
  const Vec3 normal = panel.normal();
  const Vec3 across = panel.half_u_m.normalized(), along = normal.cross(across);
  const double height2 = 1 - at.x * at.x - at.y * at.y;
  return at.x * across + at.y * along + std::sqrt(std::max(0.0, height2)) * normal;
}

// The drawn direction nearest to each of the fine ones, in the disc.
std::array<std::size_t, fine> nearest_drawn() {
  std::array<std::size_t, fine> nearest{};
  for (int k = 0; k < fine; ++k) {
    const DiscPoint at = point_of_disc(k, fine);
    double least = std::numeric_limits<double>::infinity();
    for (int j = 0; j < drawn; ++j) {
      const DiscPoint other = point_of_disc(j, drawn);
      const double away = std::hypot(at.x - other.x, at.y - other.y);
      if (away >= least) continue;
      least = away;
      nearest[static_cast<std::size_t>(k)] = static_cast<std::size_t>(j);
    }
  }
  return nearest;
}

}  // namespace

OpenShares open_shares(PanelView& view, const PanelFace& panel, const Mesh& solids) {
  std::vector<Vec3> directions;
  for (int k = 0; k < drawn; ++k) directions.push_back(direction(panel, point_of_disc(k, drawn)));
  const std::vector<double> shares = view.visible_shares(panel, solids, directions);
  OpenShares open{};
  std::ranges::copy(shares, open.begin());
  return open;
}

DiffuseView diffuse_view(const OpenShares& open, const PanelFace& panel,
                         const TerrainHorizon& horizon, const Compass& compass) {
  static const std::array<std::size_t, fine> nearest = nearest_drawn();
  DiffuseView view;
  for (int k = 0; k < fine; ++k) {
    const Vec3 to = direction(panel, point_of_disc(k, fine));
    const double east = to.dot(compass.east), north = to.dot(compass.north);
    const double elevation_rad = std::atan2(to.dot(compass.up), std::hypot(east, north));
    const bool is_sky = elevation_rad > 0 && elevation_rad > horizon.at(std::atan2(east, north));
    (is_sky ? view.sky : view.ground) += open[nearest[static_cast<std::size_t>(k)]] / fine;
  }
  return view;
}

}  // namespace lsos
