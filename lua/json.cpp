// Lua tables as JSON, for the fields of notes.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "lua/api.h"
#include "lua/made.h"
#include "lua/vec3.h"

namespace lsos {

namespace {

using nlohmann::json;

constexpr int depth_max = 20;

json to_json(lua_State* L, int index, const std::string& path, int depth);

json number(lua_State* L, int index) {
  if (lua_isinteger(L, index)) return lua_tointeger(L, index);
  const double value = lua_tonumber(L, index);
  return std::isfinite(value) ? json(value) : json(nullptr);
}

json table(lua_State* L, int index, const std::string& path, int depth) {
  if (depth > depth_max) throw std::runtime_error(fmt::format("{}: nested too deep", path));
  luaL_checkstack(L, 4, "nested too deep");
  index = lua_absindex(L, index);
  const auto length = static_cast<lua_Integer>(lua_rawlen(L, index));
  if (length > 0) {
    json list = json::array();
    for (lua_Integer i = 1; i <= length; ++i, lua_pop(L, 1)) {
      lua_rawgeti(L, index, i);
      list.push_back(to_json(L, lua_gettop(L), fmt::format("{}[{}]", path, i), depth + 1));
    }
    return list;
  }
  json object = json::object();  // a std::map: keys are sorted
  lua_pushnil(L);
  for (; lua_next(L, index) != 0; lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING) {
      throw std::runtime_error(fmt::format("{}: keys are texts, found {}", path, describe(L, -2)));
    }
    const std::string key = lua_tostring(L, -2);
    object[key] =
        to_json(L, lua_gettop(L), path.empty() ? key : fmt::format("{}.{}", path, key), depth + 1);
  }
  return object;
}

json to_json(lua_State* L, int index, const std::string& path, int depth) {
  if (const std::optional<Vec3> v = to_vec3(L, index)) return {v->x(), v->y(), v->z()};
  switch (lua_type(L, index)) {
    case LUA_TNIL:
      return nullptr;
    case LUA_TBOOLEAN:
      return lua_toboolean(L, index) != 0;
    case LUA_TNUMBER:
      return number(L, index);
    case LUA_TSTRING:
      return std::string(lua_tostring(L, index));
    case LUA_TTABLE:
      return table(L, index, path, depth);
    default:
      throw std::runtime_error(
          fmt::format("{}: {} cannot be written to the log", path, describe(L, index)));
  }
}

}  // namespace

std::string fields_json(lua_State* L, int index) {
  if (lua_isnoneornil(L, index)) return "{}";
  const json fields = to_json(L, index, "", 0);
  if (!fields.is_object()) throw std::runtime_error("fields have names: { waypoint = 3 }");
  return fields.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace lsos
