// The ground and site frame of a plan, default headings, and checks for places without terrain.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "mission/model/machine.h"
#include "terrain/ground.h"

namespace lsos {

// The ground in the east-north-up frame on its surface at `site`. Throws InputError, also when
// the terrain lies on another body or has no ground at `site`.
std::unique_ptr<Ground> ground_at(const TerrainSpec& terrain, const Body& body,
                                  const Geodetic& site, std::uint64_t seed);

// The same; also throws InputError when the cells of the raster at `site` are slivers that no rover
// drives on.
std::unique_ptr<Ground> drivable_ground_at(const TerrainSpec& terrain, const Body& body,
                                           const Geodetic& site, std::uint64_t seed);

// The ground about the plan's site, drivable there unless the plan says its SiteOrigin. The plan
// must have a planet and a rover.
std::unique_ptr<Ground> mission_ground(const TerrainSpec& terrain, const Plan& plan);

// Waypoints on the ground, in the site frame. One off the terrain lies on the reference surface.
Path3 on_ground_S_m(const std::vector<Geodetic>& points, const Ground& ground);

// Clockwise from true north: from the rover's start to its first waypoint elsewhere, else 0.
double default_heading_rad(const RoverMachine& machine, const SiteFrame& site);

// Errors for a start without ground and for waypoints without ground, or on slivers, that an event
// would drive to. For events that plan their routes, planning reports missing ground.
std::vector<Fault> site_faults(const RoverMachine& machine, const Ground& ground,
                               const std::function<bool(const PlanEvent&)>& plans_its_route);
// "waypoint 2 (10.000000,20.000000) is where the terrain is not known"
std::string unknown_ground_text(std::int64_t waypoint, const Geodetic& point);

// A warning when a rover starts outside its terrain, on the terrain beyond, or starts on or drives
// to ground known only in large cells (see Ground::coarseness): at the first such place. Empty for
// a rover that does not drive.
std::vector<Fault> coarse_ground(const RoverMachine& machine, const Ground& ground);

}  // namespace lsos
