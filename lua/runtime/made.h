// What constructors make: a C++ value that scripts can hold and pass on, but not look into.
#pragma once

#include <any>
#include <lua.hpp>
#include <string>

#include "base/error.h"

namespace lsos {

struct Made {
  std::string kind;  // "wheel": the constructor's name after "lsos."
  Place place;       // of the constructor's call
  std::any value;
};

// Pushes it as userdata with one user value.
void push_made(lua_State* L, Made made);

// nullptr when the value at `index` is something else.
const Made* to_made(lua_State* L, int index);

// "a wheel", "a number", "nothing": for messages.
std::string describe(lua_State* L, int index);

}  // namespace lsos
