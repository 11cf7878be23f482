// What the scripts of one Lua state take of memory: the state's allocator, and the moments at which
// it collects. They depend on what scripts do alone, so that a script fails at the same place in
// each run.
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

  // From here on what is allocated counts, and a refusal is final until end_call(): Lua's own
  // emergency collection, whose moment no rule of ours decides, can then be seen by no script. What
  // earlier calls of phases left does not count in one of a phase: a mission that was resumed does
  // not have it.
  void begin_call(lua_State* L, std::size_t traffic_max, bool is_phase);
  void end_call();

  // Why the allocator refused in this call, as "more than ..."; nullptr when it did not.
  const char* refusal() const { return refusal_; }
  // Where it did: "file:line: ".
  const char* refused_at() const { return refused_at_; }

  std::size_t bytes_max() const { return bytes_max_; }
  std::size_t traffic_max() const { return traffic_max_; }

  // How much more than usual one instruction can cost now: comparing long texts, passing on many
  // values and going through a chain of metatables are single instructions.
  std::int64_t weight() const;
  // Instructions between two looks of the count hook: fewer while there are long texts, of which
  // two may be compared byte by byte.
  int hook_interval() const;

  // Collects when enough has been allocated since it last was; answers what that cost, in
  // instructions. Lua's collector never runs by itself.
  std::int64_t collect_if_due(lua_State* L);

  // Scripts may not have weak tables, whose contents depend on the collector; but a metatable can
  // get its '__mode' after setmetatable has seen it. Notes the metatable at the top, so that the
  // collector does not see that either.
  void note_metatable(lua_State* L);

 private:
  void* grow(void* block, std::size_t old_size, std::size_t new_size, bool is_text);
  void refuse(const char* why);
  void look_more_often();
  void collect(lua_State* L);

  std::size_t bytes_max_;
  std::size_t bytes_ = 0;
  std::size_t collected_to_ = 0;  // bytes that were left
  std::size_t since_collected_ = 0;
  std::size_t traffic_ = 0, traffic_max_ = 0;
  bool is_in_call_ = false;
  const char* refusal_ = nullptr;
  char refused_at_[160] = "";
  lua_State* L_ = nullptr;

  // Lua's stack is the second block of a new state; it tells how many values one call passes on.
  int blocks_made_ = 0;
  void* stack_ = nullptr;
  std::size_t stack_bytes_ = 0;
  void* newest_ = nullptr;  // block that was made last
  std::size_t newest_bytes_ = 0;

  std::size_t metatables_ = 0;       // of scripts
  std::size_t metatables_kept_ = 0;  // not made by phases
  bool is_phase_ = false;

  std::unordered_map<const void*, std::size_t> long_texts_;  // bytes by block; looked up only
  bool has_new_long_text_ = false;
  std::size_t longest_text_ = 0;  // of those that were there in this call
};

// Writes the place of the innermost script function, "file:line: " or "", without allocating.
void write_place(lua_State* L, char* text, std::size_t size);

}  // namespace lsos
