#include "lua/api/derive.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "lua/api/arguments.h"
#include "lua/api/constructors.h"
#include "lua/api/rover_constructors.h"
#include "lua/runtime/constructed_value.h"
#include "lua/runtime/environment.h"
#include "lua/runtime/loader.h"
#include "lua/runtime/module.h"
#include "lua/runtime/reader.h"
#include "lua/runtime/state.h"
#include "lua/runtime/value_text.h"
#include "lua/runtime/vec3.h"

namespace lsos {

namespace {

// Texts of the changes, for the sentence among the assumptions: "battery.capacity_j = 2.16e+08".
using Changes = std::vector<std::string>;

std::string joined_path(const std::string& path, const std::string& key) {
  return path.empty() ? key : path + "." + key;
}

// The value at the top as the sentence shows it.
std::string derived_value_text(lua_State* L) {
  if (const auto v = to_vec3(L, -1))
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", v->x(), v->y(), v->z());
  switch (lua_type(L, -1)) {
    case LUA_TNUMBER:
      return fmt::format("{:.6g}", lua_tonumber(L, -1));
    case LUA_TBOOLEAN:
      return lua_toboolean(L, -1) != 0 ? "true" : "false";
    case LUA_TSTRING:
      return fmt::format("'{}'", lua_tostring(L, -1));
    default:
      return describe(L, -1);
  }
}

// Pushes a copy of the table that the object at `index` was made from.
void push_copied_keys(lua_State* L, int index, const std::string& path) {
  index = lua_absindex(L, index);
  lua_newtable(L);
  if (lua_getiuservalue(L, index, 1) != LUA_TTABLE) {
    throw std::runtime_error(fmt::format("lsos.derive: {}: {} cannot be changed by parts",
                                         path.empty() ? "the base" : path, describe(L, index)));
  }
  lua_pushnil(L);
  while (lua_next(L, -2) != 0) {
    lua_pushvalue(L, -2);
    lua_insert(L, -2);
    lua_rawset(L, -5);
  }
  lua_pop(L, 1);
}

void push_changed(lua_State* L, int made, int changes, const std::string& path, Changes& applied);

// The name that a part in a list was given; "" for a part without one.
std::string given_name(lua_State* L, int index) {
  std::string name;
  if (to_constructed(L, index) == nullptr) return name;
  if (lua_getiuservalue(L, index, 1) == LUA_TTABLE) {
    lua_pushliteral(L, "name");
    if (lua_rawget(L, -2) == LUA_TSTRING) name = lua_tostring(L, -1);
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
  return name;
}

[[noreturn]] void refuse_name(lua_State* L, int list, const std::string& path,
                              const std::string& name) {
  std::vector<std::string> names;
  const auto count = static_cast<lua_Integer>(lua_rawlen(L, list));
  for (lua_Integer k = 1; k <= count; ++k) {
    lua_rawgeti(L, list, k);
    if (std::string found = given_name(L, -1); !found.empty()) names.push_back(std::move(found));
    lua_pop(L, 1);
  }
  throw std::runtime_error(
      names.empty()
          ? fmt::format("lsos.derive: {}: has no parts with names; a whole new list is wanted",
                        path)
          : fmt::format("lsos.derive: {}: there is no '{}'; there are {}", path, name,
                        fmt::join(names, ", ")));
}

// Pushes the list at `list` with the changes in the table at `changes`, which maps names of parts
// to changes.
void push_changed_list(lua_State* L, int list, int changes, const std::string& path,
                       Changes& applied) {
  list = lua_absindex(L, list);
  changes = lua_absindex(L, changes);
  lua_pushnil(L);
  while (lua_next(L, changes) != 0) {
    const std::string name = lua_type(L, -2) == LUA_TSTRING ? lua_tostring(L, -2) : "";
    bool is_there = false;
    const auto count = static_cast<lua_Integer>(lua_rawlen(L, list));
    for (lua_Integer k = 1; k <= count && !is_there; ++k) {
      lua_rawgeti(L, list, k);
      is_there = !name.empty() && given_name(L, -1) == name;
      lua_pop(L, 1);
    }
    if (!is_there) refuse_name(L, list, path, key_text(L, -2));
    lua_pop(L, 1);
  }
  lua_newtable(L);
  const int result = lua_gettop(L);
  const auto count = static_cast<lua_Integer>(lua_rawlen(L, list));
  for (lua_Integer k = 1; k <= count; ++k) {
    lua_rawgeti(L, list, k);
    const std::string name = given_name(L, -1), here = joined_path(path, name);
    if (name.empty()) lua_pushnil(L);
    if (!name.empty()) {
      lua_pushlstring(L, name.data(), name.size());
      lua_rawget(L, changes);
    }
    if (lua_isboolean(L, -1) && lua_toboolean(L, -1) == 0) {
      applied.push_back("no " + here);
      lua_pop(L, 2);
      continue;
    }
    if (lua_istable(L, -1)) {
      push_changed(L, -2, -1, here, applied);
      lua_replace(L, -3);
    } else if (!lua_isnil(L, -1)) {
      throw std::runtime_error(
          fmt::format("lsos.derive: {}: a table of changes or false is wanted, found {}", here,
                      describe(L, -1)));
    }
    lua_pop(L, 1);
    lua_rawseti(L, result, static_cast<lua_Integer>(lua_rawlen(L, result)) + 1);
  }
}

// Whether the table at `index` maps names to changes; otherwise it is a whole new list.
bool has_names(lua_State* L, int index) {
  lua_pushvalue(L, index);
  lua_pushnil(L);
  const bool has_any = lua_next(L, -2) != 0;
  const bool is_name = has_any && lua_type(L, -2) == LUA_TSTRING;
  lua_pop(L, has_any ? 3 : 1);
  return is_name;
}

// Adds a doubt about a number of another order of magnitude than the base's, as kWh in place of J.
void doubt_size(lua_State* L, const std::string& path) {
  constexpr double most_times = 1e3;
  if (lua_type(L, -1) != LUA_TNUMBER || lua_type(L, -2) != LUA_TNUMBER) return;
  const double now = std::abs(lua_tonumber(L, -1)), was = std::abs(lua_tonumber(L, -2));
  if (now == 0 || was == 0 || (now <= most_times * was && was <= most_times * now)) return;
  const std::string unit = si_unit_of(path);
  context(L).doubts.push_back(
      fmt::format("{} = {:g}{}{}: the rover has {:g}; is it in another unit?", path,
                  lua_tonumber(L, -1), unit.empty() ? "" : " ", unit, lua_tonumber(L, -2)));
}

// Replaces the new value at the top by the old value below it with the change applied.
void change(lua_State* L, const std::string& path, Changes& applied) {
  // A vec3 is replaced as a whole, though Lua stores it as a table.
  const bool is_part = to_constructed(L, -2) != nullptr;
  const bool is_list = lua_istable(L, -2) && !is_vec3(L, -2);
  if (lua_istable(L, -1) && is_part) {
    push_changed(L, -2, -1, path, applied);
    lua_replace(L, -2);
  } else if (lua_istable(L, -1) && is_list && has_names(L, -1)) {
    push_changed_list(L, -2, -1, path, applied);
    lua_replace(L, -2);
  } else if ((is_part || is_list) && lua_isboolean(L, -1) && lua_toboolean(L, -1) == 0) {
    applied.push_back("no " + path);
    lua_pushnil(L);
    lua_replace(L, -2);
  } else {
    doubt_size(L, path);
    applied.push_back(fmt::format("{} = {}", path, derived_value_text(L)));
  }
}

// Merges the table of changes into the table at the top.
void merge(lua_State* L, int changes, const std::string& path, Changes& applied) {
  const int keys = lua_gettop(L);
  std::vector<std::string> names;
  lua_pushnil(L);
  while (lua_next(L, changes) != 0) {
    if (lua_type(L, -2) != LUA_TSTRING) {
      throw std::runtime_error(fmt::format("lsos.derive: {}: names of keys are wanted, found [{}]",
                                           path.empty() ? "changes" : path, key_text(L, -2)));
    }
    names.emplace_back(lua_tostring(L, -2));
    lua_pop(L, 1);
  }
  std::ranges::sort(names);  // their order in the sentence
  for (const std::string& name : names) {
    if (path.empty() && (name == "assumptions" || name == "doc" || name == "api")) continue;
    lua_getfield(L, keys, name.c_str());
    lua_getfield(L, changes, name.c_str());
    change(L, joined_path(path, name), applied);
    lua_setfield(L, keys, name.c_str());
    lua_pop(L, 1);
  }
}

void construct_again(lua_State* L, const std::string& kind) {
  push_lsos_module(L);
  lua_getfield(L, -1, kind.c_str());
  lua_replace(L, -2);
  lua_insert(L, -2);
  lua_call(L, 1, 1);
}

void push_changed(lua_State* L, int made, int changes, const std::string& path, Changes& applied) {
  luaL_checkstack(L, 20, "lsos.derive");
  changes = lua_absindex(L, changes);
  const std::string kind = to_constructed(L, made)->kind;
  push_copied_keys(L, made, path);
  merge(L, changes, path, applied);
  construct_again(L, kind);
}

// Sets the assumptions of the table at `keys`: its own, those of `changes`, then `more`.
void add_assumptions(lua_State* L, int keys, int changes, const std::vector<std::string>& more) {
  lua_newtable(L);
  lua_Integer count = 0;
  const auto add_all = [&](int from) {
    lua_getfield(L, from, "assumptions");
    if (lua_istable(L, -1)) {
      const auto size = static_cast<lua_Integer>(lua_rawlen(L, -1));
      for (lua_Integer k = 1; k <= size; ++k) {
        lua_rawgeti(L, -1, k);
        lua_rawseti(L, -3, ++count);
      }
    } else if (!lua_isnil(L, -1)) {
      throw std::runtime_error(fmt::format(
          "lsos.derive: assumptions: a list of texts is wanted, found {}", describe(L, -1)));
    }
    lua_pop(L, 1);
  };
  add_all(keys);
  add_all(changes);
  for (const std::string& text : more) {
    lua_pushlstring(L, text.data(), text.size());
    lua_rawseti(L, -2, ++count);
  }
  lua_setfield(L, keys, "assumptions");
}

// Runs the base's script and pushes what it returns.
const ConstructedValue& push_base(lua_State* L, const std::string& name) {
  LuaContext& ctx = context(L);
  load_faults(L, "derive");
  if (ctx.scripts == nullptr || ctx.loading->kind != ScriptKind::rover)
    throw std::runtime_error("lsos.derive works only in rovers/");
  const auto is_base = [&](const Script& script) {
    return script.kind == ScriptKind::rover && script.name == name;
  };
  const auto script = std::ranges::find_if(*ctx.scripts, is_base);
  if (script == ctx.scripts->end()) {
    std::vector<std::string> names;
    for (const Script& one : *ctx.scripts) {
      if (one.kind == ScriptKind::rover) names.push_back(one.name);
    }
    throw std::runtime_error(
        fmt::format("lsos.derive: there is no rover '{}'{}", name, did_you_mean(name, names)));
  }
  const std::string own = script_name(caller_place(L).file);
  if (name == own || std::ranges::count(ctx.deriving, name) > 0) {
    throw std::runtime_error(
        fmt::format("lsos.derive: '{}' is derived from itself{}", name,
                    name == own ? "; a script of another name is wanted" : ""));
  }
  ctx.deriving.push_back(name);
  ctx.bases.insert(name);
  run_within(L, *script);
  ctx.deriving.pop_back();
  const ConstructedValue* made = to_constructed(L, -1);
  if (made == nullptr || (made->kind != rover_kind && made->kind != asset_kind)) {
    throw std::runtime_error(fmt::format("lsos.derive: the script of '{}' makes no rover", name));
  }
  return *made;
}

}  // namespace

int derive(lua_State* L) {
  const std::string base = luaL_checkstring(L, 1);
  luaL_checktype(L, 2, LUA_TTABLE);
  lua_settop(L, 2);
  constexpr int changes = 2;
  const std::string kind = push_base(L, base).kind;
  push_copied_keys(L, -1, "");
  const int keys = lua_gettop(L);
  lua_pushnil(L);
  lua_setfield(L, keys, "name");  // the base's name; the derived script is named by its own file
  for (const char* own : {"doc", "api"}) {
    lua_getfield(L, changes, own);
    if (lua_isnil(L, -1)) {
      lua_pop(L, 1);
    } else {
      lua_setfield(L, keys, own);
    }
  }
  Changes applied;
  merge(L, changes, "", applied);
  std::vector<std::string> sentence;
  if (!applied.empty()) {
    sentence.push_back(fmt::format("{}: is {} with {}", script_name(caller_place(L).file), base,
                                   fmt::join(applied, ", ")));
  }
  add_assumptions(L, keys, changes, sentence);
  construct_again(L, kind);
  return 1;
}

}  // namespace lsos
