#include "view/exposure/sun_column.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "view/ground/highest_ground.h"
#include "view/ground/row_probes.h"

namespace lsos {

namespace {

// Spacing of the coarse rows that are sampled first, in the middle of the strip.
constexpr double column_first_rows_m = 0.5, column_first_share = 0.01;
constexpr int column_nodes_across = 13;  // of the rows in the mesh
// Greatest slope (tangent) of the ground between coarse rows.
constexpr double column_rise_max = 1.2;
constexpr double column_farthest_m = 400e3;

// The strip in its own axes: x towards the Sun, y across, z up at the eye.
class Strip {
 public:
  Strip(const Ground& ground, const SunColumn& column)
      : ground_(ground),
        column_(column),
        probes_(ground),
        first_probes_(ground, ProbeDetail::sparse) {
    const Vec3 up_S = ground.site().up_S(column.eye_S_m);
    const double sine = column.sun_S.dot(up_S);
    const Vec3 level_S = column.sun_S - sine * up_S;
    const Vec3 along_S = level_S.norm() > 1e-9 ? level_S.normalized() : up_S.unitOrthogonal();
    axes_S_ << along_S, up_S.cross(along_S), up_S;
    elevation_rad_ = std::atan2(sine, level_S.norm());
    const auto start = node(probes_.at(0), 0, 0);
    last_height_m_ = start ? ground.site().height_m(column.eye_S_m + axes_S_ * *start) : 0;
  }

  const Mat3& axes_S() const { return axes_S_; }
  double half_width_m(double x_m) const {
    return column_.reach_m + 1.1 * x_m * std::tan(column_.disc_rad);
  }
  // Greatest and least slope at which a point is seen from any part of the lit object; its x must
  // exceed the reach.
  double steepest(const Vec3& at) const {
    const double rise_m = at.z() - column_.low_m;
    return rise_m / (rise_m > 0 ? at.x() - column_.reach_m : at.x() + column_.reach_m);
  }
  double flattest(const Vec3& at) const {
    const double rise_m = at.z() - column_.high_m;
    return rise_m / (rise_m > 0 ? at.x() + column_.reach_m : at.x() - column_.reach_m);
  }
  bool is_past_reach(double x_m) const { return x_m > 2 * column_.reach_m; }
  // Ground that is seen at a steeper slope than this hides the whole disc.
  double top_ray_slope() const {
    return std::tan(std::clamp(elevation_rad_ + column_.disc_rad, -1.5, 1.5));
  }
  // Height of the lowest ray to the Sun from any part of the lit object.
  double lowest_ray_m(double x_m) const {
    const double lowest_rad = elevation_rad_ - column_.disc_rad;
    const double slope = std::tan(std::clamp(lowest_rad, -1.5, 1.5));
    return column_.low_m + x_m * slope - column_.reach_m * std::abs(slope);
  }
  // Whether even the highest ground of the body would lie below all rays at that distance.
  bool is_beyond(double x_m) const {
    const Body& body = ground_.site().body();
    const double drop_m = x_m * x_m / (2 * body.equatorial_radius_m);
    const double eye_m = ground_.site().height_m(column_.eye_S_m);
    return lowest_ray_m(x_m) + drop_m > body.highest_ground_m - eye_m;
  }
  // The ground at that position, in the strip's axes; beyond its end at the last height found.
  Vec3 point(double x_m, double y_m) { return point(probes_.at(x_m), x_m, y_m); }
  // The same without detail narrower than two nodes, which are as far apart as the coarse rows. The
  // missing detail is at most twice that spacing high; rocks are as high as they are wide.
  Vec3 first_point(double x_m) { return point(first_probe(x_m), x_m, 0); }
  // Upper bound on the height in the strip's axes of the ground between two rows; infinite where
  // none is known.
  double highest_m(double x_m, double next_m) {
    const std::array<Vec3, 4> corners_S_m{
        place_S_m(x_m, -half_width_m(next_m)), place_S_m(x_m, half_width_m(next_m)),
        place_S_m(next_m, -half_width_m(next_m)), place_S_m(next_m, half_width_m(next_m))};
    std::optional<double> highest_m = probes_.at(x_m).highest_m(corners_S_m);
    if (highest_m && &probes_.at(next_m) != &probes_.at(x_m)) {
      const auto beyond_m = probes_.at(next_m).highest_m(corners_S_m);
      highest_m = beyond_m ? std::optional(std::max(*highest_m, *beyond_m)) : std::nullopt;
    }
    if (!highest_m) return std::numeric_limits<double>::infinity();
    return std::max(at_height(place_S_m(x_m, 0), *highest_m).z(),
                    at_height(place_S_m(next_m, 0), *highest_m).z());
  }

 private:
  Vec3 point(Ground::Probe& probe, double x_m, double y_m) {
    if (const auto found = node(probe, x_m, y_m)) {
      last_height_m_ = ground_.site().height_m(column_.eye_S_m + axes_S_ * *found);
      return *found;
    }
    return at_height(place_S_m(x_m, y_m), last_height_m_);
  }

  Vec3 place_S_m(double x_m, double y_m) const {
    return column_.eye_S_m + axes_S_ * Vec3(x_m, y_m, 0);
  }
  // The point above or below a place at that height above the reference surface, in the strip's
  // axes.
  Vec3 at_height(const Vec3& p_S_m, double height_m) const {
    const Vertical at = ground_.site().vertical(p_S_m);
    return axes_S_.transpose() * (p_S_m - (at.height_m - height_m) * at.up_S - column_.eye_S_m);
  }

  std::optional<Vec3> node(Ground::Probe& probe, double x_m, double y_m) {
    const Vec3 p_S_m = place_S_m(x_m, y_m);
    const GroundSample sample = probe.sample(p_S_m);
    if (!sample.is_ground()) return {};
    return axes_S_.transpose() * (p_S_m - sample.gap_m * sample.up_S - column_.eye_S_m);
  }
  // The probe for coarse rows at that distance, one per octave.
  Ground::Probe& first_probe(double x_m) {
    return first_probes_.at(octave_below_m(column_first_rows_m, column_first_share * x_m));
  }

  const Ground& ground_;
  const SunColumn& column_;
  Mat3 axes_S_;
  double elevation_rad_ = 0;
  double last_height_m_ = 0;
  RowProbes probes_;
  GroundProbes first_probes_;
};

// The mesh, built row by row across the strip; a row may be joined to the one before it.
class StripMesh {
 public:
  explicit StripMesh(Strip& strip) : strip_(strip) {}

  void add_row(double x_m, bool is_joined) {
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    double lowest = strip_.is_past_reach(x_m) ? std::numeric_limits<double>::infinity()
                                              : -std::numeric_limits<double>::infinity();
    for (int k = 0; k < column_nodes_across; ++k) {
      const double y_m = strip_.half_width_m(x_m) * (2.0 * k / (column_nodes_across - 1) - 1);
      const Vec3 at = strip_.point(x_m, y_m);
      const bool is_hidden = strip_.is_past_reach(x_m) && strip_.steepest(at) < ridge_;
      is_low_.push_back(at.z() < strip_.lowest_ray_m(at.x()) || is_hidden);
      if (strip_.is_past_reach(x_m)) lowest = std::min(lowest, strip_.flattest(at));
      const Vec3 p = strip_.axes_S() * at;
      mesh_.vertices.push_back(
          {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())});
    }
    if (!is_joined) return;
    for (std::uint32_t k = first - column_nodes_across; k + 1 < first; ++k) {
      add_triangle({k, k + 1, k + column_nodes_across});
      add_triangle({k + 1, k + column_nodes_across + 1, k + column_nodes_across});
    }
    // Ground drawn between two rows hides at least what the lower row hides.
    ridge_ = std::max(ridge_, lowest);
  }
  double ridge() const { return ridge_; }
  Mesh take() { return std::move(mesh_); }

 private:
  // The lowest rays lie in a plane: a triangle with all corners below it meets none of them.
  void add_triangle(const std::array<std::uint32_t, 3>& corners) {
    if (is_low_[corners[0]] && is_low_[corners[1]] && is_low_[corners[2]]) return;
    mesh_.triangles.push_back(corners);
  }

  Strip& strip_;
  Mesh mesh_;
  std::vector<bool> is_low_;  // by vertex: below all rays, or behind the ridge
  // Least slope at which ground already in the mesh is seen across the whole strip; it hides lower
  // ground behind it.
  double ridge_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

Mesh ground_mesh(const Ground& ground, const SunColumn& column) {
  Strip strip(ground, column);
  StripMesh mesh(strip);
  bool is_open = false;  // the last row added is where this stretch begins
  double x_m = 0, z_m = strip.first_point(0).z();  // of the middle line
  while (x_m < column_farthest_m && !strip.is_beyond(x_m) && mesh.ridge() < strip.top_ray_slope()) {
    const double next_m = x_m + std::max(column_first_rows_m, column_first_share * x_m);
    const double next_z_m = strip.first_point(next_m).z(), height_m = std::max(z_m, next_z_m);
    z_m = next_z_m;
    const double missing_m = 2 * (next_m - x_m);
    const double rise_m = column_rise_max * (next_m - x_m + strip.half_width_m(next_m)) + missing_m;
    // Whether ground up to that height lies below all rays, or behind what is in the mesh.
    const auto is_free = [&](double highest_m) {
      const bool is_hidden = strip.is_past_reach(x_m) &&
                             std::max(strip.steepest({x_m, 0, highest_m}),
                                      strip.steepest({next_m, 0, highest_m})) < mesh.ridge();
      return is_hidden || highest_m < std::min(strip.lowest_ray_m(x_m), strip.lowest_ray_m(next_m));
    };
    if (is_free(height_m + rise_m) || is_free(strip.highest_m(x_m, next_m))) {
      is_open = false;
      x_m = next_m;
      continue;
    }
    if (!is_open) mesh.add_row(x_m, false);
    is_open = true;
    for (double at_m = x_m; at_m < next_m;) {
      at_m = std::min(next_m, at_m + RowProbes::step_m(at_m));
      mesh.add_row(at_m, true);
    }
    x_m = next_m;
  }
  return mesh.take();
}

}  // namespace lsos
