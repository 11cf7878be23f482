#include "view/picture/ground_view.h"

#include <numbers>

#include "view/ground/highest_ground.h"
#include "view/ground/lod_probes.h"
#include "view/ground/parallel_rows.h"

namespace lsos {

namespace {

constexpr double across_px = 3, along_px = 2;  // between nodes
constexpr double along_share_max = 0.014;      // of the distance
// Resolution of ground samples in node spacings: detail is then drawn on nodes somewhat closer than
// those of the mesh.
constexpr double resolution_steps = 14;
constexpr double far_m = 2500, picture_far_share = 0.02;  // from there on rows are wider apart
constexpr double ground_nearest_m = 0.3;
constexpr double steep = 0.8;  // sine of the pitch downwards beyond which a camera sees no horizon

// Sample positions in rows and columns, relative to the eye, at about the height of the ground.
struct Lattice {
  std::vector<std::vector<Vec3>> rows;  // from near to far where there is such an order
  std::vector<double> step_m;           // spacing of neighbours, by row
};

// Greatest distance at which anything may rise above the horizon.
double sight_m(const Body& body, double eye_height_m) {
  const double around_m = 2 * body.equatorial_radius_m;
  return std::sqrt(around_m * std::max(10.0, eye_height_m + 100)) +
         std::sqrt(around_m * body.highest_ground_m);
}

// Rings around the point below a camera that sees, or may see, the horizon.
Lattice fan(const SiteFrame& site, const Camera& camera, double eye_gap_m) {
  const Vec3 up_S = site.up_S(camera.eye_S_m);
  const auto [along_S, half_rad] = sector_of(site, camera);
  const Vec3 across_S = along_S.cross(up_S);
  const double pitch_rad = std::asin(camera.ahead_S.dot(up_S));
  const double half_up_rad = std::atan(camera.height_px / 2.0 / camera.focal_px);
  const double step_rad = across_px / camera.focal_px;
  const int columns = static_cast<int>(2 * half_rad / step_rad) + 2;
  const double down_rad = std::min(half_up_rad - pitch_rad + 0.05, 1.5);
  const double radius_m = site.body().equatorial_radius_m;
  const double end_m = sight_m(site.body(), site.height_m(camera.eye_S_m));
  // Relief may lift the ground towards the eye by a quarter of the eye's height.
  double r_m = std::max(ground_nearest_m, 0.75 * eye_gap_m / std::tan(std::max(down_rad, 0.05)));
  Lattice lattice;
  while (r_m < end_m) {
    const double seen_m = r_m * r_m * along_px / (camera.focal_px * std::max(eye_gap_m, 0.3));
    const double step_m =
        std::clamp(seen_m, std::max(0.02, 0.7 * step_rad * r_m),
                   (r_m > far_m ? picture_far_share : along_share_max) * r_m + 0.02);
    const double drop_m = eye_gap_m + r_m * r_m / (2 * radius_m);
    lattice.rows.emplace_back();
    for (int k = 0; k < columns; ++k) {
      const double a = -half_rad + 2 * half_rad * k / (columns - 1);
      lattice.rows.back().push_back(r_m * (std::cos(a) * along_S + std::sin(a) * across_S) -
                                    drop_m * up_S);
    }
    lattice.step_m.push_back(std::sqrt(step_m * step_rad * r_m));
    r_m += step_m;
  }
  return lattice;
}

// A rectangle under a camera that looks down.
Lattice square(const Camera& camera, double eye_gap_m) {
  const double slant = -1 / camera.ahead_S.z();
  const double cell_m = camera.metres_per_pixel(eye_gap_m) * across_px;
  const double margin = 1.15 * slant;  // for ground that rises or falls
  const int rows = static_cast<int>(margin * camera.height_px / across_px);
  const int columns = static_cast<int>(margin * camera.width_px / across_px);
  Lattice lattice;
  for (int j = 0; j <= rows; ++j) {
    lattice.rows.emplace_back();
    for (int i = 0; i <= columns; ++i) {
      lattice.rows.back().push_back(
          eye_gap_m * slant * camera.ahead_S +
          cell_m * ((i - columns / 2.0) * camera.right_S() + (j - rows / 2.0) * camera.up_S));
    }
    lattice.step_m.push_back(cell_m);
  }
  return lattice;
}

// Adds rows of nodes as triangles; those with a corner without ground are left out.
void add_triangles(SceneMesh& mesh, std::size_t rows, std::size_t columns,
                   const std::vector<std::uint8_t>& is_ground) {
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    if (is_ground[a] == 0 || is_ground[b] == 0 || is_ground[c] == 0) return;
    mesh.triangles.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
                              static_cast<std::uint32_t>(c)});
  };
  for (std::size_t j = 0; j + 1 < rows; ++j) {
    for (std::size_t i = 0; i + 1 < columns; ++i) {
      const std::size_t k = j * columns + i;
      add(k, k + 1, k + columns);
      add(k + 1, k + columns + 1, k + columns);
    }
  }
}

}  // namespace

GroundSector sector_of(const SiteFrame& site, const Camera& camera) {
  const Vec3 up_S = site.up_S(camera.eye_S_m);
  const double sine = camera.ahead_S.dot(up_S);
  if (sine < -steep) return {};
  const double pitch_rad = std::asin(sine);
  // Widest azimuth of the picture's corners and of the middles of its sides.
  const double side = camera.width_px / 2.0 / camera.focal_px;
  const double end = camera.height_px / 2.0 / camera.focal_px;
  double half_rad = 0;
  for (const double up : {-end, 0.0, end}) {
    half_rad = std::max(half_rad,
                        std::abs(std::atan2(side, std::cos(pitch_rad) - up * std::sin(pitch_rad))));
  }
  return {(camera.ahead_S - sine * up_S).normalized(), std::min(half_rad + 0.02, std::numbers::pi)};
}

SceneMesh ground_view(const Ground& ground, const Camera& camera, const TerrainShadow& shadow,
                      const Vec3& colour) {
  const SiteFrame& site = ground.site();
  const Vec3 up_S = site.up_S(camera.eye_S_m);
  const GroundSample below = Ground::Probe(ground).sample(camera.eye_S_m);
  const double eye_gap_m = below.is_ground() ? std::max(0.1, below.gap_m) : 1;
  const Lattice lattice =
      camera.ahead_S.dot(up_S) < -steep ? square(camera, eye_gap_m) : fan(site, camera, eye_gap_m);
  const std::size_t rows = lattice.rows.size(), columns = lattice.rows.front().size();
  SceneMesh mesh;
  mesh.vertices.resize(rows * columns);
  std::vector<std::uint8_t> is_ground(rows * columns, 0);
  std::vector<double> gap_m(rows * columns, 0);
  const auto place = [&](std::size_t k, const Vec3& p_m, const Vec3& normal_S, const Vec3& up) {
    SceneVertex& vertex = mesh.vertices[k];
    const Vec3 at_m = p_m - gap_m[k] * up;
    vertex.p_m = single(at_m);
    vertex.normal = single(normal_S);
    vertex.colour = single(colour);
    vertex.sun_share = static_cast<float>(shadow.on_ground(at_m));
    is_ground[k] = 1;
  };
  const auto row = [&](LodProbes& probes, int j) {
    const auto at = static_cast<std::size_t>(j);
    for (std::size_t i = 0; i < columns; ++i) {
      const Vec3& p_m = lattice.rows[at][i];
      const GroundSample sample =
          probes.sample(camera.eye_S_m + p_m, resolution_steps * lattice.step_m[at]);
      if (!sample.is_ground()) continue;
      gap_m[at * columns + i] = sample.gap_m;
      place(at * columns + i, p_m, sample.normal_S, sample.up_S);
    }
  };
  parallel_for_rows(
      static_cast<int>(rows), [&] { return LodProbes(ground); }, row);
  for (std::size_t k = columns; k < rows * columns; ++k) {
    if (is_ground[k] != 0 || is_ground[k - columns] == 0) continue;
    gap_m[k] = gap_m[k - columns];
    const Vec3& p_m = lattice.rows[k / columns][k % columns];
    const Vec3 up = site.up_S(camera.eye_S_m + p_m);
    place(k, p_m, up, up);
  }
  add_triangles(mesh, rows, columns, is_ground);
  return mesh;
}

Vec3 clear_eye_S_m(const Ground& ground, const Vec3& eye_S_m, const Vec3& target_S_m,
                   double clear_m) {
  constexpr int steps = 40;
  Ground::Probe probe(ground);
  const Vec3 up_S = ground.site().up_S(eye_S_m);
  double lift_m = 0;
  for (int k = 0; k < steps; ++k) {
    const double share = 1 - static_cast<double>(k) / steps;  // 1 at the eye, near 0 at the target
    const GroundSample sample = probe.sample(target_S_m + share * (eye_S_m - target_S_m));
    if (!sample.is_ground()) continue;
    lift_m = std::max(lift_m, (share * clear_m - sample.gap_m) / share);
  }
  return eye_S_m + lift_m * up_S;
}

}  // namespace lsos
