#include "lua/runtime/json.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "lua/runtime/constructed_value.h"
#include "lua/runtime/context.h"
#include "lua/runtime/sorted_keys.h"
#include "lua/runtime/state.h"
#include "lua/runtime/value_text.h"
#include "lua/runtime/vec3.h"

namespace lsos {

namespace {

using nlohmann::json;

constexpr int json_depth_max = 20;
constexpr std::int64_t instructions_per_value = 20;

// Converts one table for the log. A table may occur in several places, so the size of the result is
// bounded as well as its depth.
class Writer {
 public:
  explicit Writer(lua_State* state) : L_(state) {}

  json to_json(int index, const std::string& path, int depth) {
    charge(L_, instructions_per_value);
    count(path, 8);
    if (const std::optional<Vec3> v = to_vec3(L_, index)) return {v->x(), v->y(), v->z()};
    switch (lua_type(L_, index)) {
      case LUA_TNIL:
        return nullptr;
      case LUA_TBOOLEAN:
        return lua_toboolean(L_, index) != 0;
      case LUA_TNUMBER:
        return number(index);
      case LUA_TSTRING:
        return text(index, path);
      case LUA_TTABLE:
        return table(index, path, depth);
      default:
        throw std::runtime_error(
            fmt::format("{}: {} cannot be written to the log", path, describe(L_, index)));
    }
  }

 private:
  void count(const std::string& path, std::size_t bytes) {
    bytes_ += bytes;
    if (bytes_ <= note_bytes_max) return;
    throw std::runtime_error(
        fmt::format("{}: more than {} KiB in one note", path, note_bytes_max >> 10));
  }

  // JSON has no infinity and no not-a-number; they become null.
  json number(int index) {
    if (lua_isinteger(L_, index)) return lua_tointeger(L_, index);
    const double value = lua_tonumber(L_, index);
    return std::isfinite(value) ? json(value) : json(nullptr);
  }

  std::string text(int index, const std::string& path) {
    std::size_t size = 0;
    const char* bytes = lua_tolstring(L_, index, &size);
    charge_bytes(L_, size);
    count(path, size);
    return {bytes, size};
  }

  json table(int index, const std::string& path, int depth) {
    if (depth > json_depth_max) throw std::runtime_error(fmt::format("{}: nested too deep", path));
    luaL_checkstack(L_, 8, "nested too deep");
    index = lua_absindex(L_, index);
    const auto length = static_cast<lua_Integer>(lua_rawlen(L_, index));
    return length > 0 ? list(index, path, depth, length) : fields(index, path, depth);
  }

  json list(int index, const std::string& path, int depth, lua_Integer length) {
    json list = json::array();
    for (lua_Integer i = 1; i <= length; ++i, lua_pop(L_, 1)) {
      lua_rawgeti(L_, index, i);
      list.push_back(to_json(lua_gettop(L_), fmt::format("{}[{}]", path, i), depth + 1));
    }
    check_list(index, path, length);
    return list;
  }

  // Throws where a list has other keys, which would be lost; the first in order is named.
  void check_list(int index, const std::string& path, lua_Integer length) {
    std::optional<std::string> other;
    lua_pushnil(L_);
    for (; lua_next(L_, index) != 0; lua_pop(L_, 1)) {
      charge(L_, 1);
      const lua_Integer i = lua_isinteger(L_, -2) != 0 ? lua_tointeger(L_, -2) : 0;
      if (i >= 1 && i <= length) continue;
      const std::string key = lua_type(L_, -2) == LUA_TSTRING ? key_text(L_, -2)
                              : lua_isnumber(L_, -2) != 0
                                  ? fmt::format("[{}]", lua_tonumber(L_, -2))
                                  : describe(L_, -2);
      if (!other || key < *other) other = key;
    }
    if (!other) return;
    throw std::runtime_error(fmt::format(
        "{}: a list with a key '{}' besides cannot be written to the log", path, *other));
  }

  json fields(int index, const std::string& path, int depth) {
    lua_pushnil(L_);
    for (; lua_next(L_, index) != 0; lua_pop(L_, 1)) {
      charge(L_, 1);
      if (lua_type(L_, -2) != LUA_TSTRING) {
        throw std::runtime_error(
            fmt::format("{}: keys are texts, found {}", path, describe(L_, -2)));
      }
    }
    json object = json::object();
    push_sorted_keys(L_, index);  // the same fault is then found first each time
    const auto count = static_cast<lua_Integer>(lua_rawlen(L_, -1));
    for (lua_Integer i = 1; i <= count; ++i, lua_pop(L_, 2)) {
      lua_rawgeti(L_, -1, i);
      const std::string key = text(lua_gettop(L_), path), shown = key_text(L_, -1);
      lua_pushvalue(L_, -1);
      lua_rawget(L_, index);
      object[key] = to_json(lua_gettop(L_),
                            path.empty() ? shown : fmt::format("{}.{}", path, shown), depth + 1);
    }
    lua_pop(L_, 1);
    return object;
  }

  lua_State* L_;
  std::size_t bytes_ = 0;
};

}  // namespace

std::string fields_json(lua_State* L, int index) {
  if (lua_isnoneornil(L, index)) return "{}";
  if (lua_istable(L, index) && lua_rawlen(L, index) > 0) {
    throw std::runtime_error("fields have names: { waypoint = 3 }");
  }
  const json fields = Writer(L).to_json(index, "", 0);
  if (!fields.is_object()) throw std::runtime_error("fields have names: { waypoint = 3 }");
  return fields.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace lsos
