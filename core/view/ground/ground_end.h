// Finds where the known ground ends before the distance up to which ground can matter. Beyond that
// end nothing hides the Sun, Earth or another rover in a simulation, whatever may stand there. A
// ray that leaves the reach of the site (Ground::reaches) does not count as an end.
#pragma once

#include <optional>

#include "view/ground/ground_probes.h"

namespace lsos {

struct GroundEnd {
  double reaches_m = 0;  // distance to the end of the ground, or to a hole in it
  double matters_m = 0;  // ground up to this distance may hide what is seen
};

// Finds the end of the ground among samples along a ray, from near to far.
class GroundEndTracker {
 public:
  void add(double distance_m, bool is_ground) {
    if (is_ground) {
      last_ground_m_ = distance_m;
    } else if (!end_m_ && distance_m - last_ground_m_ > hole_share * distance_m) {
      end_m_ = last_ground_m_;
    }
  }
  // Distance of the last ground before its end, or before the first hole longer than a tenth of its
  // distance; absent if there is neither.
  std::optional<double> end_m() const { return end_m_; }

 private:
  static constexpr double hole_share = 0.1;
  double last_ground_m_ = 0;
  std::optional<double> end_m_;
};

// Use one per thread; results do not depend on earlier calls.
class GroundEndProbe {
 public:
  // `ground` must outlive it.
  explicit GroundEndProbe(const Ground& ground)
      : ground_(&ground), probes_(ground, ProbeDetail::sparse) {}

  const SiteFrame& site() const { return ground_->site(); }

  // Examines the ground towards a disc of angular radius `disc_rad` at infinite distance, centred
  // on a direction (unit, site axes). Absent where the ground reaches as far as it matters, and
  // where it hides the whole disc.
  std::optional<GroundEnd> towards(const Vec3& eye_S_m, const Vec3& direction_S, double disc_rad);
  // Examines the straight line between two places near the ground; distances count from the first.
  // Within `margin_m` of either place the ground need not be known.
  std::optional<GroundEnd> between(const Vec3& from_S_m, const Vec3& to_S_m, double margin_m = 0);

 private:
  GroundSample sample(const Vec3& p_S_m, double step_m);

  const Ground* ground_;
  GroundProbes probes_;
};

}  // namespace lsos
