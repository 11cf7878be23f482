// Conditions of a plan: StartWhen, SkipWhen and StopWhen hold a Lua expression over what is logged
// of the event's rover, such as `charge < 0.3 or distance_to('SEV2') < 100`.
#pragma once

#include <lua.hpp>
#include <set>
#include <string>
#include <vector>

#include "mission/rover_port.h"
#include "record/rows.h"

namespace lsos {

// What is wrong with it before anything runs; "" when it is well. `ids`: of rovers, assets and
// Earth.
std::string condition_fault(lua_State* L, const std::string& text,
                            const std::set<std::string>& ids);

// Whether it holds. Quantities that are not modelled are not-a-number: no comparison with them
// holds. Throws std::runtime_error.
bool condition_holds(lua_State* L, const std::string& text, const SampleRow& row,
                     const RoverPort& rover);

struct ConditionName {
  const char* name;
  const char* doc;
};
// All that it can name, beside Lua's `and`, `or`, `not` and `math`.
const std::vector<ConditionName>& condition_names();

}  // namespace lsos
