// Ground that hides the Sun, against rays marched over the ground.
#include "view/exposure/sun_column.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <random>

#include "support/cratered_terrain.h"
#include "unit/view/view_fixture.h"
#include "view/exposure/panel_view.h"
#include "view/exposure/sun_disc.h"

namespace lsos {
namespace {

using test::deg;
using test::direction;

double share_by_drawing(PanelView& view, const Ground& ground, const PanelFace& panel,
                        const std::vector<DiscSample>& samples, const Vec3& sun_S,
                        double disc_rad) {
  const double reach_m = panel.half_u_m.norm() + panel.half_v_m.norm();
  const Mesh mesh = ground_mesh(ground, sun_column(panel.centre_m, reach_m, sun_S, disc_rad));
  PanelFace about = panel;
  about.centre_m = Vec3::Zero();
  std::vector<Vec3> directions;
  for (const DiscSample& s : samples) directions.push_back(s.direction);
  const auto shares = view.visible_shares(about, mesh, directions);
  double seen = 0;
  for (std::size_t k = 0; k < shares.size(); ++k) seen += samples[k].weight * shares[k];
  return seen;
}

// The ground near by in full detail, farther away without small detail.
struct Probes {
  explicit Probes(const Ground& ground) : near(ground), middle(ground, 8), far(ground, 100) {}
  Ground::Probe near, middle, far;
};

// Steps are 1/500 of the distance, or 0.3 of the ray's height above the ground if that is more.
bool is_lit(Probes& probes, const Vec3& from_S_m, const Vec3& towards) {
  for (double distance_m = 0.05; distance_m < 150e3;) {
    Ground::Probe& probe = distance_m < 100    ? probes.near
                           : distance_m < 3000 ? probes.middle
                                               : probes.far;
    const GroundSample ground = probe.sample(from_S_m + distance_m * towards);
    if (!ground.is_ground() || ground.gap_m > 12000) return true;
    if (ground.gap_m < 0) return false;
    distance_m += std::max({0.05, 0.002 * distance_m, 0.3 * ground.gap_m});
  }
  return true;
}

// Elevation at which the sky begins.
double horizon_rad(const Ground& ground, const Vec3& from_S_m, double azimuth_rad) {
  Probes probes(ground);
  double low = -0.1, high = 1;
  while (high - low > 1e-4) {
    const double middle = (low + high) / 2;
    (is_lit(probes, from_S_m, direction(azimuth_rad, middle)) ? high : low) = middle;
  }
  return high;
}

double share_by_marching(const Ground& ground, const PanelFace& panel,
                         const std::vector<DiscSample>& samples) {
  Probes probes(ground);
  constexpr int side = 6;
  double seen = 0;
  for (const DiscSample& s : samples) {
    for (int j = 0; j < side; ++j) {
      for (int i = 0; i < side; ++i) {
        const double a = (2 * i + 1.0) / side - 1, b = (2 * j + 1.0) / side - 1;
        const Vec3 from = panel.centre_m + a * panel.half_u_m + b * panel.half_v_m;
        if (is_lit(probes, from, s.direction)) seen += s.weight / (side * side);
      }
    }
  }
  return seen;
}

TEST(SunColumn, hides_what_marched_rays_do_not_reach) {
  const SiteFrame site(*find_body("Moon"), geodetic_from_degrees(2, -85.05));
  const Ground ground(cratered_terrain(2), site, 3);
  const Gpu gpu;
  PanelView view(gpu);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(0, 1);
  const double disc_rad = 0.2666 * deg;
  double sum = 0, worst = 0;
  int partly = 0;
  constexpr int count = 20;
  for (int k = 0; k < count; ++k) {
    Ground::Probe probe(ground);
    const Vec3 place(1500 * (unit(random) - 0.5), 1500 * (unit(random) - 0.5), 0);
    const GroundSample under = probe.sample(place);
    const double azimuth = 2 * std::numbers::pi * unit(random);
    // An upright panel that faces the Sun, 2 m above the ground, with the disc near the horizon.
    PanelFace panel;
    panel.centre_m = place - (under.gap_m - 2) * under.up_S;
    const double above_rad = (3 * unit(random) - 1.5) * disc_rad;
    const Vec3 sun = direction(azimuth, horizon_rad(ground, panel.centre_m, azimuth) + above_rad);
    panel.half_u_m = 0.7 * Vec3::UnitZ().cross(sun).normalized();
    panel.half_v_m = 0.5 * Vec3::UnitZ();
    const auto samples = disc_samples(sun, disc_rad, 16);
    const double drawn = share_by_drawing(view, ground, panel, samples, sun, disc_rad);
    const double marched = share_by_marching(ground, panel, samples);
    sum += std::abs(drawn - marched);
    worst = std::max(worst, std::abs(drawn - marched));
    partly += marched > 0.02 && marched < 0.98;
  }
  std::printf("mean %.4f, worst %.4f; %d of %d partly lit\n", sum / count, worst, partly, count);
  EXPECT_LT(sum / count, 0.01);
  EXPECT_LT(worst, 0.03);
  EXPECT_GT(partly, 10);
}

// On a smooth sphere the Sun sets at the horizon, which from a height h is sqrt(2 h / R) below
// level.
TEST(SunColumn, has_the_horizon_of_a_sphere) {
  TerrainSpec spec;
  spec.layers = {PlaneSurface{}};
  ReliefSurface level;
  spec.layers = {level};
  const SiteFrame site(*find_body("Moon"), {0, 0, 0});
  const Ground ground(spec, site, 0);
  const Gpu gpu;
  PanelView view(gpu);
  const double height_m = 50, dip_rad = std::sqrt(2 * height_m / 1737400);
  PanelFace panel{{0, 0, height_m}, {0, 0.01, 0}, {0, 0, 0.01}};
  for (const double above : {-0.1, -0.02, 0.02, 0.1}) {
    const double elevation = -dip_rad * (1 - above);
    const Vec3 sun(std::cos(elevation), 0, std::sin(elevation));
    const auto samples = disc_samples(sun, 1e-7, 1);
    EXPECT_EQ(share_by_drawing(view, ground, panel, samples, sun, 1e-7), above > 0 ? 1 : 0)
        << above;
  }
}

}  // namespace
}  // namespace lsos
