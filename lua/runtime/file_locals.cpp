#include "lua/runtime/file_locals.h"

#include <fmt/format.h>

namespace lsos {

namespace {

// Sets the metatable of the table at `index` to the one at the top, or to none for nil; pops it. A
// '__gc' that was added to the metatable since is hidden from Lua: it would run without a budget.
void set_metatable_of(lua_State* L, int index) {
  if (!lua_istable(L, -1)) {
    lua_setmetatable(L, index);
    return;
  }
  const int metatable = lua_gettop(L);
  const auto set_gc = [&](int value) {
    lua_pushliteral(L, "__gc");
    lua_pushvalue(L, value);
    lua_rawset(L, metatable);
  };
  lua_pushliteral(L, "__gc");
  lua_rawget(L, metatable);
  lua_pushnil(L);
  set_gc(metatable + 2);
  lua_pushvalue(L, metatable);
  lua_setmetatable(L, index);
  set_gc(metatable + 1);
  lua_settop(L, metatable - 1);
}

void push_metatable_of(lua_State* L, int index) {
  if (lua_getmetatable(L, index) == 0) lua_pushnil(L);
}

// Whether the table has the entries of its copy, in whatever order. Lua's order changes when an
// entry was added and removed again.
bool has_entries_of(lua_State* L, int table, int copy, std::size_t count) {
  const int top = lua_gettop(L);
  std::size_t found = 0;
  bool is_same = true;
  for (lua_pushnil(L); is_same && lua_next(L, table) != 0; lua_pop(L, 1)) {
    lua_pushvalue(L, -2);
    lua_rawget(L, copy);
    is_same = are_exactly_equal(L, -1, -2) && ++found <= count;
    lua_pop(L, 1);
  }
  lua_settop(L, top);
  return is_same && found == count;
}

// Makes the entries of the table those of its copy.
void restore_entries(lua_State* L, int table, int copy) {
  for (lua_pushnil(L); lua_next(L, table) != 0;) {
    lua_pop(L, 1);
    lua_pushvalue(L, -1);
    lua_pushnil(L);
    lua_rawset(L, table);
  }
  for (lua_pushnil(L); lua_next(L, copy) != 0; lua_pop(L, 1)) {
    lua_pushvalue(L, -2);
    lua_pushvalue(L, -2);
    lua_rawset(L, table);
  }
}

void note_least(std::string& least, const std::string& text) {
  if (least.empty() || text < least) least = text;
}

}  // namespace

std::string FileLocals::restore(lua_State* L) const {
  if (variables_.empty() && tables_.empty()) return {};
  const int top = lua_gettop(L);
  luaL_checkstack(L, 12, nullptr);
  lua_rawgeti(L, LUA_REGISTRYINDEX, kept_);
  const std::string changed = restore_variables(L, top + 1);
  const std::string changed_table = restore_tables(L, top + 1);
  lua_settop(L, top);
  return changed.empty() ? changed_table : changed;
}

std::string FileLocals::restore_variables(lua_State* L, int kept) const {
  std::string changed;
  lua_Integer at = 0;
  for (const Variable& variable : variables_) {
    if (variable.function != at) {
      at = variable.function;
      lua_settop(L, kept);
      lua_rawgeti(L, kept, at);
    }
    lua_getupvalue(L, kept + 1, variable.upvalue);
    if (exact_value(L, -1) == variable.exact) {
      lua_pop(L, 1);
      continue;
    }
    lua_rawgeti(L, kept, variable.value);
    if (!are_exactly_equal(L, -1, -2)) {
      note_least(changed,
                 variable.is_of_iterator
                     ? fmt::format("called '{}', an iterator in a local of the file", variable.name)
                     : fmt::format("changed '{}', a local of the file", variable.name));
      lua_setupvalue(L, kept + 1, variable.upvalue);
    }
    lua_settop(L, kept + 1);
  }
  lua_settop(L, kept);
  return changed;
}

// Whether the table is as recorded, in Lua's order of its entries too. A cheap test, which nearly
// every table passes: no entry is looked up.
bool FileLocals::is_untouched(lua_State* L, int table, const Table& known) const {
  const Entry* entry = entries_.data() + known.first;
  const Entry* const end = entry + known.count;
  for (lua_pushnil(L); lua_next(L, table) != 0; lua_pop(L, 1), ++entry) {
    if (entry != end && exact_value(L, -2) == entry->key && exact_value(L, -1) == entry->value) {
      continue;
    }
    lua_pop(L, 2);
    return false;
  }
  if (entry != end) return false;
  if (lua_getmetatable(L, table) == 0) return known.metatable == ExactValue{};
  const bool is_same = exact_value(L, -1) == known.metatable;
  lua_pop(L, 1);
  return is_same;
}

std::string FileLocals::restore_tables(lua_State* L, int kept) const {
  const int table = kept + 1, copy = kept + 2;
  std::string changed;
  for (const Table& known : tables_) {
    lua_rawgeti(L, kept, known.at);
    if (!is_untouched(L, table, known)) {
      lua_rawgeti(L, kept, known.at + 1);
      push_metatable_of(L, table);
      const bool is_same = exact_value(L, -1) == known.metatable;
      if (!is_same || !has_entries_of(L, table, copy, known.count)) {
        note_least(changed, fmt::format("changed '{}', a local of the file", known.name));
        restore_entries(L, table, copy);
        lua_rawgeti(L, kept, known.at + 2);
        set_metatable_of(L, table);
      }
    }
    lua_settop(L, kept);
  }
  return changed;
}

}  // namespace lsos
