#include "mission/fleet/fleet_sight.h"

#include <algorithm>

#include "mission/fleet/solids.h"

namespace lsos {

namespace {

// The ends are the rovers, then the assets.
std::vector<SightEnd> ends_of(const Fleet& fleet, SimTime now, bool is_estimate = false) {
  std::vector<SightEnd> ends;
  for (const FleetRover& rover : fleet.rovers) {
    const AntennaArray& antennas = rover.agent->antennas();
    const std::size_t in_use = antennas.in_use(now);
    const AntennaSpec& antenna = antennas.specs()[in_use];
    const bool is_carried = is_estimate && rover.agent->drive().has_passed_mark();
    const Motion motion = is_carried ? Motion::has_ended : rover.motion;
    ends.push_back({rover.agent->id(), rover.agent->view().p_S_m, rover.agent->antenna_S_m(),
                    antennas.has_link(in_use, now), antenna.range_max_m, antenna.reaches_earth,
                    antennas.has_changed(now) ? Motion::has_ended : motion, reach_m(*rover.agent),
                    false});
  }
  for (const StandingAsset& asset : fleet.assets) {
    const double height_m = asset.plan.antenna_height_m.value_or(asset.model.antenna_height_m);
    ends.push_back({asset.plan.id, asset.pose.p_S_m, asset.pose.point_S_m({0, 0, height_m}), true,
                    asset.model.antenna_range_max_m, asset.model.reaches_earth, Motion::none,
                    asset.shape.reach_m(), !asset.model.panels.empty()});
  }
  return ends;
}

}  // namespace

FleetSight::FleetSight(const Ground& ground, Renderer& renderer, const Fleet& fleet,
                       bool is_estimate)
    : ground_(&ground),
      watch_(ground, renderer, fleet.rovers.size() + fleet.assets.size(), is_estimate),
      is_estimate_(is_estimate) {}

std::vector<SightIntervalRow> FleetSight::update(const Fleet& fleet, const Moment& moment) {
  return watch_.look(moment.now, moment.utc, ends_of(fleet, moment.now, is_estimate_),
                     [&](const Vec3& from_S_m, const Vec3& to_S_m) {
                       return solids_between(fleet, ground_->site(), from_S_m, to_S_m, moment);
                     });
}

std::vector<PairRow> FleetSight::rows(const Fleet& fleet, const Moment& moment,
                                      std::size_t from) const {
  return watch_.rows(moment.now, moment.utc, ends_of(fleet, moment.now), from);
}

std::vector<SightIntervalRow> FleetSight::finish(const Fleet& fleet, SimTime now) {
  return watch_.finish(now, ends_of(fleet, now));
}

std::vector<std::string> FleetSight::warnings_of_own_way(const Fleet& fleet, SimTime now) const {
  return watch_.warnings_of_own_way(ends_of(fleet, now));
}

std::optional<PairSight> FleetSight::between(const Fleet& fleet, const Moment& moment,
                                             const std::string& one, const std::string& other) {
  // The order is that of ends_of(), then Earth.
  std::vector<std::string> ids = fleet.rover_ids();
  for (const StandingAsset& asset : fleet.assets) ids.push_back(asset.plan.id);
  ids.emplace_back(earth_id);
  const auto number = [&](const std::string& id) {
    return static_cast<std::size_t>(std::ranges::find(ids, id) - ids.begin());
  };
  if (is_estimate_ && std::max(number(one), number(other)) < ids.size()) {
    watch_.ask(number(one), number(other), moment.now, moment.utc, ends_of(fleet, moment.now),
               [&](const Vec3& from_S_m, const Vec3& to_S_m) {
                 return solids_between(fleet, ground_->site(), from_S_m, to_S_m, moment);
               });
  }
  return watch_.last(number(one), number(other));
}

}  // namespace lsos
