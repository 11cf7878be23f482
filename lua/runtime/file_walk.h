// The walk through all that the functions of a script's file reach, which FileLocals records.
#pragma once

#include <limits>
#include <unordered_map>

#include "base/error.h"
#include "lua/runtime/file_locals.h"

namespace lsos {

// Records what the functions in the table at `index` reach. That table and those in it, two deep,
// are the engine's own, which no script can change. What cannot be watched is a fault: of the
// script that has its constructor at `place`, or with the line of a function that reaches it.
FileLocals record_locals(lua_State* L, int index, const Place& place, Faults& faults);

class FileWalk {
 public:
  FileWalk(lua_State* L, FileLocals& into) : L_(L), into_(into) {}
  void record(int functions, const Place& place, Faults& faults);

 private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  // A function or table that was met, by its position in the kept table.
  struct Node {
    lua_Integer at = 0;
    bool is_function = false;
    std::vector<std::size_t> parts = {};  // nodes that it leads to, without locals of functions
    std::string name = {};                // of the local through which it is reached
    Place place = {};                     // of a function that has this local
    std::size_t table = none;             // number in FileLocals::tables_
  };
  // The local variable of a Lua function, and what it holds.
  struct Local {
    std::string name;
    Place place;
    std::size_t holds = none;
  };
  // A whole number that a table has as a key, without the one before it.
  struct Hole {
    std::size_t node = 0;
    lua_Integer absent = 0, found = 0;
  };

  // Puts the value at the top into the kept table; pops it.
  lua_Integer keep();
  // Adds the value at the top if it is something that can change, and pops it. Returns the number
  // of its node.
  std::size_t add();
  // Adds the functions in the engine's table at the top, which stays.
  void add_engine_table(int deep);
  void visit_function(std::size_t node);
  void visit_table(std::size_t node);
  void add_entries(std::size_t node, int table, int copy);
  void name_nodes();
  void add_hole_fault(Faults& faults);

  lua_State* L_;
  FileLocals& into_;
  int kept_ = 0;
  lua_Integer kept_count_ = 0;
  std::size_t values_ = 0;
  std::vector<Node> nodes_;
  std::unordered_map<const void*, std::size_t> known_;         // nodes by address; look-up only
  std::unordered_map<const void*, std::size_t> locals_by_id_;  // the same
  std::vector<Local> locals_;
  std::vector<std::size_t> iterators_;  // node of the iterator of each variable, or none
  std::vector<Hole> holes_;
};

}  // namespace lsos
