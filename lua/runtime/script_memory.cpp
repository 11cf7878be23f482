#include "lua/runtime/script_memory.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace lsos {

namespace {

constexpr std::size_t mib = std::size_t{1} << 20;

// Shorter texts are compared in the time of a few instructions.
constexpr std::size_t long_text_bytes = 2048;
constexpr std::size_t text_bytes_per_weight = 1024;

constexpr std::size_t bytes_per_value = 16;
constexpr std::size_t stack_bytes_max = 25'000 * bytes_per_value;
constexpr std::size_t stack_spare_bytes = 5 * bytes_per_value;  // spare room in Lua's stack
constexpr std::size_t values_per_weight = 128;
constexpr std::size_t deep_stack_bytes = 4 * values_per_weight * bytes_per_value;

// One instruction can go through a chain of this many metatables by __index or __call.
constexpr std::size_t metatables_per_weight = 24;

// Cost of a block besides its bytes; and of the arrays of tables, whose keys are placed anew when
// they grow.
constexpr std::size_t bytes_per_block = 160;
constexpr std::size_t vector_factor = 4;

constexpr std::size_t collected_bytes_per_instruction = 32;

constexpr const char* metatables_key = "lsos.metatables";

}  // namespace

void write_place(lua_State* L, char* text, std::size_t size) {
  lua_Debug ar;
  text[0] = '\0';
  for (int level = 0; lua_getstack(L, level, &ar) == 1; ++level) {
    if (lua_getinfo(L, "Sl", &ar) == 0 || ar.currentline < 0) continue;
    std::snprintf(text, size, "%s:%d: ", ar.short_src, ar.currentline);
    return;
  }
}

void* ScriptMemory::allocate(void* self, void* block, std::size_t old_size, std::size_t new_size) {
  auto& memory = *static_cast<ScriptMemory*>(self);
  const bool is_text = block == nullptr && old_size == LUA_TSTRING;  // old_size is then the kind
  const bool is_vector = block == nullptr && old_size == 0;
  if (block == nullptr) old_size = 0;
  if (new_size == 0) {
    if (old_size > long_text_bytes) memory.long_texts_.erase(block);
    if (block != nullptr && block == memory.stack_) {  // Lua has moved its stack
      memory.stack_ = memory.newest_;
      memory.stack_bytes_ = memory.newest_bytes_;
    }
    std::free(block);
    memory.bytes_ -= old_size;
    return nullptr;
  }
  if (is_vector) memory.traffic_ += new_size * (vector_factor - 1);
  return memory.grow(block, old_size, new_size, is_text);
}

void* ScriptMemory::grow(void* block, std::size_t old_size, std::size_t new_size, bool is_text) {
  if (block == nullptr) ++blocks_made_;
  const bool is_stack = block == nullptr ? blocks_made_ == 2 : block == stack_;
  if (new_size > old_size) {
    if (is_in_call_ && refusal_ != nullptr) return nullptr;
    const char* why = nullptr;
    if (bytes_ - old_size + new_size > bytes_max_) why = "memory";
    // A block that moves costs its whole length, even when a table only rehashes its keys.
    if (is_in_call_ && traffic_ + new_size > traffic_max_) why = "traffic";
    // Lua doubles its stack by allocating a new block. An endless chain of __call does so within
    // one instruction, where no hook can intervene.
    const bool is_new_stack =
        block == nullptr && !is_text && new_size == 2 * stack_bytes_ - stack_spare_bytes;
    if (is_in_call_ && (is_stack || is_new_stack) && new_size > stack_bytes_max) why = "stack";
    if (why != nullptr) {
      refuse(why);
      return nullptr;
    }
  }
  void* moved = std::realloc(block, new_size);
  if (moved == nullptr) return nullptr;
  bytes_ += new_size - old_size;
  traffic_ += new_size + bytes_per_block;
  if (new_size > old_size) since_collected_ += new_size - old_size;
  if (block == nullptr) {
    newest_ = moved;
    newest_bytes_ = new_size;
  }
  if (is_stack) {
    stack_ = moved;
    stack_bytes_ = new_size;
  }
  if (is_text && new_size > long_text_bytes) {
    long_texts_[moved] = {new_size, owner_};
    longest_text_ = std::max(longest_text_, new_size);
    has_new_long_text_ = true;
    shorten_hook_interval();
  }
  return moved;
}

int ScriptMemory::hook_interval() const {
  constexpr std::size_t most = 1000, text_bytes = 32 << 10;
  return static_cast<int>(
      std::max<std::size_t>(1, most / std::max<std::size_t>(1, longest_text_ / text_bytes)));
}

void ScriptMemory::shorten_hook_interval() {
  if (!is_in_call_ || L_ == nullptr || lua_gethook(L_) == nullptr) return;
  if (hook_interval() < lua_gethookcount(L_)) {
    lua_sethook(L_, lua_gethook(L_), LUA_MASKCOUNT, hook_interval());
  }
}

void ScriptMemory::refuse(const char* why) {
  if (!is_in_call_) return;
  refusal_ = why;
  if (L_ != nullptr) write_place(L_, refused_at_, sizeof refused_at_);
}

void ScriptMemory::begin_call(lua_State* L, std::size_t traffic_max, bool is_phase) {
  L_ = L;
  // Neither garbage texts nor a stack that was once deep may count.
  if (has_new_long_text_ || stack_bytes_ > deep_stack_bytes) collect(L);
  collect_if_due(L);
  is_phase_ = is_phase;
  if (is_phase) metatables_ = metatables_kept_;
  has_new_long_text_ = false;
  longest_text_ = 0;
  for (const auto& [block, text] : long_texts_) {
    const bool is_reached = text.owner == 0 || text.owner == owner_;
    if (is_reached) longest_text_ = std::max(longest_text_, text.bytes);
  }
  refusal_ = nullptr;
  refused_at_[0] = '\0';
  traffic_ = 0;
  traffic_max_ = traffic_max;
  is_in_call_ = true;
}

void ScriptMemory::end_call() {
  is_in_call_ = false;
  if (!is_phase_) metatables_kept_ = metatables_;
}

std::int64_t ScriptMemory::weight() const {
  std::size_t weight = 1 + stack_bytes_ / bytes_per_value / values_per_weight;
  weight += longest_text_ / text_bytes_per_weight;
  const std::size_t chain = metatables_ / metatables_per_weight;
  weight += chain * chain;  // each __call moves all values before it
  return static_cast<std::int64_t>(weight);
}

std::size_t ScriptMemory::kept_bytes(lua_State* L) {
  collect(L);
  return bytes_;
}

std::int64_t ScriptMemory::collect_if_due(lua_State* L) {
  const std::size_t room = bytes_max_ - std::min(bytes_max_, collected_to_);
  const std::size_t due = std::max(mib, std::min(std::max(4 * mib, collected_to_), room / 2));
  if (since_collected_ < due) return 0;
  collect(L);
  return static_cast<std::int64_t>(bytes_ / collected_bytes_per_instruction);
}

void ScriptMemory::note_metatable(lua_State* L) {
  if (lua_getfield(L, LUA_REGISTRYINDEX, metatables_key) == LUA_TNIL) {
    lua_pop(L, 1);
    lua_newtable(L);
    lua_newtable(L);
    lua_pushliteral(L, "k");  // weak keys: keeps none of them alive
    lua_setfield(L, -2, "__mode");
    lua_setmetatable(L, -2);
    lua_pushvalue(L, -1);
    lua_setfield(L, LUA_REGISTRYINDEX, metatables_key);
  }
  lua_pushvalue(L, -2);
  if (lua_rawget(L, -2) == LUA_TNIL) {
    ++metatables_;
    lua_pushvalue(L, -3);
    lua_pushboolean(L, 1);
    lua_rawset(L, -4);
  }
  lua_pop(L, 2);
}

// Collects garbage with the '__mode' of scripts' metatables removed for the time of the collection.
void ScriptMemory::collect(lua_State* L) {
  const int top = lua_gettop(L);
  luaL_checkstack(L, 8, "memory");
  lua_newtable(L);  // maps metatables to their modes
  const int modes = lua_gettop(L);
  if (lua_getfield(L, LUA_REGISTRYINDEX, metatables_key) == LUA_TTABLE) {
    for (lua_pushnil(L); lua_next(L, modes + 1) != 0;) {
      lua_pop(L, 1);
      lua_pushliteral(L, "__mode");
      if (lua_rawget(L, -2) == LUA_TNIL) {
        lua_pop(L, 1);
        continue;
      }
      lua_pushvalue(L, -2);
      lua_insert(L, -2);
      lua_rawset(L, modes);
      lua_pushliteral(L, "__mode");
      lua_pushboolean(L, 0);  // no mode, but the key keeps its slot
      lua_rawset(L, -3);
    }
  }
  lua_settop(L, modes);
  lua_gc(L, LUA_GCCOLLECT, 0);
  for (lua_pushnil(L); lua_next(L, modes) != 0; lua_pop(L, 1)) {
    lua_pushliteral(L, "__mode");
    lua_pushvalue(L, -2);
    lua_rawset(L, -4);
  }
  metatables_ = 0;
  if (lua_getfield(L, LUA_REGISTRYINDEX, metatables_key) == LUA_TTABLE) {
    for (lua_pushnil(L); lua_next(L, modes + 1) != 0; lua_pop(L, 1)) ++metatables_;
  }
  lua_settop(L, top);
  since_collected_ = 0;
  collected_to_ = bytes_;
}

}  // namespace lsos
