// Reads plans and events that scripts give as tables.
#pragma once

#include <lua.hpp>
#include <string>

#include "base/error.h"
#include "base/vector.h"
#include "plan/kml_reader.h"
#include "planet/site_frame.h"

namespace lsos {

struct PlanTable {
  KmlSource source;  // the plan as if it had been drawn on a map
  std::string soil;  // replaces the terrain's soil; "": its own
};

// Reads the plan at `index`: { planet = , terrain = , rovers = { A = { type = , events = {...} } }
// }. `place`: where the table stands, for messages. Throws InputError with all faults.
PlanTable read_plan_table(lua_State* L, int index, const Place& place);

// Reads the event at `index`: { 'Route', path = {...}, Speed = '2 km/h' }; names that begin with a
// capital are fields of the event. Waypoints are vec3 or { east_m, north_m } in the site's frame.
SourcePlacemark read_event_table(lua_State* L, int index, const SiteFrame& site,
                                 const Place& place);

}  // namespace lsos
