// What moves and what stands near a place: it decides when light and sight are evaluated again, and
// may hide the Sun or another antenna.
#pragma once

#include "mission/fleet/fleet.h"
#include "mission/light/sight_watch.h"
#include "planet/sunlight.h"

namespace lsos {

// Radius about the reference point that, with beyond_reach_m, holds a rover's body at rest and its
// masts, stowed and up.
double reach_m(const RoverAgent& rover);
// Motion of a rover or its panels at this exchange.
Motion motion_of(const FleetRover& rover, SimTime now);
// Motion of rovers that may shade a place; `except` does not count, nullptr: all do.
Motion motion_near(const Fleet& fleet, const Vec3& p_S_m, const RoverAgent* except);

// All solids that may shade a place in sunlight, but those of one rover or asset. The mesh is
// relative to `eye_S_m`, in site axes.
Mesh solids_near(const Fleet& fleet, const SiteFrame& site, const Vec3& eye_S_m,
                 const std::string& except_id, const Sunlight& sun, SimTime now);
// Bodies that may stand between two places; when the two are equal, all bodies near them. Their
// meshes are relative to `from_S_m`, in site axes.
std::vector<NamedMesh> solids_between(const Fleet& fleet, const SiteFrame& site,
                                      const Vec3& from_S_m, const Vec3& to_S_m,
                                      const Moment& moment);

}  // namespace lsos
