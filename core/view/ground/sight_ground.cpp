#include "view/ground/sight_ground.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace lsos {

namespace {

// Spacing of the coarse rows that are sampled first, in the middle of the strip.
constexpr double sight_first_rows_m = 0.5, sight_first_share = 0.01;
constexpr int sight_nodes_across = 3;  // of the rows in the mesh
// Greatest slope (tangent) of the ground between coarse rows.
constexpr double sight_rise_max = 1.2;

}  // namespace

// Positions count along the line and across it, level at the first end.
class SightGround::Strip {
 public:
  Strip(SightGround& sight, const Vec3& from_S_m, const Vec3& to_S_m, double half_m)
      : sight_(sight), from_S_m_(from_S_m), half_m_(half_m) {
    const Vec3 up_S = sight.ground_->site().up_S(from_S_m), line_m = to_S_m - from_S_m;
    const Vec3 level_m = line_m - line_m.dot(up_S) * up_S;
    length_m_ = level_m.norm();
    if (length_m_ <= 0) return;
    along_S_ = line_m / length_m_;
    across_S_ = up_S.cross(level_m / length_m_);
    rise_max_ = sight_rise_max + std::abs(line_m.dot(up_S)) / length_m_;
  }

  Mesh mesh() {
    double at_m = 0, gap_m = middle_gap_m(0);
    bool is_open = false;  // the last row added is where this stretch begins
    while (at_m < length_m_ && !is_hidden_) {
      const double step_m = std::max(sight_first_rows_m, sight_first_share * to_nearer_end_m(at_m));
      const double free_m = std::isfinite(gap_m) ? (gap_m - margin_m()) / rise_max_ : 0;
      const double next_m = std::min(length_m_, at_m + std::max(step_m, free_m));
      const double next_gap_m = middle_gap_m(next_m);
      // Least gap below the line, from the gaps at both ends and the greatest slope.
      const double least_m = (gap_m + next_gap_m - rise_max_ * (next_m - at_m)) / 2;
      if (least_m > margin_m()) {
        is_open = false;
      } else {
        if (!is_open) add_row(at_m, false);
        is_open = true;
        for (double row_m = at_m; row_m < next_m && !is_hidden_;) {
          row_m = std::min(next_m, row_m + RowProbes::step_m(to_nearer_end_m(row_m)));
          add_row(row_m, true);
        }
      }
      at_m = next_m;
      gap_m = next_gap_m;
    }
    return std::move(mesh_);
  }

 private:
  // Ground that lies lower than this below the line hides nothing, even if it rises across the
  // strip.
  double margin_m() const { return half_m_ * (1 + rise_max_); }
  double to_nearer_end_m(double at_m) const { return std::min(at_m, length_m_ - at_m); }
  // Height of the line above the ground; infinite where there is no ground.
  double middle_gap_m(double at_m) {
    const GroundSample sample =
        sight_.probes_.at(to_nearer_end_m(at_m)).sample(from_S_m_ + at_m * along_S_);
    return sample.is_ground() ? sample.gap_m : std::numeric_limits<double>::infinity();
  }

  void add_row(double at_m, bool is_joined) {
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    bool is_over = true, is_ground = true;
    for (int k = 0; k < sight_nodes_across; ++k) {
      const double left_m = half_m_ * (2.0 * k / (sight_nodes_across - 1) - 1);
      const Vec3 on_line_m = at_m * along_S_ + left_m * across_S_;
      const GroundSample sample =
          sight_.probes_.at(to_nearer_end_m(at_m)).sample(from_S_m_ + on_line_m);
      is_ground &= sample.is_ground();
      is_over &= sample.is_ground() && sample.gap_m < -margin_m();
      const Vec3 p_m =
          sample.is_ground() ? Vec3(on_line_m - sample.gap_m * sample.up_S) : on_line_m;
      mesh_.vertices.push_back(
          {static_cast<float>(p_m.x()), static_cast<float>(p_m.y()), static_cast<float>(p_m.z())});
    }
    if (is_joined && is_ground && was_ground_) {
      for (std::uint32_t k = first - sight_nodes_across; k + 1 < first; ++k) {
        mesh_.triangles.push_back({k, k + 1, k + sight_nodes_across});
        mesh_.triangles.push_back({k + 1, k + sight_nodes_across + 1, k + sight_nodes_across});
      }
      is_hidden_ = is_over && was_over_;
    }
    was_ground_ = is_ground;
    was_over_ = is_over;
  }

  SightGround& sight_;
  Vec3 from_S_m_;
  double half_m_;
  double length_m_ = 0, rise_max_ = sight_rise_max;
  Vec3 along_S_ = Vec3::Zero(), across_S_ = Vec3::Zero();
  Mesh mesh_;
  bool was_ground_ = false, was_over_ = false, is_hidden_ = false;
};

Mesh SightGround::between(const Vec3& from_S_m, const Vec3& to_S_m, double half_m) {
  return Strip(*this, from_S_m, to_S_m, half_m).mesh();
}

}  // namespace lsos
