// What scripts say of the things that a rover carries, and do with them.
#pragma once

#include <lua.hpp>

#include <map>
#include <string>

namespace lsos {

// Reads amounts by name, { oxygen = 0.4 }; nil is none. Throws std::runtime_error.
std::map<std::string, double> check_amounts(lua_State* L, int index);

// rover:resource(name), rover:use(name, amount), rover:restock(name, amount)
int left_of_resource(lua_State* L);
int use_resource(lua_State* L);
int restock(lua_State* L);

}  // namespace lsos
