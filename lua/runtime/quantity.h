// Quantities that scripts give to scenarios and simulations in hand: numbers in SI units, or texts
// with a unit.
#pragma once

#include <lua.hpp>

#include "base/units.h"

namespace lsos {

struct Quantity {
  double value_si = 0;
  const Unit* unit = nullptr;  // of a text
};

// Of a number, or of a text such as '200 m'. Throws std::runtime_error that names what is wrong.
Quantity check_quantity(lua_State* L, int argument);

// Seconds, 0 to 1e9: of a number, or of a text such as '20 min'. Throws std::runtime_error that
// begins with `what`.
double check_duration_s(lua_State* L, int argument, const char* what);

// How long something takes to go up or down, s. Throws std::runtime_error beyond 366 days.
double check_deploying_s(lua_State* L, int argument, const char* what);

}  // namespace lsos
