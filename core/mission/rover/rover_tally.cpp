#include "mission/rover/rover_tally.h"

#include <algorithm>
#include <cmath>

namespace lsos {

namespace {

constexpr double driving_mps = 1e-3;       // faster than this counts as driving
constexpr double gain_hysteresis_m = 0.5;  // smaller rises are noise

}  // namespace

void RoverTally::add(const VehicleReport& report) {
  const double slope_rad = report.slope_rad;
  if (!(slope_max_rad_ >= slope_rad) && !std::isnan(slope_rad)) slope_max_rad_ = slope_rad;
  if (report.speed_mps > driving_mps) drive_time_ += exchange_period;
  // Rises are summed from a low to the next high; a reversal smaller than the hysteresis is
  // ignored.
  const double elevation_m = report.elevation_m;
  if (std::isnan(elevation_low_m_)) elevation_low_m_ = elevation_high_m_ = elevation_m;
  if (is_rising_) {
    elevation_high_m_ = std::max(elevation_high_m_, elevation_m);
    if (elevation_m < elevation_high_m_ - gain_hysteresis_m) {
      elevation_gain_m_ += elevation_high_m_ - elevation_low_m_;
      elevation_low_m_ = elevation_m;
      is_rising_ = false;
    }
  } else {
    elevation_low_m_ = std::min(elevation_low_m_, elevation_m);
    if (elevation_m > elevation_low_m_ + gain_hysteresis_m) {
      elevation_high_m_ = elevation_m;
      is_rising_ = true;
    }
  }
}

void RoverTally::go_on_from(const VehicleReport& report) {
  elevation_gain_m_ = elevation_gain_m();
  elevation_low_m_ = elevation_high_m_ = report.elevation_m;
  is_rising_ = false;
}

double RoverTally::elevation_gain_m() const {
  return elevation_gain_m_ + (is_rising_ ? elevation_high_m_ - elevation_low_m_ : 0);
}

void RoverTally::archive(Archive& a) {
  LSOS_ARCHIVE(a, slope_max_rad_, elevation_gain_m_, elevation_low_m_, elevation_high_m_,
               is_rising_, drive_time_, drive_time_in_events_);
}

}  // namespace lsos
