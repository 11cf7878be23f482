// The lsos module as a registry: what is bound to Lua and what lua/README.md says are one list.
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
// Sections: fields, events, rovers, terrains.
struct ApiSection {
  const char* title;
  std::vector<Constructor> constructors;
};
const std::vector<ApiSection>& api_sections();

// Makes the sandbox and the module of a state whose scripts are events, rovers and terrains. Once a
// state.
void make_api(lua_State* L);
// The same with more functions.
void make_module(lua_State* L, const std::vector<ApiFunction>& more);

}  // namespace lsos
