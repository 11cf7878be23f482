#include "lua/host/script_number.h"

#include <fmt/format.h>

#include <utility>

#include "lua/api/api.h"
#include "lua/api/rover_constructors.h"
#include "lua/host/variant.h"
#include "lua/runtime/loader.h"
#include "lua/runtime/state.h"
#include "lua/runtime/text_literal.h"

namespace lsos {

namespace {

// Pushes the table that the object at the top was made from, or the value itself.
void push_keys(lua_State* L) {
  if (to_constructed(L, -1) == nullptr) {
    lua_pushvalue(L, -1);
  } else {
    lua_getiuservalue(L, -1, 1);
  }
}

// Pushes the part of the list at the top that has this name, or nil.
void push_part(lua_State* L, const std::string& name) {
  const auto count = static_cast<lua_Integer>(lua_rawlen(L, -1));
  for (lua_Integer i = 1; i <= count; ++i) {
    lua_rawgeti(L, -1, i);
    push_keys(L);
    if (lua_istable(L, -1)) {
      lua_pushliteral(L, "name");
      const bool is_it = lua_rawget(L, -2) == LUA_TSTRING && lua_tostring(L, -1) == name;
      lua_pop(L, 1);
      if (is_it) return;
    }
    lua_pop(L, 2);
  }
  lua_pushnil(L);
}

// Pushes what the table at the top has under a name: a key, or a part of a list.
void push_named(lua_State* L, const std::string& name) {
  lua_pushstring(L, name.c_str());
  if (lua_rawget(L, -2) != LUA_TNIL) return;
  lua_pop(L, 1);
  push_part(L, name);
}

// The number at a path of the object at the top.
std::optional<double> named_number_at(lua_State* L, std::string_view path) {
  luaL_checkstack(L, 100, "keys");
  constexpr int depth_max = 16;
  for (int depth = 0; depth < depth_max; ++depth) {
    push_keys(L);
    if (!lua_istable(L, -1)) return {};
    const std::size_t point = path.find('.');
    push_named(L, std::string(path.substr(0, point)));
    if (point == std::string_view::npos) {
      if (lua_type(L, -1) != LUA_TNUMBER) return {};
      return lua_tonumber(L, -1);
    }
    path.remove_prefix(point + 1);
  }
  return {};
}

}  // namespace

std::optional<double> script_number(const Catalog& catalog, const std::string& rover_type,
                                    const std::string& variant, const std::string& key) {
  std::string changes = "{}";
  if (!variant.empty()) {
    const Parsed<std::string> table = variant_table(variant);
    if (!table) return {};
    changes = *table.value;
  }
  Script script;
  script.kind = ScriptKind::rover;
  script.name = rover_type;
  script.file = "=Number";  // never shown, and no file has such a name
  script.source = fmt::format("local lsos = require 'lsos'; return lsos.derive({}, {})",
                              lua_text(rover_type), changes);
  LuaState lua(make_api);
  lua.context().scripts = &catalog.scripts();
  Faults faults;
  std::optional<double> number;
  lua.run([&](lua_State* L) {
    if (load_script(L, script, rover_kind, faults) != nullptr) number = named_number_at(L, key);
  });
  faults.throw_if_errors();
  return number;
}

std::optional<double> soil_number(const Soil& soil, const std::string& key) {
  static constexpr std::pair<const char*, double Soil::*> numbers[] = {
      {"k_c", &Soil::k_c},
      {"k_phi", &Soil::k_phi},
      {"n", &Soil::n},
      {"cohesion_pa", &Soil::cohesion_pa},
      {"friction_rad", &Soil::friction_rad},
      {"density_kgpm3", &Soil::density_kgpm3},
      {"shear_modulus_x_m", &Soil::shear_modulus_x_m},
      {"shear_modulus_y_m", &Soil::shear_modulus_y_m},
      {"slip_sinkage", &Soil::slip_sinkage}};
  for (const auto& [name, member] : numbers) {
    if (key == name) return soil.*member;
  }
  return {};
}

}  // namespace lsos
