// Facts about a rover that are known before anything runs, for an event's `check`.
#pragma once

#include <lua.hpp>

#include "mission/model/rover_model.h"
#include "plan/plan.h"

namespace lsos {

// Pushes { id, type, battery_capacity_j, charge_power_max_w, initial_charge, length_m, crew,
// configuration, slope_max_rad, panels }. A property that the rover lacks, or a limit that it does
// not have, is nil.
void push_rover_facts(lua_State* L, const PlanRover& rover, const RoverModel& model);

}  // namespace lsos
