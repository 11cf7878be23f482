// One Lua state, and the only ways into it: load text, call a script, run our own code protected.
#pragma once

#include <functional>
#include <lua.hpp>
#include <memory>
#include <optional>
#include <string>

#include "lua/runtime/context.h"
#include "mission/port/equipment_fault.h"

namespace lsos {

class LuaState {
 public:
  // `make_libraries` makes what its scripts can reach, see make_api().
  explicit LuaState(void (*make_libraries)(lua_State*), const Limits& limits = {});
  ~LuaState();
  LuaState(const LuaState&) = delete;
  LuaState& operator=(const LuaState&) = delete;

  LuaContext& context() { return *context_; }

  // Runs our own code where Lua may raise errors. What `body` throws arrives here unchanged; a
  // Lua error that `body` lets out arrives as InternalError. Leaves the stack as it was.
  void run(const std::function<void(lua_State*)>& body);

 private:
  std::unique_ptr<LuaContext> context_;
  lua_State* L_ = nullptr;
};

// A script that broke. `message` begins with "file:line: " where Lua knows the place.
struct LuaFailure {
  std::string message;
  std::string traceback;  // "stack traceback:\n..."
};

// Compiles `source` (text only) and pushes the function; `file` is shown in messages. On a syntax
// error pushes nothing.
std::optional<LuaFailure> load_text(lua_State* L, const std::string& source,
                                    const std::string& file);

// Calls the script function below its arguments, with fresh budgets. Pops both; pushes the results
// if the call went well. Throws only what our own broken promises throw. The call may take a share
// of what the limits allow.
std::optional<LuaFailure> call_script(lua_State* L, int argument_count, int result_count,
                                      double share = 1);

// Says that the memory is spent, with the place where the allocator last refused.
void note_memory_spent(lua_State* L);

// The error value at `index` as text; other than strings are named by type.
std::string error_text(lua_State* L, int index);

// Splits "file:line: what". The place is the whole `file` when the message has none.
std::pair<Place, std::string> split_place(const std::string& message, const std::string& file);

// Where the script function is that called the running C function; line 0 when unknown.
Place caller_place(lua_State* L);
// In which line of its file the function at the top begins.
int definition_line(lua_State* L);

[[noreturn]] void raise_error(lua_State* L, const std::string& message);
void keep_internal_error(lua_State* L);

// A call of one of our functions costs about as much.
inline constexpr std::int64_t instructions_per_call = 10;

// What is registered with Lua goes through this: a C++ exception becomes a Lua error with the
// script's place. It catches std::exception only, since Lua's own errors are C++ exceptions too,
// and raises after the catch block is left.
template <int (*function)(lua_State*)>
int guard(lua_State* L) {
  charge(L, instructions_per_call);
  std::string message;
  try {
    return function(L);
  } catch (const InternalError& error) {
    message = error.what();
    keep_internal_error(L);
  } catch (const EquipmentFault& error) {
    message = error.what();
    context(L).equipment_fault = message;
  } catch (const std::exception& error) {
    message = error.what();
  }
  raise_error(L, message);
}

}  // namespace lsos
