// Memory of the scripts of one Lua state: the state's allocator, and the times at which garbage is
// collected. Both depend only on what scripts do, so that a script fails at the same place in each
// run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <lua.hpp>
#include <unordered_map>

namespace lsos {

class ScriptMemory {
 public:
  explicit ScriptMemory(std::size_t bytes_max) : bytes_max_(bytes_max) {}
  ScriptMemory(const ScriptMemory&) = delete;
  ScriptMemory& operator=(const ScriptMemory&) = delete;

  // The lua_Alloc of the state; `self` is the ScriptMemory.
  static void* allocate(void* self, void* block, std::size_t old_size, std::size_t new_size);

  // From here on allocations count towards the call, and a refusal is final until end_call(): no
  // script can then observe Lua's own emergency collection, whose timing is not under control. A
  // phase does not count what earlier calls of phases left, as a resumed mission does not have it.
  void begin_call(lua_State* L, std::size_t traffic_max, bool is_phase);
  void end_call();

  // Limit for which the allocator refused in this call: "memory", "traffic" or "stack"; nullptr
  // when it did not refuse.
  const char* refusal() const { return refusal_; }
  // Place of the refusal: "file:line: ".
  const char* refused_at() const { return refused_at_; }

  // Sets whose texts are made and used from here on, a script's number; 0: everybody's. Long texts
  // of other scripts cannot be reached from it and make its instructions no dearer.
  void set_owner(int owner) { owner_ = owner; }
  int owner() const { return owner_; }

  // What is in use now, after a collection.
  std::size_t kept_bytes(lua_State* L);
  std::size_t bytes() const { return bytes_; }
  std::size_t bytes_max() const { return bytes_max_; }
  std::size_t traffic_max() const { return traffic_max_; }

  // Greatest cost of one instruction at present, as a multiple of the usual cost: comparing long
  // texts, passing many values and going through a chain of metatables are single instructions.
  std::int64_t weight() const;
  // Instructions between two calls of the count hook: fewer while there are long texts, as two of
  // them may be compared byte by byte.
  int hook_interval() const;

  // Collects garbage when enough has been allocated since the last time; returns the cost in
  // instructions. Lua's collector never runs by itself.
  std::int64_t collect_if_due(lua_State* L);

  // Records the metatable at the top, so that a '__mode' in it is hidden from the collector.
  // Scripts may not have weak tables, whose contents depend on the collector, but can add '__mode'
  // to a metatable after setmetatable has checked it.
  void note_metatable(lua_State* L);

 private:
  void* grow(void* block, std::size_t old_size, std::size_t new_size, bool is_text);
  void refuse(const char* why);
  void shorten_hook_interval();
  void collect(lua_State* L);

  std::size_t bytes_max_;
  std::size_t bytes_ = 0;
  std::size_t collected_to_ = 0;  // bytes left after the last collection
  std::size_t since_collected_ = 0;
  std::size_t traffic_ = 0, traffic_max_ = 0;
  bool is_in_call_ = false;
  const char* refusal_ = nullptr;
  char refused_at_[160] = "";
  lua_State* L_ = nullptr;

  // Lua's stack is the second block of a new state; its size shows how many values one call passes.
  int blocks_made_ = 0;
  void* stack_ = nullptr;
  std::size_t stack_bytes_ = 0;
  void* newest_ = nullptr;  // the last block allocated
  std::size_t newest_bytes_ = 0;

  std::size_t metatables_ = 0;       // of scripts
  std::size_t metatables_kept_ = 0;  // those not made by phases
  bool is_phase_ = false;

  struct LongText {
    std::size_t bytes = 0;
    int owner = 0;
  };
  std::unordered_map<const void*, LongText> long_texts_;  // by block; order is never used
  int owner_ = 0;
  bool has_new_long_text_ = false;
  std::size_t longest_text_ = 0;  // of the texts that existed in this call
};

// Scope in which texts are those of one script.
class TextOwner {
 public:
  TextOwner(ScriptMemory& memory, int owner) : memory_(memory), before_(memory.owner()) {
    memory_.set_owner(owner);
  }
  ~TextOwner() { memory_.set_owner(before_); }
  TextOwner(const TextOwner&) = delete;
  TextOwner& operator=(const TextOwner&) = delete;

 private:
  ScriptMemory& memory_;
  int before_;
};

// Writes the place of the innermost script function, "file:line: " or "", without allocating.
void write_place(lua_State* L, char* text, std::size_t size);

}  // namespace lsos
