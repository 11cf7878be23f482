#include "mission/mission_estimate.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "base/moment_text.h"
#include "mission/estimate/day_ranges.h"
#include "mission/estimate/estimate_watch.h"

namespace lsos {

namespace {

// What events have been waited for for so long is not expected to come.
constexpr SimTime idle_max = std::chrono::hours(100 * 24);

// Says of events that are not over what they wait for or do, where the estimate ends before them.
void tell_what_is_awaited(Simulation& simulation, std::vector<EventEstimate>& events) {
  simulation.stop("the estimate is cut short");
  for (const FleetRover& rover : simulation.fleet().rovers) {
    for (std::size_t i = 0; i < rover.sequence.records().size(); ++i) {
      const EventRow row = rover.sequence.row(i);
      const auto event = std::ranges::find_if(events, [&](const EventEstimate& each) {
        return each.rover_id == row.rover_id && each.sequence == row.sequence;
      });
      if (event == events.end() || event->over_s) continue;
      event->status = row.status;
      event->reason = row.reason;
      event->waits_in_vain = rover.sequence.records()[i].has_waited_in_vain();
    }
  }
}

// A charge that runs low may be why a rover waits in vain.
bool may_keep_waiting(const Lack& lack) {
  return lack.kind == LackKind::energy || (lack.kind == LackKind::sunlight && lack.below_s);
}

// Where nothing takes place any more, as rovers wait for what never comes, that is told, and once
// each that a rover's charge runs low; so it is of one rover that waits while others go on.
void leave_out_vain_waits(MissionEstimate& estimate, std::optional<SimTime> idle_since) {
  std::map<std::string, double> waits_since_s;
  for (const EventEstimate& event : estimate.events) {
    if (event.waits_in_vain) waits_since_s.emplace(event.rover_id, *event.ready_s);
  }
  std::set<std::pair<std::string, LackKind>> kept;
  std::vector<Lack> lacks;
  for (Lack& lack : estimate.lacks) {
    const double since_s = lack.below_s.value_or(lack.begin_s);
    const auto waits = waits_since_s.find(lack.rover_id);
    const bool is_in_vain = (idle_since && since_s >= seconds(*idle_since)) ||
                            (waits != waits_since_s.end() && since_s >= waits->second);
    const std::pair<std::string, LackKind> key(lack.rover_id, lack.kind);
    if (is_in_vain && (kept.contains(key) || !may_keep_waiting(lack))) continue;
    if (may_keep_waiting(lack)) kept.insert(key);
    lacks.push_back(std::move(lack));
  }
  estimate.lacks = std::move(lacks);
}

}  // namespace

MissionEstimate estimate_mission(Simulation& simulation) {
  MissionEstimate estimate;
  EstimateWatch watch;
  simulation.start();
  watch.look(simulation.fleet(), simulation.now());
  for (long long exchanges = 0; !simulation.is_finished(); ++exchanges) {
    const std::optional<SimTime> idle_since = watch.idle_since();
    if (idle_since && simulation.now() - *idle_since > idle_max) {
      estimate.cut_short =
          fmt::format("from {} on no event is under way", moment_text(*idle_since));
    }
    if (exchanges >= exchanges_max) {
      estimate.cut_short =
          fmt::format("at {} it has taken too many steps", moment_text(simulation.now()));
    }
    if (!estimate.cut_short.empty()) break;
    simulation.advance();
    watch.look(simulation.fleet(), simulation.now());
  }
  estimate.events = watch.events(simulation.fleet(), simulation.plan().mission.start_time);
  estimate.days = watch.days(simulation.fleet());
  add_day_ranges(estimate.days, estimate.events);
  estimate.lacks = watch.lacks();
  estimate.shades = watch.shades(simulation.fleet());
  estimate.end_s = seconds(simulation.now());
  if (estimate.cut_short.empty()) {
    leave_out_vain_waits(estimate, watch.idle_since());
  } else {
    // What is waited for may well come after the estimate has ended.
    tell_what_is_awaited(simulation, estimate.events);
  }
  return estimate;
}

}  // namespace lsos
