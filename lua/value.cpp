#include "lua/value.h"

#include <fmt/format.h>

#include <cctype>
#include <map>

#include "lua/made.h"
#include "lua/sandbox.h"
#include "lua/vec3.h"

namespace lsos {

namespace {

constexpr int depth_max = 100;

enum class Tag : std::uint8_t { nil, no, yes, integer, number, text, vec3, table };

// The tables on the way, by identity, with the path at which each was found. Only looked up, so
// that addresses reach no result.
using Seen = std::map<const void*, std::string>;

class Saver {
 public:
  Saver(lua_State* state, Archive& archive) : L_(state), archive_(archive) {}

  void value(int index, const std::string& path, int depth) {
    switch (lua_type(L_, index)) {
      case LUA_TNIL:
        return tag(Tag::nil);
      case LUA_TBOOLEAN:
        return tag(lua_toboolean(L_, index) != 0 ? Tag::yes : Tag::no);
      case LUA_TNUMBER:
        return number(index);
      case LUA_TSTRING:
        tag(Tag::text);
        return text(index);
      case LUA_TTABLE:
        return table(index, path, depth);
      default:
        throw std::runtime_error(fmt::format("{}: {} cannot be saved", path, describe(L_, index)));
    }
  }

 private:
  void tag(Tag tag) { archive_(tag); }

  void number(int index) {
    if (lua_isinteger(L_, index) != 0) {
      tag(Tag::integer);
      std::int64_t value = lua_tointeger(L_, index);
      archive_(value);
    } else {
      tag(Tag::number);
      double value = lua_tonumber(L_, index);
      archive_(value);
    }
  }

  void text(int index) {
    std::size_t size = 0;
    const char* bytes = lua_tolstring(L_, index, &size);
    std::string value(bytes, size);
    archive_(value);
  }

  void check_table(int index, const std::string& path, int depth) {
    if (depth > depth_max) {
      throw std::runtime_error(fmt::format("{}: nested deeper than {}", path, depth_max));
    }
    const auto [found, is_new] = seen_.emplace(lua_topointer(L_, index), path);
    if (!is_new) {
      throw std::runtime_error(
          fmt::format("{} is the same table as {}; save a copy, as they would come back apart",
                      path, found->second));
    }
  }

  void table(int index, const std::string& path, int depth) {
    index = lua_absindex(L_, index);
    luaL_checkstack(L_, 6, "nested too deep");
    check_table(index, path, depth);
    if (is_vec3(L_, index)) return vec3(index, path);
    if (lua_getmetatable(L_, index) != 0) {
      throw std::runtime_error(fmt::format("{}: a table with a metatable cannot be saved", path));
    }
    const auto length = static_cast<std::int64_t>(lua_rawlen(L_, index));
    tag(Tag::table);
    list(index, path, depth, length);
    fields(index, path, depth, length);
  }

  void vec3(int index, const std::string& path) {
    std::optional<Vec3> v = to_vec3(L_, index);
    if (!v) throw std::runtime_error(fmt::format("{}: x, y, z must be finite numbers", path));
    tag(Tag::vec3);
    archive_(*v);
  }

  void list(int index, const std::string& path, int depth, std::int64_t length) {
    archive_(length);
    for (lua_Integer i = 1; i <= length; ++i, lua_pop(L_, 1)) {
      const std::string item = fmt::format("{}[{}]", path, i);
      if (lua_rawgeti(L_, index, i) == LUA_TNIL) {
        throw std::runtime_error(fmt::format("{} is a hole: lists must be without", item));
      }
      value(lua_gettop(L_), item, depth + 1);
    }
  }

  void fields(int index, const std::string& path, int depth, std::int64_t length) {
    check_keys(index, path, length);
    push_sorted_keys(L_, index);
    const auto key_count = static_cast<std::int64_t>(lua_rawlen(L_, -1));
    std::int64_t field_count = key_count - length;
    archive_(field_count);
    for (lua_Integer i = length + 1; i <= key_count; ++i, lua_pop(L_, 2)) {
      lua_rawgeti(L_, -1, i);
      text(-1);
      lua_pushvalue(L_, -1);
      lua_rawget(L_, index);
      value(lua_gettop(L_), fmt::format("{}.{}", path, lua_tostring(L_, -2)), depth + 1);
    }
    lua_pop(L_, 1);
  }

  // Keys are 1..length and texts.
  void check_keys(int index, const std::string& path, std::int64_t length) {
    lua_pushnil(L_);
    for (; lua_next(L_, index) != 0; lua_pop(L_, 1)) {
      if (lua_type(L_, -2) == LUA_TSTRING) continue;
      if (lua_isinteger(L_, -2) != 0) {
        const lua_Integer i = lua_tointeger(L_, -2);
        if (i >= 1 && i <= length) continue;
        throw std::runtime_error(fmt::format(
            "{}[{}]: a list begins at 1 and has no holes; use text keys otherwise", path, i));
      }
      throw std::runtime_error(
          fmt::format("{}: {} as a key cannot be saved; keys are texts", path, describe(L_, -2)));
    }
  }

  lua_State* L_;
  Archive& archive_;
  Seen seen_;
};

void restore_table(lua_State* L, Archive& archive) {
  luaL_checkstack(L, 6, "nested too deep");
  std::int64_t length = 0;
  archive(length);
  lua_newtable(L);
  for (std::int64_t i = 1; i <= length; ++i) {
    restore_value(L, archive);
    lua_rawseti(L, -2, i);
  }
  std::int64_t field_count = 0;
  archive(field_count);
  for (std::int64_t i = 0; i < field_count; ++i) {
    std::string key;
    archive(key);
    lua_pushlstring(L, key.data(), key.size());
    restore_value(L, archive);
    lua_rawset(L, -3);
  }
}

}  // namespace

void save_value(lua_State* L, int index, const std::string& name, Archive& archive) {
  Saver(L, archive).value(lua_absindex(L, index), name, 0);
}

void restore_value(lua_State* L, Archive& archive) {
  Tag tag{};
  archive(tag);
  switch (tag) {
    case Tag::nil:
      return lua_pushnil(L);
    case Tag::no:
    case Tag::yes:
      return lua_pushboolean(L, tag == Tag::yes);
    case Tag::integer: {
      std::int64_t value = 0;
      archive(value);
      return lua_pushinteger(L, value);
    }
    case Tag::number: {
      double value = 0;
      archive(value);
      return lua_pushnumber(L, value);
    }
    case Tag::text: {
      std::string value;
      archive(value);
      lua_pushlstring(L, value.data(), value.size());
      return;
    }
    case Tag::vec3: {
      Vec3 value;
      archive(value);
      return push_vec3(L, value);
    }
    case Tag::table:
      return restore_table(L, archive);
  }
  throw Archive::Mismatch("saved ev.state holds an unknown kind of value");
}

}  // namespace lsos
