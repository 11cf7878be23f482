// The estimate of a mission: what is expected of each event without simulating its dynamics.
#pragma once

#include <string>
#include <vector>

#include "mission/estimate/event_estimate.h"
#include "mission/estimate/lack.h"
#include "mission/simulation.h"

namespace lsos {

struct MissionEstimate {
  std::vector<EventEstimate> events;  // enabled ones, by rover and sequence
  std::vector<DayEstimate> days;      // by rover
  std::vector<RoverShade> shades;     // by rover
  std::vector<Lack> lacks;            // by rover
  double end_s = 0;                   // of the mission, since its start
  // Why it ends before the mission does; "" when it does not. What had not ended is not known.
  std::string cut_short;
};

// `simulation`: SimulationSetup::is_estimate, not started. It is at its end afterwards. An estimate
// of more than `exchanges_max` exchanges is cut short.
inline constexpr long long exchanges_max = 2'000'000;
MissionEstimate estimate_mission(Simulation& simulation);

}  // namespace lsos
