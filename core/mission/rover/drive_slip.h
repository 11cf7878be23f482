// Slip of a driving rover, without setting off, stopping and turning on the spot: its mean over the
// last second, the greatest such mean, and its distribution over time.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <map>

#include "base/archive.h"
#include "record/rows.h"

namespace lsos {

// Mean over the last second: defined when this exchange and each of the nine before it has a value.
class SecondMean {
 public:
  // NaN: there is no value, and the second begins anew.
  void add(double value);
  // NaN until a whole second is complete.
  double value() const;

  void archive(Archive& a);

 private:
  static constexpr std::size_t exchanges = 10;  // one second

  std::array<double, exchanges> last_{};
  std::uint64_t count_ = 0;  // since the second began
};

// Quantiles of slip over time, from a histogram of the range -1..1.
class SlipHistogram {
 public:
  static constexpr double bins = 1e4;  // per unit of slip

  void add(double slip);
  // The least slip that is not exceeded for `share` (0..1) of the time; the middle of its bin, so
  // at most half a bin off. NaN without any.
  double quantile(double share) const;

  void archive(Archive& a) { LSOS_ARCHIVE(a, exchanges_); }
  bool is_sound() const;

 private:
  std::map<std::int32_t, std::int64_t>
      exchanges_;  // count of exchanges by bin; at most 20 001 bins
};

// Fed once an exchange with the slip of the wheels (mean over those that drive, see VehicleReport)
// and the motion of the rover.
class DriveSlip {
 public:
  struct Motion {
    bool is_commanded = false;   // a drive is commanded: brakes off, no turn on the spot
    double speed_mps = 0;        // speed of the rover along the ground
    double command_mps = 0;      // speed at which its wheels are commanded to roll
    double requested_mps = 0;    // requested speed of the drive
    double cruise_mps = 0;       // cruise speed of the rover's type
    double slip = not_modelled;  // mean over the driven wheels
    double slip_max = not_modelled;
  };
  void add(const Motion& motion);

  // Slip while a drive is commanded and the rover is faster than half the requested speed and than
  // 0.05 m/s or a tenth of its cruise speed, whichever is less. greatest(): the greatest mean over
  // a second, or the 95th percentile when no second was complete. p95(): the 95th percentile over
  // time. NaN without any.
  double greatest() const { return std::isnan(greatest_) ? p95() : greatest_; }
  double p95() const { return histogram_.quantile(0.95); }

  // Mean over the last second, in which the wheels were commanded to roll at half the requested
  // speed or more; defined also for a rover that digs itself in, whose own speed is lost. Else NaN.
  double now() const { return now_.value(); }
  double now_max() const { return now_max_.value(); }  // the same of the wheel that slipped most

  // Time in which the wheels were commanded to roll at half the requested speed or more, s, and the
  // greatest now() in it, whatever the rover's speed.
  double driven_s() const;
  double greatest_rolling() const { return greatest_rolling_; }
  // Mean speed and mean requested speed over that time, m/s. NaN without any.
  double mean_mps() const { return rolling_m_ / driven_s(); }
  double mean_requested_mps() const { return requested_m_ / driven_s(); }

  void archive(Archive& a) {
    LSOS_ARCHIVE(a, driving_, now_, now_max_, histogram_, greatest_, rolling_exchanges_,
                 greatest_rolling_);
    LSOS_ARCHIVE(a, rolling_m_, requested_m_);
  }

 private:
  SecondMean driving_, now_, now_max_;
  SlipHistogram histogram_;
  double greatest_ = not_modelled, greatest_rolling_ = not_modelled;
  std::int64_t rolling_exchanges_ = 0;
  double rolling_m_ = 0, requested_m_ = 0;  // distance in that time, and at the requested speed
};

}  // namespace lsos
