// Locals of a script's file that its functions share. All events of a type would have them together
// and no mission saves them, so a phase may read them but not keep anything there.
#pragma once

#include <lua.hpp>
#include <string>
#include <vector>

namespace lsos {

class FileLocals {
 public:
  FileLocals() = default;
  // Numbers, texts, booleans and nils that the functions in the table at `index`, and in tables in
  // it, can reach; as they are now. Of a script that has more than anybody writes, the first.
  FileLocals(lua_State* L, int index);

  // Makes all what they were again. Name of one that was not, the first by bytes; "" when all were.
  std::string restore(lua_State* L) const;

 private:
  struct Local {
    std::string name;
    int upvalue;           // of the function
    lua_Integer function;  // in the kept table; its value is the next
  };
  std::vector<Local> locals_;
  int kept_ = LUA_NOREF;  // registry reference
};

}  // namespace lsos
