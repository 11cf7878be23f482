// Values that constructors make: C++ values that scripts can hold and pass on, but not inspect.
#pragma once

#include <any>
#include <lua.hpp>
#include <string>

#include "base/error.h"

namespace lsos {

struct ConstructedValue {
  std::string kind;  // "wheel": the constructor's name after "lsos."
  Place place;       // of the constructor's call
  std::any value;
};

// Pushes the value as userdata with one user value.
void push_constructed(lua_State* L, ConstructedValue made);

// The value at `index`; nullptr when something else is there.
const ConstructedValue* to_constructed(lua_State* L, int index);

// Noun for a message: "a wheel", "a number", "nothing".
std::string describe(lua_State* L, int index);

}  // namespace lsos
