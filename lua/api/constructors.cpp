#include "lua/api/constructors.h"

#include <fmt/format.h>

#include <filesystem>

#include "lua/runtime/constructed_value.h"

namespace lsos {

TableReader constructor_reader(lua_State* L) {
  const std::string name = lua_tostring(L, lua_upvalueindex(1));
  Faults& faults = load_faults(L, ("lsos." + name).c_str());
  if (!lua_istable(L, 1)) {
    throw std::runtime_error(
        fmt::format("lsos.{0} takes a table, lsos.{0} {{...}}, found {1}", name, describe(L, 1)));
  }
  return {L, 1, name, caller_place(L), faults};
}

void keep_keys(lua_State* L, int index) {
  lua_newtable(L);
  lua_pushnil(L);
  while (lua_next(L, index) != 0) {
    lua_pushvalue(L, -2);
    lua_insert(L, -2);
    lua_rawset(L, -4);
  }
  lua_setiuservalue(L, -2, 1);
}

std::string script_name(const std::string& file) {
  return std::filesystem::path(file).stem().string();
}

}  // namespace lsos
