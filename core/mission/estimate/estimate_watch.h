// Watches a simulation that is an estimate, and sums up what becomes of each event.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mission/estimate/day_sums.h"
#include "mission/estimate/event_estimate.h"
#include "mission/estimate/held_share.h"
#include "mission/estimate/lack_watch.h"
#include "mission/fleet/fleet.h"

namespace lsos {

class EstimateWatch {
 public:
  // After each exchange, the one at the start too.
  void look(const Fleet& fleet, SimTime now);
  // Since when no event has been under way; absent: one is.
  std::optional<SimTime> idle_since() const { return idle_since_; }
  // Shades of all rovers, up to the last exchange.
  std::vector<RoverShade> shades(const Fleet& fleet) const;
  // Days of all rovers up to the last exchange, by rover; a day that has not begun is none.
  std::vector<DayEstimate> days(const Fleet& fleet) const;
  // Stretches in which rovers lack what they need, by rover.
  std::vector<Lack> lacks() const;
  // Estimates of all enabled events, by rover and sequence.
  std::vector<EventEstimate> events(const Fleet& fleet, Instant mission_start) const;

 private:
  // Sums over the time of an event.
  struct Sums {
    double all_s = 0, charge_min = not_modelled;
    HeldSums lit, seen;  // the Sun reaches a panel: much of its light, any; Earth is in view
    double sight_s = 0;  // it is known whether it is
    DriveDoubt drives;
    // The wait for it counts, too; since the battery was full.
    double sun_less_j = 0, sun_more_j = 0;
    double loads_less_j = 0, loads_more_j = 0;  // of the event alone
    bool was_full = false;
    double charging_w = 0;  // see DoubtedEvent
    std::string meets;      // the rover that stands where its drive has ended
  };
  struct Watched {
    std::size_t first = 0;  // events before it have ended
    std::optional<std::size_t> running;
    std::vector<Sums> sums;
    RoverShade shade;
    DaySums days;
    LackWatch lacks;
    DriveDoubt drives;                            // of all drives up to the last exchange
    bool is_stowed = false;                       // it has panels, and none is up
    bool is_driving = false, is_turning = false;  // it is carried along a line; a panel turns
    double lit = not_modelled, seen = not_modelled;
    HeldShare held_lit, held_seen;
    std::optional<SimTime> sun_time;  // when sunlight was evaluated
    double sun_less_w = 0, sun_more_w = 0;
    LoadDoubt loads_less, loads_more;  // by what the Sun switches
    // What the event under way waits for, and power into the battery.
    std::optional<double> awaited_charge;
    double energy_rate_w = 0;
  };

  // Adds the time that has passed to the sums of the event that was under way.
  static void pass(Watched& rover, const RoverAgent& agent, double passed_s);
  // What holds from now on; `sums`: of the event that was under way.
  static void find_sun(Watched& rover, const RoverAgent& agent, Sums& sums);
  static void find_earth(Watched& rover, const RoverAgent& agent, SimTime now, Sums& sums);

  std::vector<Watched> rovers_;
  SimTime last_{};
  std::optional<SimTime> idle_since_;
};

}  // namespace lsos
