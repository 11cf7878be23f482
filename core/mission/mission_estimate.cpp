#include "mission/mission_estimate.h"

#include <fmt/format.h>

#include "base/moment_text.h"
#include "mission/estimate/estimate_watch.h"

namespace lsos {

MissionEstimate estimate_mission(Simulation& simulation) {
  MissionEstimate estimate;
  EstimateWatch watch;
  simulation.start();
  watch.look(simulation.fleet(), simulation.now());
  for (long long exchanges = 0; !simulation.is_finished(); ++exchanges) {
    if (exchanges >= exchanges_max) {
      estimate.cut_short =
          fmt::format("too much happens: it ends at {}", moment_text(simulation.now()));
      break;
    }
    simulation.advance();
    watch.look(simulation.fleet(), simulation.now());
  }
  estimate.events = watch.events(simulation.fleet());
  return estimate;
}

}  // namespace lsos
