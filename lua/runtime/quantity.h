// Quantities that scripts give to scenarios and interactive simulations: numbers in SI units, or
// texts with a unit.
#pragma once

#include <lua.hpp>

#include "base/units.h"

namespace lsos {

struct GivenQuantity {
  double value_si = 0;
  const Unit* unit = nullptr;  // where a text was given
};

// Reads a number, or a text such as '200 m'. Throws std::runtime_error that states the fault.
GivenQuantity check_quantity(lua_State* L, int argument);

// Reads seconds, 0 to 1e9, from a number or a text such as '20 min'. Throws std::runtime_error that
// begins with `what`.
double check_duration_s(lua_State* L, int argument, const char* what);

// Reads the time that deploying or stowing takes, s. Throws std::runtime_error beyond 366 days.
double check_deploying_s(lua_State* L, int argument, const char* what);

}  // namespace lsos
