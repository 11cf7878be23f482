// What is expected of an event of a plan, and of a day: plain values.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/sim_time.h"
#include "mission/events/event_record.h"

namespace lsos {

// A quantity that is expected to lie between two values, which are equal where it is sure.
struct Expected {
  double low = 0, high = 0;

  static Expected exactly(double value) { return {value, value}; }
  bool is_sure() const { return low == high; }
  double middle() const { return (low + high) / 2; }
};

// Since the mission's start.
struct ShadeSpan {
  double begin_s = 0, end_s = 0;
};

// When a rover is in the dark, and when it does not see Earth.
struct RoverShade {
  std::string rover_id;
  std::vector<ShadeSpan> dark;    // panels are up, and no Sun reaches one
  std::vector<ShadeSpan> stowed;  // it has panels, and none is up
  std::vector<ShadeSpan> unseen;  // Earth is not in view of the antenna in use
};

// Absent: it cannot be known. `status` and `reason` are those of a run; `running` is `incomplete`.
struct EventEstimate {
  std::string rover_id;
  std::int64_t sequence = 0;
  std::string type, label;
  EventStatus status = EventStatus::not_started;
  std::string reason;                    // why it does not take place as drawn, else ""
  bool waits_in_vain = false;            // its turn comes, and it never starts
  std::string meets;                     // the rover that stands where its drive ends, else ""
  std::optional<double> start_s, end_s;  // since the mission's start
  std::optional<double> ready_s;         // when its turn comes
  std::optional<double> over_s;          // when it is over, also where it never begins
  std::optional<double> distance_m, energy_used_j, solar_j;
  std::optional<double> charge_end, charge_min;  // 0..1
  // Ranges in which quantities that are not sure are expected to lie.
  std::optional<Expected> start_range_s, end_range_s, energy_range_j;
  std::optional<Expected> charge_end_range, charge_min_range;
  // Shares of its time in which the Sun reaches a panel that is up, and in which Earth is in view
  // of the antenna in use.
  std::optional<Expected> sunlit_share, earth_visible_share;
};

// What is expected of a rover on a day of the mission, each 24 hours since its start. The last may
// be shorter. Absent: the rover has no battery.
struct DayEstimate {
  std::string rover_id;
  int day = 1;
  double distance_m = 0;
  std::optional<double> energy_used_j, solar_j;
  std::optional<double> charge_min, charge_end;  // 0..1
  // Ranges in which quantities that are not sure are expected to lie.
  std::optional<Expected> energy_range_j, charge_min_range, charge_end_range;
};

}  // namespace lsos
