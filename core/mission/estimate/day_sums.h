// Sums of a rover over the days of a mission.
#pragma once

#include <vector>

#include "mission/estimate/event_estimate.h"

namespace lsos {

// What a rover has come to at a time since the mission's start. NaN: not modelled.
struct RoverSums {
  double time_s = 0;
  double distance_m = 0, energy_used_j = not_modelled, solar_j = not_modelled;
  double charge = not_modelled;  // 0..1
};

class DaySums {
 public:
  // In the order of time, the first at 0. Between two all is taken to change evenly, so that a day
  // may end between them.
  void add(const RoverSums& sums);
  // Without a rover's id. A day that has not begun is none.
  std::vector<DayEstimate> days() const;

 private:
  struct Day {
    RoverSums begin, end;
    double charge_min = not_modelled;
  };
  std::vector<Day> days_;
};

}  // namespace lsos
