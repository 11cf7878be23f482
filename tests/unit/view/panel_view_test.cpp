// Panels in shadow, against cases in closed form and rays through boxes.
#include "view/exposure/panel_view.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <random>

#include "unit/view/view_fixture.h"
#include "view/exposure/sun_disc.h"

namespace lsos {
namespace {

using test::deg;

struct Box {
  Vec3 size_m;
  Mat3 R;
  Vec3 p_m;
};

Mesh mesh_of(const std::vector<Box>& boxes) {
  Mesh mesh;
  for (const Box& box : boxes) append(mesh, box_mesh(box.size_m), box.R, box.p_m);
  return mesh;
}

// Slab test: intersects the ray's intervals between each pair of faces.
bool hits(const Box& box, const Vec3& from, const Vec3& towards) {
  const Vec3 p = box.R.transpose() * (from - box.p_m), d = box.R.transpose() * towards;
  double low = 1e-3, high = 1e9;
  for (int i = 0; i < 3; ++i) {
    const double a = (-box.size_m[i] / 2 - p[i]) / d[i], b = (box.size_m[i] / 2 - p[i]) / d[i];
    low = std::max(low, std::min(a, b));
    high = std::min(high, std::max(a, b));
  }
  return low < high;
}

double share_by_rays(const PanelFace& panel, const std::vector<Box>& boxes, const Vec3& towards) {
  constexpr int side = 200;
  int seen = 0;
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const double a = (2 * i + 1.0) / side - 1, b = (2 * j + 1.0) / side - 1;
      const Vec3 from = panel.centre_m + a * panel.half_u_m + b * panel.half_v_m;
      bool is_dark = false;
      for (const Box& box : boxes) is_dark |= hits(box, from, towards);
      seen += !is_dark;
    }
  }
  return static_cast<double>(seen) / (side * side);
}

Vec3 sun_direction(double azimuth_deg, double elevation_deg) {
  const double a = azimuth_deg * deg, e = elevation_deg * deg;
  return {std::cos(e) * std::sin(a), std::cos(e) * std::cos(a), std::sin(e)};
}

class PanelInView : public ::testing::Test {
 protected:
  double share(const PanelFace& panel, const std::vector<Box>& boxes, const Vec3& towards) {
    return view.visible_shares(panel, mesh_of(boxes), std::span(&towards, 1))[0];
  }
  Gpu gpu;
  PanelView view{gpu};
};

// A wall halfway to the viewer, whose edge is a quarter from the middle, hides in perspective what
// lies beyond a half of the panel. Behind the viewer, or within the margins, it hides nothing.
TEST_F(PanelInView, from_near_by_is_seen_in_perspective) {
  const PanelFace panel{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()};
  const auto seen = [&](double wall_m, const ViewMargins& margins) {
    const Mesh wall = mesh_of({{Vec3(10, 10, 0.01), Mat3::Identity(), Vec3(5.25, 0, wall_m)}});
    const Viewpoint viewer{Vec3::UnitZ(), 10};
    return view.visible_shares(panel, wall, std::span(&viewer, 1), margins)[0];
  };
  EXPECT_NEAR(seen(5, {}), 0.75, 0.01);
  EXPECT_NEAR(seen(2, {}), (1 + 0.25 / 0.8) / 2, 0.01);
  EXPECT_EQ(seen(12, {}), 1);
  EXPECT_EQ(seen(9.8, {0.3, 0.3}), 1);
  EXPECT_EQ(seen(0.2, {0.3, 0.3}), 1);
}

TEST_F(PanelInView, alone_is_seen_whole_from_its_front_only) {
  const PanelFace panel{{1, 2, 3}, {0.5, 0, 0}, {0, 0.3, 0}};
  EXPECT_EQ(share(panel, {}, sun_direction(30, 40)), 1);
  EXPECT_EQ(share(panel, {}, sun_direction(30, -40)), 0);
  EXPECT_EQ(share(panel, {{Vec3::Ones(), Mat3::Identity(), {1, 2, 0}}}, sun_direction(30, 40)), 1);
}

TEST_F(PanelInView, is_half_in_the_shade_of_a_wall) {
  // Upright, 2 m high, facing north; the wall's shadow reaches 1 m up it.
  const PanelFace panel{{0, 0, 1}, {-1, 0, 0}, {0, 0, 1}};
  const double away_m = 10, elevation_deg = 20;
  const double wall_m = 1 + away_m * std::tan(elevation_deg * deg);
  const Box wall{{100, 0.1, 2 * wall_m}, Mat3::Identity(), {0, away_m + 0.05, 0}};
  EXPECT_NEAR(share(panel, {wall}, sun_direction(0, elevation_deg)), 0.5, 0.01);
}

TEST_F(PanelInView, is_dark_behind_something_large_at_any_distance) {
  const PanelFace panel{{0, 0, 2}, {0, 0.5, 0}, {0, 0, 0.5}};
  for (const double far_m : {1.0, 100.0, 10000.0, 100000.0}) {
    const Box plate{{1, 3, 3}, Mat3::Identity(), {far_m, 0, 2}};
    EXPECT_EQ(share(panel, {plate}, Vec3::UnitX()), 0) << far_m;
    // The plate is moved so that its edge is at the middle of the panel.
    const Box aside{{1, 3, 3}, Mat3::Identity(), {far_m, 1.5, 2}};
    EXPECT_NEAR(share(panel, {aside}, Vec3::UnitX()), 0.5, 0.02) << far_m;
  }
}

TEST_F(PanelInView, is_as_dark_as_rays_through_boxes_say) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&] { return Vec3(unit(random), unit(random), unit(random)); };
  double sum = 0, worst = 0;
  int count = 0;
  for (int scene = 0; scene < 150; ++scene) {
    const Mat3 R = Quat(unit(random), unit(random), unit(random), unit(random))
                       .normalized()
                       .toRotationMatrix();
    const PanelFace panel{vector(), R.col(0) * (0.3 + std::abs(unit(random))),
                          R.col(1) * (0.3 + std::abs(unit(random)))};
    std::vector<Box> boxes;
    for (int k = 0; k < 5; ++k) {
      boxes.push_back({Vec3::Ones() * 0.2 + vector().cwiseAbs(),
                       Quat(unit(random), unit(random), unit(random), unit(random))
                           .normalized()
                           .toRotationMatrix(),
                       panel.centre_m + 3 * vector() + 2 * panel.normal()});
    }
    const Vec3 towards = (panel.normal() + 0.9 * vector().normalized()).normalized();
    const double error =
        std::abs(share(panel, boxes, towards) - share_by_rays(panel, boxes, towards));
    sum += error;
    worst = std::max(worst, error);
    ++count;
  }
  std::printf("mean %.4f, worst %.4f of full panel over %d scenes\n", sum / count, worst, count);
  EXPECT_LT(sum / count, 0.01);
  EXPECT_LT(worst, 0.03);
}

// Visible shares of 16 panels, each among boxes and over rough ground, under suns down to the
// horizon.
std::vector<double> shares_on(GpuChoice choice, std::string& device) {
  const Gpu gpu(choice);
  device = gpu.name();
  PanelView view(gpu);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&] { return Vec3(unit(random), unit(random), unit(random)); };
  std::vector<double> shares;
  for (int scene = 0; scene < 16; ++scene) {
    Mesh occluders;
    for (int k = 0; k < 8; ++k) {
      const Mat3 R = Quat(unit(random), unit(random), unit(random), unit(random))
                         .normalized()
                         .toRotationMatrix();
      append(occluders, box_mesh(Vec3::Ones() * 0.2 + vector().cwiseAbs()), R, 3 * vector());
    }
    constexpr int side = 40;
    for (int k = 0; k < side * side; ++k) {
      const Vec3 at_m(k % side - side / 2, k / side - side / 2, -4 + 0.3 * unit(random));
      append(occluders, box_mesh({1, 1, 2}), Mat3::Identity(), at_m);
    }
    const Vec3 upright = (Vec3(0, 0, 1) + 0.7 * vector()).normalized();
    const Vec3 u = upright.cross(vector()).normalized();
    const PanelFace panel{0.5 * vector(), 0.8 * u, 0.5 * upright.cross(u)};
    std::vector<Vec3> suns;
    for (int k = 0; k < 32; ++k)
      suns.push_back(sun_direction(180 * unit(random), 45 + 44 * unit(random)));
    const auto seen = view.visible_shares(panel, occluders, suns);
    shares.insert(shares.end(), seen.begin(), seen.end());
  }
  return shares;
}

// Compares two devices if the machine has a GPU; otherwise Mesa with itself, which is exact.
TEST(PanelOnDevices, is_seen_alike) {
  std::string device, mesa;
  const std::vector<double> here = shares_on(GpuChoice::any, device);
  const std::vector<double> there = shares_on(GpuChoice::software, mesa);
  ASSERT_EQ(here.size(), there.size());
  double sum = 0, worst = 0;
  std::size_t shaded = 0;
  for (std::size_t k = 0; k < here.size(); ++k) {
    const double off = std::abs(here[k] - there[k]);
    sum += off;
    worst = std::max(worst, off);
    if (there[k] > 0 && there[k] < 1) ++shaded;
  }
  std::printf("%s and %s: mean %.5f, worst %.5f of full panel, %zu of %zu partly shaded\n",
              device.c_str(), mesa.c_str(), sum / static_cast<double>(here.size()), worst, shaded,
              here.size());
  EXPECT_GT(shaded, here.size() / 10);
  EXPECT_LE(worst, device == mesa ? 0 : 0.01);
}

TEST_F(PanelInView, is_the_same_alone_and_among_many_directions) {
  const PanelFace panel{{0, 0, 2}, {0, 0.5, 0}, {0, 0, 0.5}};
  const Mesh post = mesh_of({{{0.2, 0.2, 3}, Mat3::Identity(), {3, 0, 1.5}}});
  const auto samples = disc_samples(Vec3(1, 0.02, 0.1).normalized(), 0.05, 64);
  std::vector<Vec3> directions;
  for (const DiscSample& s : samples) directions.push_back(s.direction);
  const auto together = view.visible_shares(panel, post, directions);
  for (std::size_t k = 0; k < directions.size(); ++k) {
    EXPECT_EQ(together[k], view.visible_shares(panel, post, std::span(&directions[k], 1))[0]);
  }
}

// As a straight edge moves across the Sun, the light follows the area of the disc's segment. The
// panel is so small that each direction is either seen or not: 64 of them err by at most 64^(-3/4)
// of the disc.
TEST_F(PanelInView, has_a_penumbra_behind_a_ridge) {
  const double radius_rad = 0.2666 * deg, far_m = 20000, elevation_rad = 1.5 * deg;
  const PanelFace panel{{0, 0, 1}, {0, 0.05, 0}, {0, 0, 0.05}};
  const Vec3 sun(std::cos(elevation_rad), 0, std::sin(elevation_rad));
  const auto samples = disc_samples(sun, radius_rad, 64);
  std::vector<Vec3> directions;
  for (const DiscSample& s : samples) directions.push_back(s.direction);
  for (double edge = -1.2; edge <= 1.2; edge += 0.1) {  // in radii of the disc, from its centre
    const double crest_m = 1 + far_m * std::tan(elevation_rad + edge * radius_rad);
    const Box ridge{{1, 4000, 2 * crest_m}, Mat3::Identity(), {far_m, 0, 0}};
    const auto shares = view.visible_shares(panel, mesh_of({ridge}), directions);
    double seen = 0;
    for (std::size_t k = 0; k < shares.size(); ++k) seen += samples[k].weight * shares[k];
    const double c = std::clamp(edge, -1.0, 1.0);
    const double expected = (std::acos(c) - c * std::sqrt(1 - c * c)) / std::numbers::pi;
    EXPECT_NEAR(seen, expected, 0.044) << edge;
  }
}

TEST(DiscSamples, are_even_over_the_disc) {
  const double radius_rad = 0.004;
  for (const auto darkening : {LimbDarkening::none, LimbDarkening::quadratic}) {
    const auto samples = disc_samples(Vec3(1, 2, 3).normalized(), radius_rad, 16, darkening);
    Vec3 mean = Vec3::Zero();
    double weights = 0, square = 0;
    for (const DiscSample& s : samples) {
      mean += s.weight * s.direction;
      weights += s.weight;
      square += s.weight * (s.direction - Vec3(1, 2, 3).normalized()).squaredNorm();
    }
    EXPECT_NEAR(weights, 1, 1e-12);
    EXPECT_LT((mean - Vec3(1, 2, 3).normalized()).norm(), 0.05 * radius_rad);
    // The mean square distance from the centre of a uniform disc is half its radius squared; with a
    // darker limb it is less.
    if (darkening == LimbDarkening::none) {
      EXPECT_NEAR(square / (radius_rad * radius_rad), 0.5, 0.01);
    } else {
      EXPECT_LT(square / (radius_rad * radius_rad), 0.49);
    }
  }
}

}  // namespace
}  // namespace lsos
