// Conditions of a plan: StartWhen, SkipWhen and StopWhen hold a Lua expression over what is logged
// of the event's rover, such as `charge < 0.3 or distance_to('SEV2') < 100`.
#pragma once

#include <lua.hpp>
#include <optional>
#include <string>
#include <vector>

#include "lua/host/condition_world.h"
#include "mission/port/rover_port.h"
#include "record/rows.h"

namespace lsos {

// What is wrong with it before anything runs; "" when it is well (condition_check.cpp).
std::string condition_fault(lua_State* L, const std::string& text, const ConditionWorld& world);

// What is likely to be a slip in one without faults: comparisons that never hold, numbers in
// another unit; "" for nothing.
std::string condition_doubt(const std::string& text, const ConditionWorld& world);

// Whether it holds. Quantities that are not modelled are not-a-number: no comparison with them
// holds. Throws std::runtime_error.
bool condition_holds(lua_State* L, const std::string& text, const SampleRow& row,
                     const RoverPort& rover);

// What the quantities and questions that it names are now: "charge was 0.93, sees('B') was false".
std::string condition_values(const std::string& text, const SampleRow& row, const RoverPort& rover);

struct ConditionName {
  const char* name;
  const char* doc;
};
// All that it can name, beside Lua's `and`, `or`, `not` and `math`.
const std::vector<ConditionName>& condition_names();
// A quantity of a row by its name; absent: a condition has no such one.
std::optional<double> condition_quantity(const std::string& name, const SampleRow& row);
// Whether the name is one that is asked with a text: sees('SEV2').
bool is_question(const std::string& name);
// Whether that question's answer is a number; else it is true or false.
bool gives_number(const std::string& question);

// Parts of condition_fault, "" when well: whether Lua can read it; whether math has that; whether
// it runs and gives true or false when all quantities are `value`, all answers `answer`.
std::string condition_syntax_fault(lua_State* L, const std::string& text);
std::string math_fault(lua_State* L, const std::string& member);
std::string condition_trial_fault(lua_State* L, const std::string& text, double value, bool answer);

}  // namespace lsos
