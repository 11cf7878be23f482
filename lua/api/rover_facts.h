// What is known of a rover before anything runs, as an event's `check` sees it.
#pragma once

#include <lua.hpp>

#include "mission/model/rover_model.h"
#include "plan/plan.h"

namespace lsos {

// Pushes { id, type, battery_capacity_j, charge_power_max_w, initial_charge, length_m,
// slope_max_rad, panels
// }. What the rover has not, or has no limit of, is nil.
void push_rover_facts(lua_State* L, const PlanRover& rover, const RoverModel& model);

}  // namespace lsos
