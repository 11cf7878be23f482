// How far what a drive takes may be from what is expected, and why.
#pragma once

#include "base/vector.h"
#include "route/cost/drive_cost.h"

namespace lsos {

// Shares that the drive cost model may be off by on natural ground, whatever the slip: measured on
// the shipped plans, of whose drives 95 % use 2 % less to 15 % more energy than expected, loads
// apart, and take 2 % less to 5 % more time.
inline constexpr double drive_energy_error = 0.15, drive_time_error = 0.03;
// Share by which the slip of wheels is not known: how soil is packed varies by about as much. Where
// slip is small that is nothing; on slopes on which it grows quickly it is most of the error.
inline constexpr double slip_error = 1.0 / 3;

// The least and the most that a drive may take, as shares of what is expected.
struct DriveSlack {
  double time_low = 1, time_high = 1, energy_low = 1, energy_high = 1;
};

// What a drive may take less or more than expected, from its beginning to somewhere.
struct DriveDoubt {
  double early_s = 0, late_s = 0;  // both positive
  double less_j = 0, more_j = 0;
  double driven_j = 0;  // the energy expected

  DriveDoubt& operator+=(const DriveDoubt& other);
  DriveDoubt operator-(const DriveDoubt& other) const;
};

// Sums up stretches of a drive.
class DriveSlackSum {
 public:
  // `slip`: of steady driving there, 0..1.
  void add(double time_s, double energy_j, double slip);
  DriveSlack slack() const;

 private:
  double time_s_ = 0, low_s_ = 0, high_s_ = 0;
  double energy_j_ = 0, low_j_ = 0, high_j_ = 0;
};

// The slack of a drive on a line on the ground, by its slopes, on the first of the soils.
DriveSlack line_slack(const DriveCost& cost, const Path3& line_S_m);

}  // namespace lsos
