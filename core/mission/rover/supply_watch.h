// Watches a rover's energy over the exchanges, and reports what a planner must know: a low charge,
// an empty battery, loads that are shed, less power from outside than an event requested.
#pragma once

#include <string>

#include "mission/rover/rover_journal.h"
#include "mission/rover/rover_power.h"

namespace lsos {

// Why a rover does not drive that keeps its reserve.
std::string reserve_text(const RoverPower& power);

class SupplyWatch {
 public:
  // After the energy was brought up to `now`. Returns whether the battery has become empty.
  bool observe(const RoverPower& power, SimTime now, RoverJournal& journal);
  // After it was fixed what flows from `now` on.
  void settle(RoverPower& power, SimTime now, RoverJournal& journal);

  void archive(Archive& a);

 private:
  void warn_of_low_charge(const RoverPower& power, SimTime now, RoverJournal& journal);
  void warn_of_shed_loads(const RoverPower& power, SimTime now, RoverJournal& journal);

  bool is_shedding_ = false;
  bool has_warned_of_empty_ = false;  // warned that the battery is empty
  bool has_warned_of_low_ = false;    // warned that the charge is below the reserve
  bool has_warned_of_shed_ = false;   // warned that the battery, not empty, gives too little
};

}  // namespace lsos
