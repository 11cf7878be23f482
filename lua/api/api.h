// Registry of the lsos module: one list from which functions are bound to Lua and lua/README.md is
// written.
#pragma once

#include <lua.hpp>
#include <string>
#include <vector>

#include "lua/api/constructors.h"

namespace lsos {

struct ApiFunction {
  const char* name;
  lua_CFunction function;
  const char* signature;
  const char* doc;
  const char* type;  // as the Lua language server writes it
};

struct ApiConstant {
  const char* name;
  void (*push)(lua_State*);
  const char* doc;
};

const std::vector<ApiFunction>& api_functions();
const std::vector<ApiConstant>& api_constants();
// A section of the reference: events, fields of events, rovers, terrains and soils, or studies.
struct ApiSection {
  const char* title;
  std::vector<Constructor> constructors;
};
const std::vector<ApiSection>& api_sections();

// Makes the lsos module; called once for each Lua state.
// state.
void make_api(lua_State* L);
// The same with more functions.
void make_module(lua_State* L, const std::vector<ApiFunction>& more);

}  // namespace lsos
