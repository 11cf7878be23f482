// Local variables of a script's file that its functions share. All events of a type would share
// them and no mission saves them, so a phase may read but not change them.
#pragma once

#include <lua.hpp>
#include <set>
#include <string>
#include <vector>

namespace lsos {

class FileLocals {
 public:
  FileLocals() = default;
  // Records the present values of the locals that the functions in the table at `index`, and in
  // tables in it, can reach. The numbers of functions, locals and entries are limited
  // (file_locals.cpp): of a script with more, only the first are recorded.
  FileLocals(lua_State* L, int index);

  // Restores the recorded values, with the contents of tables. Returns the name of one that had
  // changed, locals before tables, by bytes; "" when none had.
  std::string restore(lua_State* L) const;

 private:
  std::string restore_locals(lua_State* L) const;
  std::string restore_tables(lua_State* L) const;
  // Moves the value at the top into the kept table, behind its owner at index `owner`. Returns the
  // owner's position there.
  lua_Integer keep(lua_State* L, int kept, int owner);
  // Records the table at the top, and the tables in it; leaves it there.
  void add_table(lua_State* L, int kept, const char* name, int deep);

  struct Local {
    std::string name;
    int upvalue;           // number of the function's upvalue
    lua_Integer function;  // position in the kept table; its value is the next
  };
  struct Table {
    std::string name;  // name of the local through which it is reached
    lua_Integer at;    // position in the kept table; then come a copy and its metatable or nil
    std::size_t entries;
  };
  std::vector<Local> locals_;
  std::vector<Table> tables_;
  std::set<const void*> seen_;  // tables
  std::size_t entries_ = 0;     // of all tables
  lua_Integer kept_count_ = 0;  // entries of the kept table
  int kept_ = LUA_NOREF;        // registry reference
};

}  // namespace lsos
