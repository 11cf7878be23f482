#include "lua/runtime/value.h"

#include <fmt/format.h>

#include <string_view>
#include <unordered_set>

#include "base/utf8.h"
#include "lua/runtime/constructed_value.h"
#include "lua/runtime/sorted_keys.h"
#include "lua/runtime/vec3.h"

namespace lsos {

namespace {

constexpr int value_depth_max = 100;

enum class Tag : std::uint8_t { nil, no, yes, integer, number, text, vec3, table };
constexpr Tag last_value(Tag) { return Tag::table; }

// Path of a value: a key or a list index within its parent. Its text is built only for messages, as
// most values are sound.
struct Path {
  const Path* around = nullptr;
  std::string_view key;  // for the root: its name
  std::int64_t number = 0;

  std::string text() const {
    constexpr std::size_t key_bytes_max = 60;
    if (around == nullptr) return std::string(key);
    if (number != 0) return fmt::format("{}[{}]", around->text(), number);
    return fmt::format("{}.{}{}", around->text(), beginning(key, key_bytes_max),
                       key.size() > key_bytes_max ? "..." : "");
  }
};

class Saver {
 public:
  Saver(lua_State* state, Archive& archive, const FileLocals& file)
      : L_(state), archive_(archive), file_(file), bytes_before_(archive.bytes().size()) {}

  bool comes_back_different() const { return comes_back_different_; }

  void value(int index, const Path& path, int depth) {
    switch (lua_type(L_, index)) {
      case LUA_TNIL:
        tag(Tag::nil);
        break;
      case LUA_TBOOLEAN:
        tag(lua_toboolean(L_, index) != 0 ? Tag::yes : Tag::no);
        break;
      case LUA_TNUMBER:
        number(index);
        break;
      case LUA_TSTRING:
        tag(Tag::text);
        text(index);
        break;
      case LUA_TTABLE:
        table(index, path, depth);
        break;
      default:
        throw std::runtime_error(
            fmt::format("{}: {} cannot be saved", path.text(), describe(L_, index)));
    }
    check_size(path, archive_.bytes().size());
  }

 private:
  void tag(Tag tag) { archive_(tag); }

  // Throws where the bytes written, or certain to be written, are too many.
  void check_size(const Path& path, std::size_t bytes) const {
    if (bytes - bytes_before_ <= state_bytes_max) return;
    const Path* whole = &path;
    while (whole->around != nullptr) whole = whole->around;
    throw std::runtime_error(fmt::format("{} takes more than {} KiB, at {}", whole->text(),
                                         state_bytes_max >> 10, path.text()));
  }

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

  void check_table(int index, const Path& path, int depth) {
    if (depth > value_depth_max) {
      throw std::runtime_error(
          fmt::format("{}: nested deeper than {}", path.text(), value_depth_max));
    }
    const void* table = lua_topointer(L_, index);
    if (!seen_.insert(table).second) fail_twice(path, table);
    comes_back_different_ |= file_.has(table);
  }

  [[noreturn]] void fail_twice(const Path& path, const void* table) {
    const Path* whole = &path;
    while (whole->around != nullptr) whole = whole->around;
    throw std::runtime_error(
        fmt::format("{} is the same table as {}; save a copy, as they would come back apart",
                    path.text(), first_path(whole_index_, *whole, table)));
  }

  // Path at which the saver first met `table`. It walks in the saver's order, through tables that
  // the saver has seen.
  std::string first_path(int index, const Path& path, const void* table) {
    if (lua_topointer(L_, index) == table) return path.text();
    std::string found;
    luaL_checkstack(L_, 6, "nested too deep");
    index = lua_absindex(L_, index);
    const auto length = static_cast<std::int64_t>(lua_rawlen(L_, index));
    const auto look = [&](const Path& at) {
      if (lua_istable(L_, -1) && seen_.contains(lua_topointer(L_, -1))) {
        found = first_path(lua_gettop(L_), at, table);
      }
    };
    for (lua_Integer i = 1; i <= length && found.empty(); ++i, lua_pop(L_, 1)) {
      lua_rawgeti(L_, index, i);
      look({&path, {}, i});
    }
    if (!found.empty()) return found;
    push_sorted_keys(L_, index);
    const auto key_count = static_cast<std::int64_t>(lua_rawlen(L_, -1));
    for (lua_Integer i = length + 1; i <= key_count && found.empty(); ++i, lua_pop(L_, 2)) {
      lua_rawgeti(L_, -1, i);
      const std::string_view key = view(-1);
      lua_pushvalue(L_, -1);
      lua_rawget(L_, index);
      look({&path, key});
    }
    lua_pop(L_, 1);
    return found;
  }

  std::string_view view(int index) {
    std::size_t size = 0;
    const char* bytes = lua_tolstring(L_, index, &size);
    return {bytes, size};
  }

  void table(int index, const Path& path, int depth) {
    index = lua_absindex(L_, index);
    if (depth == 0) whole_index_ = index;
    luaL_checkstack(L_, 6, "nested too deep");
    check_table(index, path, depth);
    if (is_vec3(L_, index)) return vec3(index, path);
    if (lua_getmetatable(L_, index) != 0) {
      throw std::runtime_error(
          fmt::format("{}: a table with a metatable cannot be saved", path.text()));
    }
    const auto length = static_cast<std::int64_t>(lua_rawlen(L_, index));
    tag(Tag::table);
    list(index, path, depth, length);
    fields(index, path, depth, length);
  }

  void vec3(int index, const Path& path) {
    std::optional<Vec3> v = to_vec3(L_, index, &comes_back_different_);
    if (!v) {
      throw std::runtime_error(fmt::format("{}: x, y, z must be finite numbers", path.text()));
    }
    tag(Tag::vec3);
    archive_(*v);
  }

  void list(int index, const Path& path, int depth, std::int64_t length) {
    archive_(length);
    for (lua_Integer i = 1; i <= length; ++i, lua_pop(L_, 1)) {
      const Path item{&path, {}, i};
      if (lua_rawgeti(L_, index, i) == LUA_TNIL) {
        throw std::runtime_error(fmt::format("{} is a hole: lists must be without", item.text()));
      }
      value(lua_gettop(L_), item, depth + 1);
    }
  }

  void fields(int index, const Path& path, int depth, std::int64_t length) {
    std::int64_t field_count = check_keys(index, path, length);
    archive_(field_count);
    if (field_count == 0) return;
    push_sorted_keys(L_, index);
    for (lua_Integer i = length + 1; i <= length + field_count; ++i, lua_pop(L_, 2)) {
      lua_rawgeti(L_, -1, i);
      text(-1);
      const Path field{&path, view(-1)};
      lua_pushvalue(L_, -1);
      lua_rawget(L_, index);
      value(lua_gettop(L_), field, depth + 1);
    }
    lua_pop(L_, 1);
  }

  // Checks that the keys are 1..length and texts; returns the number of texts.
  std::int64_t check_keys(int index, const Path& path, std::int64_t length) {
    constexpr std::size_t field_bytes_min = 10;  // its key's length, a tag, a letter
    std::int64_t count = 0;
    std::size_t bytes = archive_.bytes().size();
    lua_pushnil(L_);
    for (; lua_next(L_, index) != 0; lua_pop(L_, 1)) {
      if (lua_type(L_, -2) == LUA_TSTRING) {
        ++count;
        check_size(path, bytes += field_bytes_min);
        continue;
      }
      if (lua_isinteger(L_, -2) != 0) {
        const lua_Integer i = lua_tointeger(L_, -2);
        if (i >= 1 && i <= length) continue;
        throw std::runtime_error(
            fmt::format("{}[{}]: a list begins at 1 and has no holes; use text keys otherwise",
                        path.text(), i));
      }
      throw std::runtime_error(fmt::format("{}: {} as a key cannot be saved; keys are texts",
                                           path.text(), describe(L_, -2)));
    }
    return count;
  }

  lua_State* L_;
  Archive& archive_;
  const FileLocals& file_;
  bool comes_back_different_ = false;
  std::size_t bytes_before_;
  int whole_index_ = 0;
  // Tables met so far, by identity. The set is used for look-up only: addresses affect no result.
  std::unordered_set<const void*> seen_;
};

void restore_value(lua_State* L, Archive& archive, int depth);

void restore_table(lua_State* L, Archive& archive, int depth) {
  if (depth > value_depth_max) archive.refuse("saved ev.state is nested too deep");
  luaL_checkstack(L, 6, "nested too deep");
  std::int64_t length = 0;
  archive(length);
  lua_newtable(L);
  for (std::int64_t i = 1; i <= length; ++i) {
    restore_value(L, archive, depth + 1);
    lua_rawseti(L, -2, i);
  }
  std::int64_t field_count = 0;
  archive(field_count);
  for (std::int64_t i = 0; i < field_count; ++i) {
    std::string key;
    archive(key);
    lua_pushlstring(L, key.data(), key.size());
    restore_value(L, archive, depth + 1);
    lua_rawset(L, -3);
  }
}

void restore_value(lua_State* L, Archive& archive, int depth) {
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
      return restore_table(L, archive, depth);
  }
}

}  // namespace

bool save_value(lua_State* L, int index, const std::string& name, Archive& archive,
                const FileLocals& file) {
  Saver saver(L, archive, file);
  saver.value(lua_absindex(L, index), Path{nullptr, name}, 0);
  return saver.comes_back_different();
}

void restore_value(lua_State* L, Archive& archive) { restore_value(L, archive, 0); }

}  // namespace lsos
