#include "mission/fleet/solids.h"

#include <algorithm>

#include "base/segment.h"
#include "mission/light/sight_watch.h"
#include "mission/light/sun_watch.h"

namespace lsos {

double reach_m(const RoverAgent& rover) {
  return std::max(rover.shape().reach_m(), rover.antennas().mast_reach_m() - beyond_reach_m);
}

Motion motion_of(const FleetRover& rover, SimTime now) {
  const RoverPower& power = rover.agent->power();
  if (!rover.agent->is_parked() || power.is_panel_turning()) return Motion::goes_on;
  const bool has_panel_moved =
      power.has_panel_command() || power.panels().last_end(now) == std::optional(now);
  const bool has_mast_moved = rover.agent->antennas().has_changed(now);
  const bool has_moved = !rover.was_parked || rover.agent->drive().has_passed_mark();
  return has_moved || has_panel_moved || has_mast_moved ? Motion::has_ended : Motion::none;
}

Motion motion_near(const Fleet& fleet, const Vec3& p_S_m, const RoverAgent* except) {
  Motion motion = Motion::none;
  for (const FleetRover& rover : fleet.rovers) {
    if (rover.agent.get() == except) continue;
    if ((rover.agent->view().p_S_m - p_S_m).norm() > shading_reach_m) continue;
    motion = std::max(motion, rover.motion);
  }
  return motion;
}

Mesh solids_near(const Fleet& fleet, const SiteFrame& site, const Vec3& eye_S_m,
                 const std::string& except_id, const Sunlight& sun, SimTime now) {
  const Vec3 sun_S = direction_S(site, eye_S_m, sun.seen);
  Mesh mesh;
  const auto is_near = [&](const Vec3& p_S_m) {
    return (p_S_m - eye_S_m).norm() < shading_reach_m;
  };
  for (const FleetRover& rover : fleet.rovers) {
    if (rover.agent->id() == except_id || !is_near(rover.agent->view().p_S_m)) continue;
    append_solids(mesh, *rover.agent, eye_S_m, now);
  }
  for (const StandingAsset& asset : fleet.assets) {
    if (asset.plan.id == except_id || !is_near(asset.pose.p_S_m)) continue;
    append_solids(mesh, asset, eye_S_m, sun_S);
  }
  return mesh;
}

std::vector<NamedMesh> solids_between(const Fleet& fleet, const SiteFrame& site,
                                      const Vec3& from_S_m, const Vec3& to_S_m,
                                      const Moment& moment) {
  const double aside_m = from_S_m == to_S_m ? shading_reach_m : beyond_reach_m;
  const auto is_near = [&](const Vec3& p_S_m, double body_m) {
    return point_distance_m(from_S_m, to_S_m, p_S_m) < body_m + aside_m;
  };
  std::vector<NamedMesh> solids;
  for (const FleetRover& rover : fleet.rovers) {
    if (!is_near(rover.agent->view().p_S_m, reach_m(*rover.agent))) continue;
    NamedMesh& solid = solids.emplace_back(NamedMesh{rover.agent->id(), {}});
    append_solids(solid.mesh, *rover.agent, from_S_m, moment.now);
  }
  for (const StandingAsset& asset : fleet.assets) {
    if (!is_near(asset.pose.p_S_m, asset.shape.reach_m())) continue;
    const Sunlight sun = sunlight(site.body(), site.geodetic(asset.pose.p_S_m), moment.utc, 0);
    NamedMesh& solid = solids.emplace_back(NamedMesh{asset.plan.id, {}});
    append_solids(solid.mesh, asset, from_S_m, direction_S(site, asset.pose.p_S_m, sun.seen));
  }
  return solids;
}

}  // namespace lsos
