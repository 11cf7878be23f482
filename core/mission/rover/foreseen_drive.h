// A drive under way in an estimate: where the rover is at a time between the marks of what the
// drive is expected to take.
#pragma once

#include <cstddef>

#include "base/sim_time.h"
#include "mission/routes/drive_estimate.h"

namespace lsos {

class ForeseenDrive {
 public:
  // `estimate` has marks. Its times are rounded up to exchanges.
  ForeseenDrive(DriveEstimate estimate, SimTime start);

  // Brings it up to an exchange; times never go back.
  void advance(SimTime now);
  bool has_ended() const { return mark_ + 1 >= times_.size(); }
  SimTime start() const { return times_.front(); }
  // The exchange of the next mark; not after the end.
  SimTime next_mark() const { return times_[mark_ + 1]; }
  // Number of marks behind it.
  std::size_t marks_passed() const { return mark_; }
  // Mean power of the drives up to the next mark, 0 at the end.
  double power_w() const;

  // Where it is now, and what it has driven and used.
  const Vec3& p_S_m() const { return p_S_m_; }
  const Vec2& ahead_S() const { return ahead_S_; }  // unit, of the heading
  double driven_m() const { return now_.driven_m; }
  double energy_j() const { return now_.energy_j; }
  // What of that may be less or more.
  DriveDoubt doubt() const;
  double speed_mps() const;
  double remaining_m() const { return length_m_ - now_.along_m; }
  double share() const { return length_m_ > 0 ? now_.along_m / length_m_ : 1; }
  std::size_t next_point() const;  // of the path
  bool is_backward() const { return is_backward_; }

  const DriveEstimate& estimate() const { return estimate_; }
  // What of its line lies ahead, beginning where it is; and when it ends.
  Path3 line_ahead_S_m() const;
  SimTime end() const { return times_.back(); }

 private:
  void find_place();

  DriveEstimate estimate_;
  std::vector<SimTime> times_;      // of the marks
  std::vector<double> to_point_m_;  // along the line
  double length_m_ = 0;             // of all of it, also beyond a failure
  std::size_t mark_ = 0;            // the last one that is behind
  DriveMark now_;
  Vec3 p_S_m_ = Vec3::Zero();
  Vec2 ahead_S_ = Vec2::Zero();  // zero: it has not moved
  std::size_t point_ = 0;        // of the line, the last one that is behind
  bool is_backward_ = false;
};

}  // namespace lsos
