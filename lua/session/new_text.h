// Texts that `lsos-host new` writes: scripts, a scenario and a plan to start from.
#pragma once

#include <string>

#include "lua/session/schema_kinds.h"

namespace lsos {

// An event of that name that waits, and a scenario that tests it.
std::string new_event_text(const std::string& name);
std::string new_event_scenario_text(const std::string& name);
// A rover that differs from `base` in one number, and a scenario that drives it. `mass_kg`: mass of
// the base's chassis.
std::string new_rover_text(const std::string& name, const std::string& base, double mass_kg);
std::string new_rover_scenario_text(const std::string& name);
// Ground from a raster (a path from the script), or synthetic ground for "".
std::string new_terrain_text(const std::string& raster);
// A scenario with a drive that must arrive.
std::string new_scenario_text(const std::string& name);

// A plan of one rover that drives out, looks around and comes back.
struct NewPlan {
  std::string name, terrain, rover_type;
  const Body* body = nullptr;
  Geodetic start;
};
// The plan as KML, with the schemas of `kinds`.
KmlDocument new_plan(const NewPlan& plan, const std::vector<Kind>& kinds);

}  // namespace lsos
