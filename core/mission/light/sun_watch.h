// When sunlight on rovers and assets is evaluated, and the scenes gathered for it.
#pragma once

#include "mission/light/light.h"
#include "mission/rover/rover_agent.h"
#include "mission/rover/standing_asset.h"

namespace lsos {

// Who moves nearer than this to a rover may shade it, m.
inline constexpr double shading_reach_m = 100;
// How often light and sight are looked at in an estimate while panels turn.
inline constexpr SimTime estimate_turn_period{10'000'000};

// Appends a rover's body, masts and the panels that are up, relative to `eye_S_m`, site axes.
void append_solids(Mesh& mesh, const RoverAgent& rover, const Vec3& eye_S_m, SimTime now);
// Appends an asset and its panels; panels that turn face the Sun.
void append_solids(Mesh& mesh, const StandingAsset& asset, const Vec3& eye_S_m, const Vec3& sun_S);

// Evaluates sunlight on a rover now. `others`: solids that may shade it, relative to the rover's
// reference point, site axes.
PanelSunlight evaluate_sunlight(Light& light, const Ground& ground, const RoverAgent& rover,
                                const Mesh& others, const Sunlight& sun, SimTime now);
// Turns a rover's panels towards the present direction of the Sun.
void aim_panels(const Ground& ground, RoverAgent& rover, const Sunlight& sun, SimTime now);

// Evaluates sunlight on an asset; panels that turn face the Sun.
PanelSunlight evaluate_sunlight(Light& light, const Ground& ground, const StandingAsset& asset,
                                const Mesh& others, const Sunlight& sun, SimTime now);

}  // namespace lsos
