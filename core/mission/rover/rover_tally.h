// Extremes and sums of a rover's driving over the whole mission.
#pragma once

#include "base/archive.h"
#include "vehicle/vehicle.h"

namespace lsos {

class RoverTally {
 public:
  // Counts the exchange period that ends in this state.
  void add(const VehicleReport& report);
  // The rover was put elsewhere: the difference in height is no rise that it drove.
  void go_on_from(const VehicleReport& report);
  // At the end of an event: driving counts up to here. A rover that sways later does not drive.
  void end_event() { drive_time_in_events_ = drive_time_; }

  double slope_max_rad() const { return slope_max_rad_; }
  double elevation_gain_m() const;
  // Time at more than 1 mm/s, up to the end of the last event.
  double drive_s() const { return seconds(drive_time_in_events_); }

  void archive(Archive& a);

 private:
  double slope_max_rad_ = not_modelled;
  double elevation_gain_m_ = 0;
  double elevation_low_m_ = not_modelled, elevation_high_m_ = not_modelled;
  bool is_rising_ = false;
  SimTime drive_time_{}, drive_time_in_events_{};
};

}  // namespace lsos
