#include "mission/fleet/avoidance.h"

#include <fmt/format.h>

#include <algorithm>

namespace lsos {

namespace {

// Bound on how far the centre of a rover moves before it rests; from 5 m/s that is some 60 m.
// Smaller: fast rovers are stopped too late, larger: more pairs are checked.
constexpr double stopping_reach_m = 100;
// A rover whose own motion widens the gap by this in an exchange period leaves the other.
constexpr double leaving_m = 1e-3;

}  // namespace

std::vector<Fault> overlapping_rovers(const Fleet& fleet, const MissionMachine& machine) {
  Faults faults;
  for (std::size_t i = 0; i < fleet.rovers.size(); ++i) {
    const RoverAgent& rover = *fleet.rovers[i].agent;
    for (const StandingAsset& asset : fleet.assets) {
      if (gap_m(asset, rover.motion().footprint()) > 0) continue;
      faults.error(
          machine.rovers[i].rover.place,
          fmt::format("Rover '{}': is placed where '{}' stands, {:.1f} m from its centre",
                      rover.id(), asset.plan.id, (rover.view().p_S_m - asset.pose.p_S_m).norm()));
    }
    for (std::size_t k = i + 1; k < fleet.rovers.size(); ++k) {
      const RoverAgent &a = *fleet.rovers[i].agent, &b = *fleet.rovers[k].agent;
      if (!overlap(a.motion().footprint(), b.motion().footprint())) continue;
      faults.error(machine.rovers[k].rover.place,
                   fmt::format("Rover '{}': is placed where '{}' stands, {:.1f} m from its centre",
                               b.id(), a.id(), (b.view().p_S_m - a.view().p_S_m).norm()));
    }
  }
  return faults.sorted();
}

void avoid_rovers(Fleet& fleet) {
  for (std::size_t i = 0; i < fleet.rovers.size(); ++i) {
    for (std::size_t k = i + 1; k < fleet.rovers.size(); ++k) {
      RoverAgent &a = *fleet.rovers[i].agent, &b = *fleet.rovers[k].agent;
      if (a.is_parked() && b.is_parked()) continue;
      const Footprint of_a = a.motion().footprint(), of_b = b.motion().footprint();
      const double now_m = gap_m(of_a, of_b), apart_m = (of_b.center_S_m - of_a.center_S_m).norm();
      if (now_m > 2 * stopping_reach_m) continue;
      // What stands is gone round, so that there the drive ends with room to turn.
      const auto ahead = [](const RoverAgent& rover, const RoverAgent& other) {
        return rover.drive().footprints_ahead(other.is_parked() ? rover.drive().room_to_turn_m()
                                                                : 0);
      };
      const std::vector<Footprint> a_ahead = ahead(a, b), b_ahead = ahead(b, a);
      const bool would_touch =
          std::ranges::any_of(a_ahead,
                              [&](const Footprint& a_then) { return overlap(a_then, of_b); }) ||
          std::ranges::any_of(b_ahead, [&](const Footprint& b_then) {
            return overlap(of_a, b_then) ||
                   std::ranges::any_of(
                       a_ahead, [&](const Footprint& a_then) { return overlap(a_then, b_then); });
          });
      if (!would_touch) continue;
      const double period_s = seconds(exchange_period);
      const double after_a_m = gap_m(a.motion().footprint(period_s), of_b) - now_m;
      const double after_b_m = gap_m(of_a, b.motion().footprint(period_s)) - now_m;
      if (after_a_m >= 0 && after_b_m >= 0) continue;
      // One that neither nears the other nor leaves it crosses its way.
      const bool ends_a = a.drive().is_under_way() && after_a_m < leaving_m;
      const bool ends_b = b.drive().is_under_way() && after_b_m < leaving_m;
      if (ends_a) a.drive().end_before(b.id(), apart_m, ends_b);
      if (ends_b) b.drive().end_before(a.id(), apart_m, ends_a);
    }
  }
}

void avoid_assets(Fleet& fleet) {
  for (const FleetRover& rover : fleet.rovers) {
    RoverAgent& agent = *rover.agent;
    if (agent.is_parked()) continue;
    for (const StandingAsset& asset : fleet.assets) {
      const double apart_m = (agent.view().p_S_m - asset.pose.p_S_m).norm();
      if (apart_m > asset.shape.reach_m() + stopping_reach_m) continue;
      const auto touches = [&](const Footprint& then) { return gap_m(asset, then) <= 0; };
      if (std::ranges::none_of(agent.drive().footprints_ahead(), touches)) continue;
      const double now_m = gap_m(asset, agent.motion().footprint());
      if (gap_m(asset, agent.motion().footprint(seconds(exchange_period))) < now_m) {
        agent.drive().end_before(asset.plan.id, apart_m, false);
      }
    }
  }
}

}  // namespace lsos
