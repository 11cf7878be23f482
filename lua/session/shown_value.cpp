#include "lua/session/shown_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "base/utf8.h"
#include "lua/runtime/handle.h"
#include "lua/runtime/reader.h"
#include "lua/runtime/sorted_keys.h"
#include "lua/runtime/state.h"
#include "lua/runtime/value_text.h"
#include "lua/runtime/vec3.h"

namespace lsos {

namespace {

constexpr int shown_depth_max = 16;  // of nested tables that are shown

bool has_text_of_its_own(lua_State* L, int index) {
  if (luaL_getmetafield(L, index, "__tostring") == LUA_TNIL) return false;
  lua_pop(L, 1);
  return true;
}

// "a boolean" when a key is neither a number nor a text, so that the keys have no order; else "".
std::string other_key(lua_State* L, int index) {
  std::string found;
  lua_pushnil(L);
  for (; lua_next(L, index) != 0; lua_pop(L, 1)) {
    const int type = lua_type(L, -2);
    if (type != LUA_TNUMBER && type != LUA_TSTRING)
      found = "a " + std::string(luaL_typename(L, -2));
  }
  return found;
}

// Whether numbers in a table are written with the units in their names.
enum class Units { none, shown };

// Unit in a name, for names of the API and for names that users choose.
std::string unit_of(const std::string& name) {
  // Every vec3 of these is a place in the site frame.
  static constexpr std::array<std::string_view, 6> places{"position", "path",     "geometry",
                                                          "ahead",    "place_of", "plan_path"};
  if (std::ranges::find(places, name) != places.end()) return "m";
  static constexpr std::pair<std::string_view, std::string_view> others[] = {
      {"_deg", "deg"}, {"_km", "km"}, {"_cm", "cm"},   {"_mm", "mm"},
      {"_h", "h"},     {"_wh", "Wh"}, {"_kwh", "kWh"}, {"_kw", "kW"}};
  for (const auto& [suffix, symbol] : others) {
    if (name.ends_with(suffix)) return std::string(symbol);
  }
  return si_unit_of(name);
}

// Name that gives a member its unit: entries of a list and x, y, z take that of their holder.
std::string name_of_member(lua_State* L, int key, const std::string& holder) {
  if (lua_type(L, key) != LUA_TSTRING) return holder;
  std::string name = lua_tostring(L, key);
  return name == "x" || name == "y" || name == "z" ? holder : name;
}

std::string tostring_text(lua_State* L, int index) {
  push_text(L, index);
  std::string text = error_text(L, -1);
  lua_pop(L, 1);
  return text;
}

std::string shown_number(lua_State* L, int index) {
  return lua_isinteger(L, index) == 0 ? fmt::format("{:.9g}", lua_tonumber(L, index))
                                      : tostring_text(L, index);
}

// A number, vec3, text or object, with the unit in its name: "1.97 m/s" for speed_mps.
std::string quantity_text(lua_State* L, int index, const std::string& name) {
  const std::string symbol = unit_of(name), unit = symbol.empty() ? "" : " " + symbol;
  if (lua_type(L, index) == LUA_TNUMBER) return shown_number(L, index) + unit;
  if (const std::optional<Vec3> v = to_vec3(L, index)) {
    return fmt::format("({:.9g}, {:.9g}, {:.9g}){}", v->x(), v->y(), v->z(), unit);
  }
  return tostring_text(L, index);
}

// The value in Lua's notation, cut off after about `bytes`: tables that contain each other would be
// written for minutes.
std::string written(lua_State* L, int index, Units units, const std::string& name,
                    std::size_t bytes, int depth = 0) {
  luaL_checkstack(L, 12, "tables in tables");
  index = lua_absindex(L, index);
  if (!lua_istable(L, index) || depth >= shown_depth_max || has_text_of_its_own(L, index)) {
    const std::string text =
        units == Units::shown ? quantity_text(L, index, name) : tostring_text(L, index);
    return lua_type(L, index) == LUA_TSTRING ? "'" + text + "'" : text;
  }
  if (const std::string other = other_key(L, index); !other.empty()) {
    return fmt::format("{{ with {} as a key }}", other);
  }
  std::string members;
  push_sorted_keys(L, index);
  for (lua_Integer i = 1; lua_rawgeti(L, -1, i) != LUA_TNIL; ++i, lua_pop(L, 1)) {
    if (!members.empty()) members += ", ";
    if (members.size() > bytes) {
      members += "...";
      break;
    }
    if (lua_isinteger(L, -1) == 0 || lua_tointeger(L, -1) != i) {
      members += fmt::format("{} = ", luaL_tolstring(L, -1, nullptr));
      lua_pop(L, 1);
    }
    const std::string member = name_of_member(L, -1, name);
    lua_pushvalue(L, -1);
    lua_rawget(L, index);
    members += written(L, -1, units, member, bytes, depth + 1);
    lua_pop(L, 1);
  }
  lua_pop(L, 2);
  return members.empty() ? "{}" : "{ " + members + " }";
}

// A member on one line; a table is cut off at the end of the line.
std::string member_text(lua_State* L, int index, const std::string& name) {
  constexpr std::size_t bytes_max = 200;
  if (!lua_istable(L, index) || has_text_of_its_own(L, index)) {
    return quantity_text(L, index, name);
  }
  std::string text = written(L, index, Units::shown, name, bytes_max);
  if (text.size() <= bytes_max) return text;
  return beginning(text, bytes_max) + "...";
}

// Adds the fields of a handle, or the entries of a table, one on each line.
void add_members(lua_State* L, int index, const std::string& name, std::string& text) {
  index = lua_absindex(L, index);
  if (const HandleType* type = handle_type(L, index)) {
    for (const HandleField& field : type->fields) {
      lua_getfield(L, index, field.name);
      text += fmt::format("\n  {} = {}", field.name, member_text(L, -1, field.name));
      lua_pop(L, 1);
    }
    return;
  }
  if (const std::string other = other_key(L, index); !other.empty()) {
    text += fmt::format("\n  (with {} as a key)", other);
    return;
  }
  constexpr lua_Integer members_max = 200;
  push_sorted_keys(L, index);
  const auto count = static_cast<lua_Integer>(lua_rawlen(L, -1));
  for (lua_Integer i = 1; i <= std::min(count, members_max); ++i, lua_pop(L, 1)) {
    lua_rawgeti(L, -1, i);
    const std::string key = quantity_text(L, -1, "");
    const std::string member = name_of_member(L, -1, name);
    lua_pushvalue(L, -1);
    lua_rawget(L, index);
    text += fmt::format("\n  {} = {}", key, member_text(L, -1, member));
    lua_pop(L, 1);
  }
  if (count > members_max) text += fmt::format("\n  and {} more", count - members_max);
  lua_pop(L, 1);
}

}  // namespace

std::string written_value(lua_State* L, int index) {
  constexpr std::size_t bytes_max = 10'000;
  return written(L, index, Units::none, "", bytes_max);
}

std::string shown_value(lua_State* L, int index, const std::string& name) {
  std::string text = quantity_text(L, index, name);
  const bool has_members =
      handle_type(L, index) != nullptr || (lua_istable(L, index) && !has_text_of_its_own(L, index));
  if (has_members) add_members(L, index, name, text);
  return text;
}

}  // namespace lsos
