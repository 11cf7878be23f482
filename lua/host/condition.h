// Conditions of a plan: StartWhen, SkipWhen, StopWhen and WarnWhen hold a Lua expression over
// the logged quantities of the event's rover, such as `charge < 0.3 or distance_to('SEV2') < 100`.
#pragma once

#include <lua.hpp>
#include <optional>
#include <string>
#include <vector>

#include "lua/host/condition_world.h"
#include "mission/port/rover_port.h"
#include "record/rows.h"

namespace lsos {

// What is wrong with a condition before anything runs; "" for a sound one (condition_check.cpp).
std::string condition_fault(lua_State* L, const std::string& text, const ConditionWorld& world);

// What is likely to be a mistake in a condition without faults: a comparison that never holds, or a
// number in another unit; "" for nothing.
std::string condition_doubt(const std::string& text, const ConditionWorld& world);

// Whether the condition holds. Quantities that are not modelled are not-a-number: comparisons
// with them are false, except ~=. Throws std::runtime_error.
bool condition_holds(lua_State* L, const std::string& text, const SampleRow& row,
                     const RoverPort& rover);

// The same of a row of a log, for a condition without questions.
bool condition_holds(lua_State* L, const std::string& text, const SampleRow& row);

// The values now of the quantities and questions that the condition names: "charge was 0.93,
// sees('B') was false".
std::string condition_values(const std::string& text, const SampleRow& row, const RoverPort& rover);

struct ConditionName {
  const char* name;
  const char* doc;
};
// All names that a condition can use besides Lua's `and`, `or`, `not` and `math`.
const std::vector<ConditionName>& condition_names();
// A quantity of a row by its name; absent where conditions have no such quantity.
std::optional<double> condition_quantity(const std::string& name, const SampleRow& row);
// Whether the name is a question, a function that takes a text: sees('SEV2').
bool is_question(const std::string& name);
// Whether the question gives a number; otherwise it gives true or false.
bool gives_number(const std::string& question);

// Parts of condition_fault, each "" for a sound condition: whether Lua can parse it; whether `math`
// has the member; whether it runs and gives true or false when all quantities are `value` and all
// questions answer `answer`.
std::string condition_syntax_fault(lua_State* L, const std::string& text);
std::string math_fault(lua_State* L, const std::string& member);
std::string condition_trial_fault(lua_State* L, const std::string& text, double value, bool answer);

}  // namespace lsos
