// Slip of a rover that drives, apart from setting off, stopping and turning on the spot: its mean
// over the last second, the greatest of those, and how it is distributed over time.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <map>

#include "base/archive.h"
#include "record/rows.h"

namespace lsos {

// The mean over the last second, at each exchange at which there is a value and was one at each of
// the nine before.
class SecondMean {
 public:
  // NaN: there is none, and the second begins anew.
  void add(double value);
  // NaN while a whole second is not there.
  double value() const;

  void archive(Archive& a);

 private:
  static constexpr std::size_t exchanges = 10;  // of 0.1 s

  std::array<double, exchanges> last_{};
  std::uint64_t count_ = 0;  // since the second began
};

// Sets a share of the time apart, by a histogram of the slip's range -1..1.
class SlipHistogram {
 public:
  static constexpr double bins = 1e4;  // of a slip of 1

  void add(double slip);
  // The least slip that is not exceeded for `share` (0..1) of the time; the middle of its bin, so
  // at most half a bin off. NaN without any.
  double quantile(double share) const;

  void archive(Archive& a) { a(exchanges_); }

 private:
  std::map<std::int32_t, std::int64_t> exchanges_;  // by bin; 20 001 bins at most
};

// One call an exchange, with the slip of the wheels (mean over those that drive, see VehicleReport)
// and how the rover drives.
class DriveSlip {
 public:
  struct Motion {
    bool is_commanded = false;   // to drive: brakes are off, and it does not turn on the spot
    double speed_mps = 0;        // of the rover along the ground
    double command_mps = 0;      // that its wheels are told to roll at
    double requested_mps = 0;    // of the drive
    double cruise_mps = 0;       // of the rover's type
    double slip = not_modelled;  // of the wheels
    double slip_max = not_modelled;
  };
  void add(const Motion& motion);

  // While a drive is commanded, the rover faster than 0.05 m/s or a tenth of its cruise speed,
  // whichever is less, and than half the requested speed: the greatest mean over a second (of a
  // time that was nowhere so long its 95th percentile), and what 95 % of that time does not exceed.
  // NaN without any.
  double greatest() const { return std::isnan(greatest_) ? p95() : greatest_; }
  double p95() const { return histogram_.quantile(0.95); }

  // Mean over the last second in which the wheels were told to roll at half the requested speed or
  // more; also of a rover that digs itself in, whose own speed is lost. NaN else.
  double now() const { return now_.value(); }
  double now_max() const { return now_max_.value(); }  // of the wheel that slipped most

  // How long a drive was commanded, s, and the greatest now() of it, whatever the rover's speed.
  double driven_s() const;
  double greatest_rolling() const { return greatest_rolling_; }
  // In the mean of that time, m/s: how fast it was, and how fast it was to be. NaN without any.
  double mean_mps() const { return rolling_m_ / driven_s(); }
  double mean_requested_mps() const { return requested_m_ / driven_s(); }

  void archive(Archive& a) {
    a(driving_)(now_)(now_max_)(histogram_)(greatest_)(rolling_exchanges_)(greatest_rolling_);
    a(rolling_m_)(requested_m_);
  }

 private:
  SecondMean driving_, now_, now_max_;
  SlipHistogram histogram_;
  double greatest_ = not_modelled, greatest_rolling_ = not_modelled;
  std::int64_t rolling_exchanges_ = 0;
  double rolling_m_ = 0, requested_m_ = 0;  // driven in that time, and at the requested speed
};

}  // namespace lsos
