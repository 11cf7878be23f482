// Ends drives of rovers that would touch each other or an asset.
#include <fmt/format.h>

#include <algorithm>

#include "mission/simulation.h"

namespace lsos {

void Simulation::check_starts_overlap(Faults& faults) const {
  for (std::size_t i = 0; i < rovers_.size(); ++i) {
    const RoverAgent& rover = *rovers_[i].agent;
    for (const StandingAsset& asset : assets_) {
      if (gap_m(asset, rover.footprint()) > 0) continue;
      faults.error(
          machine_.rovers[i].rover.place,
          fmt::format("Rover '{}': starts where '{}' stands, {:.1f} m from its centre", rover.id(),
                      asset.plan.id, (rover.view().p_S_m - asset.pose.p_S_m).norm()));
    }
    for (std::size_t k = i + 1; k < rovers_.size(); ++k) {
      const RoverAgent &a = *rovers_[i].agent, &b = *rovers_[k].agent;
      if (!overlap(a.footprint(), b.footprint())) continue;
      faults.error(machine_.rovers[k].rover.place,
                   fmt::format("Rover '{}': starts where '{}' stands, {:.1f} m from its centre",
                               b.id(), a.id(), (b.view().p_S_m - a.view().p_S_m).norm()));
    }
  }
}

namespace {

template <class Touches>
bool any_of(const RoverAgent& rover, const Touches& touches) {
  return std::ranges::any_of(rover.footprints_ahead(), touches);
}

// Bound on how far the centre of a rover moves before it rests; from 5 m/s that is some 60 m.
// Smaller: fast rovers are stopped too late, larger: more pairs are checked.
constexpr double stopping_reach_m = 100;

}  // namespace

// Ends the drive of each rover that could not stop before another, or would turn into it, if its
// own motion brings it nearer. Rovers that move apart drive on.
void Simulation::avoid_rovers() {
  for (std::size_t i = 0; i < rovers_.size(); ++i) {
    for (std::size_t k = i + 1; k < rovers_.size(); ++k) {
      RoverAgent &a = *rovers_[i].agent, &b = *rovers_[k].agent;
      if (a.is_parked() && b.is_parked()) continue;
      const Footprint of_a = a.footprint(), of_b = b.footprint();
      const double now_m = gap_m(of_a, of_b), apart_m = (of_b.center_S_m - of_a.center_S_m).norm();
      if (now_m > 2 * stopping_reach_m) continue;
      const bool would_touch =
          any_of(a, [&](const Footprint& a_then) { return overlap(a_then, of_b); }) ||
          any_of(b, [&](const Footprint& b_then) {
            return overlap(of_a, b_then) ||
                   any_of(a, [&](const Footprint& a_then) { return overlap(a_then, b_then); });
          });
      if (!would_touch) continue;
      const double period_s = seconds(exchange_period);
      if (gap_m(a.footprint(period_s), of_b) < now_m) a.end_drive_before(b.id(), apart_m);
      if (gap_m(of_a, b.footprint(period_s)) < now_m) b.end_drive_before(a.id(), apart_m);
    }
  }
}

// The same for assets, which do not move.
void Simulation::avoid_assets() {
  for (const Rover& rover : rovers_) {
    RoverAgent& agent = *rover.agent;
    if (agent.is_parked()) continue;
    for (const StandingAsset& asset : assets_) {
      const double apart_m = (agent.view().p_S_m - asset.pose.p_S_m).norm();
      if (apart_m > asset.shape.reach_m() + stopping_reach_m) continue;
      if (!any_of(agent, [&](const Footprint& then) { return gap_m(asset, then) <= 0; })) continue;
      const double now_m = gap_m(asset, agent.footprint());
      if (gap_m(asset, agent.footprint(seconds(exchange_period))) < now_m) {
        agent.end_drive_before(asset.plan.id, apart_m);
      }
    }
  }
}

}  // namespace lsos
