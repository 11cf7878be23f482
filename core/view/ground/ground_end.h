// Where the ground that is known ends before the horizon that counts: beyond it nothing hides the
// Sun, Earth or another rover, whatever may stand there. Where a way leaves the reach of the site,
// the ground does not end.
#pragma once

#include <map>
#include <optional>

#include "terrain/ground.h"

namespace lsos {

struct GroundEnd {
  double reaches_m = 0;  // to where the ground ends, or a hole of it begins
  double matters_m = 0;  // ground up to there may hide what is seen
};

// Follows samples of the ground along a way, from near to far.
class GroundEndTracker {
 public:
  void add(double distance_m, bool is_ground) {
    if (is_ground) {
      last_ground_m_ = distance_m;
    } else if (!end_m_ && distance_m - last_ground_m_ > hole_share * distance_m) {
      end_m_ = last_ground_m_;
    }
  }
  // The last ground before its end, or before the first hole longer than a tenth of its distance.
  std::optional<double> end_m() const { return end_m_; }

 private:
  static constexpr double hole_share = 0.1;
  double last_ground_m_ = 0;
  std::optional<double> end_m_;
};

// One a thread; results never depend on what was asked before.
class GroundEndProbe {
 public:
  // `ground` must outlive it.
  explicit GroundEndProbe(const Ground& ground) : ground_(&ground) {}

  const SiteFrame& site() const { return ground_->site(); }

  // Towards a disc of that angular radius, infinitely far away, about a direction (unit, site
  // axes). Absent where the ground reaches as far as counts, and where it hides all of the disc.
  std::optional<GroundEnd> towards(const Vec3& eye_S_m, const Vec3& direction_S, double disc_rad);
  // Along the straight line between two places near the ground, counted from the first. Within
  // `margin_m` of either the ground need not be known.
  std::optional<GroundEnd> between(const Vec3& from_S_m, const Vec3& to_S_m, double margin_m = 0);

 private:
  // For a step of that length.
  Ground::Probe& probe(double step_m);
  GroundSample sample(const Vec3& p_S_m, double step_m) { return probe(step_m).sample(p_S_m); }

  const Ground* ground_;
  std::map<int, Ground::Probe> probes_;  // by octave
};

}  // namespace lsos
