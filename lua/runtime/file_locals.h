// What the functions of a script's file reach and could change: its locals, the tables and
// iterators in them, and what those lead to. All events of a type would share it and no mission
// saves it, so a phase may read but not change it.
#pragma once

#include <lua.hpp>
#include <string>
#include <unordered_set>
#include <vector>

#include "lua/runtime/exact_value.h"

namespace lsos {

class FileLocals {
 public:
  // Restores what was recorded. Returns what was done to it, for a message: "changed 'count', a
  // local of the file"; locals come before tables, by bytes. "" when it was all as recorded.
  std::string restore(lua_State* L) const;

  // Whether the table with this address is one of the file's.
  bool has(const void* table) const { return addresses_.contains(table); }

 private:
  friend class FileWalk;  // records (file_walk.h)

  // A variable of a function. It lies in the kept table at `value`, its function at `function`.
  struct Variable {
    std::string name;
    bool is_of_iterator = false;  // what an iterator keeps, then named by the local that holds it
    int upvalue = 0;
    lua_Integer function = 0, value = 0;
    ExactValue exact = {};
  };
  // A table lies in the kept table at `at`; then come a copy of it and its metatable or nil.
  struct Table {
    std::string name;
    lua_Integer at = 0;
    std::size_t first = 0, count = 0;  // of its entries
    ExactValue metatable = {};
  };
  struct Entry {
    ExactValue key, value;
  };

  std::string restore_variables(lua_State* L, int kept) const;
  std::string restore_tables(lua_State* L, int kept) const;
  bool is_untouched(lua_State* L, int table, const Table& known) const;

  // Those of one function stand together.
  std::vector<Variable> variables_;
  std::vector<Table> tables_;
  std::vector<Entry> entries_;  // in the order in which Lua goes through the tables
  std::unordered_set<const void*> addresses_;
  int kept_ = LUA_NOREF;  // registry reference
};

}  // namespace lsos
