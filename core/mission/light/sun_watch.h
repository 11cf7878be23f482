// When the Sun is looked at, and what is gathered for the look.
#pragma once

#include "mission/light/light.h"
#include "mission/rover/rover_agent.h"
#include "mission/rover/standing_asset.h"

namespace lsos {

// Who moves nearer than this to a rover may shade it, m.
inline constexpr double shading_reach_m = 100;

// A rover's body and the panels that are up, about `eye_S_m`, site axes.
void append_solids(Mesh& mesh, const RoverAgent& rover, const Vec3& eye_S_m, SimTime now);
// An asset and its panels: those that turn face the Sun.
void append_solids(Mesh& mesh, const StandingAsset& asset, const Vec3& eye_S_m, const Vec3& sun_S);

// What the Sun does for a rover now. `others`: solids that may shade it, about the rover's
// reference point, site axes.
SunValue look_at_sun(Light& light, const Ground& ground, const RoverAgent& rover,
                     const Mesh& others, const Sunlight& sun, SimTime now);
// Turns a rover's panels to where the Sun is now.
void aim_panels(const Ground& ground, RoverAgent& rover, const Sunlight& sun, SimTime now);

// The same for an asset: panels that turn face the Sun.
SunValue look_at_sun(Light& light, const Ground& ground, const StandingAsset& asset,
                     const Mesh& others, const Sunlight& sun, SimTime now);

}  // namespace lsos
