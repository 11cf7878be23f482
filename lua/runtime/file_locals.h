// Locals of a script's file that its functions share. All events of a type would have them together
// and no mission saves them, so a phase may read them but not keep anything there.
#pragma once

#include <lua.hpp>
#include <set>
#include <string>
#include <vector>

namespace lsos {

class FileLocals {
 public:
  FileLocals() = default;
  // Those that the functions in the table at `index`, and in tables in it, can reach; as they are
  // now. Of a script that has more than anybody writes, the first.
  FileLocals(lua_State* L, int index);

  // Makes all what they were again, with what tables hold. Name of one that was not, locals before
  // tables, by bytes; "" when all were.
  std::string restore(lua_State* L) const;

 private:
  std::string restore_locals(lua_State* L) const;
  std::string restore_tables(lua_State* L) const;
  // Moves the value at the top into the kept table, behind its owner at index `owner`; answers the
  // owner's place there.
  lua_Integer keep(lua_State* L, int kept, int owner);
  // Adds the table at the top, and the tables in it; leaves it there.
  void add_table(lua_State* L, int kept, const char* name, int deep);

  struct Local {
    std::string name;
    int upvalue;           // of the function
    lua_Integer function;  // in the kept table; its value is the next
  };
  struct Table {
    std::string name;  // of the local through which it is reached
    lua_Integer at;    // in the kept table; the next is a copy, then comes its metatable or nil
    std::size_t entries;
  };
  std::vector<Local> locals_;
  std::vector<Table> tables_;
  std::set<const void*> seen_;  // tables
  std::size_t entries_ = 0;     // of all tables
  lua_Integer kept_count_ = 0;  // places in the kept table
  int kept_ = LUA_NOREF;        // registry reference
};

}  // namespace lsos
