// A Lua state, and the only entries into it: load text, call a script, run C++ code protected.
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
  // Makes the sandbox and the lsos module; no script is loaded.
  explicit LuaState(void (*make_libraries)(lua_State*), const Limits& limits = {});
  ~LuaState();
  LuaState(const LuaState&) = delete;
  LuaState& operator=(const LuaState&) = delete;

  LuaContext& context() { return *context_; }

  // Runs C++ code in which Lua may raise errors. An exception of `body` is rethrown unchanged; a
  // Lua error that leaves `body` is thrown as InternalError. Leaves the stack as it was.
  void run(const std::function<void(lua_State*)>& body);

 private:
  std::unique_ptr<LuaContext> context_;
  lua_State* L_ = nullptr;
};

// Error of a script. `message` begins with "file:line: " where Lua knows the place.
struct LuaFailure {
  std::string message;
  std::string traceback;  // "stack traceback:\n..."
};

// Compiles `source` (text only) and pushes the function; `file` is shown in messages. On a syntax
// error nothing is pushed.
std::optional<LuaFailure> load_text(lua_State* L, const std::string& source,
                                    const std::string& file);

// Calls the script function below its arguments, with fresh budgets. Pops both; pushes the results
// if the call succeeds. Throws only for faults of the program itself. `share`: share of the limits
// that the call may use.
std::optional<LuaFailure> call_script(lua_State* L, int argument_count, int result_count,
                                      double share = 1);

// Records that the memory is spent, with the place where the allocator last refused.
void note_memory_spent(lua_State* L);

// The error value at `index` as text; a value that is no string is named by its type.
std::string error_text(lua_State* L, int index);

// Splits "file:line: what". The place is the whole `file` when the message has none.
std::pair<Place, std::string> split_place(const std::string& message, const std::string& file);

// Place of the script function that called the running C function; line 0 when unknown.
Place caller_place(lua_State* L);
// Line of its file in which the function at the top begins.
int definition_line(lua_State* L);

[[noreturn]] void raise_error(lua_State* L, const std::string& message);
void keep_internal_error(lua_State* L);

// Approximate cost of calling a C++ function.
inline constexpr std::int64_t instructions_per_call = 10;

// Wrapper of every function that is registered with Lua: it turns a C++ exception into a Lua error
// with the script's place. It catches std::exception only, since Lua's own errors are C++
// exceptions too, and raises the error after the catch block is left.
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
