#include "lua/api/arguments.h"

#include <fmt/format.h>

#include <algorithm>

#include "lua/runtime/environment.h"
#include "lua/runtime/handle.h"
#include "lua/runtime/read_only.h"
#include "lua/runtime/reader.h"
#include "lua/runtime/state.h"
#include "lua/runtime/value_text.h"
#include "lua/runtime/vec3.h"

namespace lsos {

namespace {

struct PushValue {
  lua_State* L;
  Instant mission_start;

  void operator()(bool value) const { lua_pushboolean(L, value); }
  void operator()(std::int64_t value) const { lua_pushinteger(L, value); }
  void operator()(double value) const { lua_pushnumber(L, value); }
  void operator()(const std::string& value) const {
    lua_pushlstring(L, value.data(), value.size());
  }
  void operator()(Instant value) const { lua_pushnumber(L, seconds(value - mission_start)); }
};

std::string known_keys(const EventDeclaration& event, std::string_view near) {
  std::vector<std::string> keys;
  for (const FieldDeclaration& field : event.fields) keys.push_back(field.key);
  return suggest_key(near, keys);
}

// Upvalues: table of values, table of known keys, the event's declaration.
int read_param(lua_State* L) {
  const auto& event = *static_cast<const EventDeclaration*>(lua_touserdata(L, lua_upvalueindex(3)));
  lua_settop(L, 2);
  lua_pushvalue(L, 2);
  lua_rawget(L, lua_upvalueindex(2));
  if (lua_isnil(L, -1)) {
    const std::string key = key_text(L, 2);
    throw std::runtime_error(
        fmt::format("{} has no parameter '{}'{}", event.name, key, known_keys(event, key)));
  }
  lua_pushvalue(L, 2);
  lua_rawget(L, lua_upvalueindex(1));
  return 1;
}

int refuse_params_write(lua_State*) { throw std::runtime_error("ev.params is read-only"); }

// pairs(ev.params) iterates over the given values. Upvalue: table of values.
int params_pairs(lua_State* L) {
  push_environment(L);
  lua_getfield(L, -1, "pairs");
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_call(L, 1, 3);
  return 3;
}

Range range_of(const FieldDeclaration& field) {
  Range range;
  if (field.min_si) range.min = *field.min_si;
  if (field.max_si) range.max = *field.max_si;
  return range;
}

void read_param(TableReader& t, const FieldDeclaration& field, Instant mission_start,
                std::map<std::string, FieldValue>& params) {
  const Need need = field.is_required ? required : optional;
  const char* key = field.key.c_str();
  const auto store = [&](const auto& value) {
    if (value) params[field.key] = *value;
  };
  std::optional<double> number;
  std::optional<std::int64_t> whole;
  std::optional<bool> flag;
  std::optional<std::string> text;
  switch (field.kind) {
    case FieldKind::duration:
    case FieldKind::number:
      t.number(need, key, number, range_of(field), "");
      if (number && field.kind == FieldKind::duration) number = rounded_s(*number);
      return store(number);
    case FieldKind::integer:
      t.integer(need, key, whole, range_of(field), "");
      return store(whole);
    case FieldKind::utc:
      t.number(need, key, number, {-9e9, 9e9}, "");
      if (number) params[field.key] = mission_start + from_seconds(*number);
      return;
    case FieldKind::moment:
      t.number(need, key, number, {-9e9, 9e9}, "");
      if (number) number = rounded_s(*number);
      return store(number);
    case FieldKind::boolean:
      t.boolean(need, key, flag, "");
      return store(flag);
    case FieldKind::text:
      t.text(need, key, text, "");
      return store(text);
    case FieldKind::choice:
      t.text(need, key, text, "");
      if (text && std::ranges::find(field.choices, *text) == field.choices.end()) {
        t.fault(fmt::format("{} = '{}': must be one of {}{}", key, *text,
                            fmt::join(field.choices, ", "), did_you_mean(*text, field.choices)));
      }
      return store(text);
  }
}

}  // namespace

void push_params(lua_State* L, const EventDeclaration& event, const EventArguments& arguments,
                 Instant mission_start) {
  lua_newtable(L);
  const int values = lua_gettop(L);
  for (const auto& [key, value] : arguments.params) {
    std::visit(PushValue{L, mission_start}, value);
    lua_setfield(L, values, key.c_str());
  }
  lua_newtable(L);
  const int known = lua_gettop(L);
  for (const FieldDeclaration& field : event.fields) {
    lua_pushboolean(L, 1);
    lua_setfield(L, known, field.key.c_str());
  }
  lua_newtable(L);  // the view
  lua_newtable(L);  // its metatable
  lua_pushvalue(L, values);
  lua_pushvalue(L, known);
  lua_pushlightuserdata(L, const_cast<EventDeclaration*>(&event));
  lua_pushcclosure(L, guard<read_param>, 3);
  lua_setfield(L, -2, "__index");
  lua_pushcfunction(L, guard<refuse_params_write>);
  lua_setfield(L, -2, "__newindex");
  lua_pushvalue(L, values);
  lua_pushcclosure(L, guard<params_pairs>, 1);
  lua_setfield(L, -2, "__pairs");
  lua_pushboolean(L, 0);
  lua_setfield(L, -2, "__metatable");
  lua_setmetatable(L, -2);
  lua_replace(L, values);
  lua_settop(L, values);
}

std::map<std::string, FieldValue> read_params(lua_State* L, int index,
                                              const EventDeclaration& event,
                                              Instant mission_start) {
  index = lua_absindex(L, index);
  const bool is_nil = lua_isnil(L, index);
  if (!is_nil && !lua_istable(L, index)) {
    throw std::runtime_error(
        fmt::format("parameters of {} must be a table, found {}", event.name, describe(L, index)));
  }
  if (is_nil) lua_newtable(L);
  Faults faults;
  TableReader t(L, is_nil ? -1 : index, "parameters of " + event.name, {}, faults);
  std::map<std::string, FieldValue> params;
  for (const FieldDeclaration& field : event.fields) {
    read_param(t, field, mission_start, params);
    if (!params.contains(field.key) && field.default_value)
      params[field.key] = *field.default_value;
  }
  t.finish();
  if (is_nil) lua_pop(L, 1);
  faults.throw_if_errors();
  return params;
}

Path3 read_path(lua_State* L, int index, const std::string& what) {
  constexpr std::int64_t instructions_per_point = 20;
  index = lua_absindex(L, index);
  if (const std::optional<Vec3> point = to_vec3(L, index)) return {*point};
  if (const EventArguments* given = to_geometry(L, index)) return given->geometry_S_m;
  if (!lua_istable(L, index) || is_vec3(L, index)) {
    throw std::runtime_error(
        fmt::format("{} wants a list of vec3, found {}", what, describe_no_vec3(L, index)));
  }
  const auto count = static_cast<lua_Integer>(lua_rawlen(L, index));
  Path3 path;
  for (lua_Integer i = 1; i <= count; ++i, lua_pop(L, 1)) {
    charge(L, instructions_per_point);
    lua_rawgeti(L, index, i);
    const std::optional<Vec3> point = to_vec3(L, -1);
    if (!point) {
      throw std::runtime_error(fmt::format("{}: waypoint {} must be a vec3 of numbers, found {}",
                                           what, i, describe_no_vec3(L, -1)));
    }
    path.push_back(*point);
  }
  return path;
}

namespace {

std::vector<Path3> read_holes(lua_State* L, int index, const EventDeclaration& event) {
  std::vector<Path3> holes;
  if (const EventArguments* arguments = to_geometry(L, index)) return arguments->holes_S_m;
  if (!lua_istable(L, index) || is_vec3(L, index)) return holes;
  lua_pushstring(L, "holes");
  lua_rawget(L, index);
  if (lua_istable(L, -1)) {
    for (lua_Integer i = 1; lua_rawgeti(L, -1, i) != LUA_TNIL; ++i, lua_pop(L, 1)) {
      holes.push_back(
          read_path(L, -1, fmt::format("hole {} of the geometry of {}", i, event.name)));
      if (holes.back().size() < 3) {
        throw std::runtime_error(
            fmt::format("hole {} of the geometry of {} has {} corners; three or more are wanted", i,
                        event.name, holes.back().size()));
      }
    }
    lua_pop(L, 1);
  } else if (!lua_isnil(L, -1)) {
    throw std::runtime_error(
        fmt::format("the holes of the geometry of {}: a list of lists of vec3 "
                    "is wanted, found {}",
                    event.name, describe(L, -1)));
  }
  lua_pop(L, 1);
  return holes;
}

}  // namespace

void read_waypoints(lua_State* L, int index, const EventDeclaration& event,
                    EventArguments& arguments) {
  index = lua_absindex(L, index);
  Path3 path;
  if (!lua_isnil(L, index)) path = read_path(L, index, "the geometry of " + event.name);
  const GeometryKind kind = path.empty()       ? GeometryKind::none
                            : path.size() == 1 ? GeometryKind::point
                                               : GeometryKind::line;
  const auto takes = [&](GeometryKind k) {
    return std::ranges::find(event.geometries, k) != event.geometries.end();
  };
  if (!takes(kind) && !(path.size() >= 3 && takes(GeometryKind::polygon))) {
    throw std::runtime_error(
        fmt::format("{} does not take a geometry of {} waypoints", event.name, path.size()));
  }
  arguments.geometry_S_m = std::move(path);
  arguments.holes_S_m = read_holes(L, index, event);
}

const EventDeclaration::Phase& find_phase(const EventDeclaration& event, const std::string& name) {
  std::vector<std::string> names;
  for (const EventDeclaration::Phase& phase : event.phases) {
    if (phase.name == name) return phase;
    names.push_back(phase.name);
  }
  throw std::runtime_error(fmt::format("there is no phase '{}'{}; phases are {}", name,
                                       did_you_mean(name, names), fmt::join(names, ", ")));
}

}  // namespace lsos
