// What our C functions must know of the world they are called in; one a lua_State.
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <string>

#include "base/error.h"
#include "base/random.h"
#include "mission/script_host.h"

struct lua_State;

namespace lsos {

// What scripts may use up. The budget of instructions is per call and also pays for long work
// inside C functions; the memory is that of the whole state.
struct Limits {
  std::int64_t instructions = 10'000'000;
  std::size_t memory_bytes = std::size_t{256} << 20;
};

// The phase call that is going on.
struct EventCall {
  const EventDeclaration& declaration;
  const EventArguments& arguments;
  ScriptInstance instance;
  PhaseContext& phase;
  std::optional<RandomStream>& random;  // made at its first use
};

// Rovers of a simulation that a script has in hand: they may be asked and told things though no
// phase of theirs runs. Their handles have ids below 0.
class RoversInHand {
 public:
  virtual ~RoversInHand() = default;
  virtual RoverPort& rover(ScriptInstance handle) = 0;
  // A line of `print` or `help`.
  virtual void say(const std::string& text) = 0;
};

struct LuaContext {
  Limits limits;
  std::size_t memory_bytes = 0;
  std::int64_t instructions_left = 0;

  // Set when a budget is spent: the message, with the script's line. No script may catch that.
  std::string spent;
  // Where the allocator last refused ("file:line: "); the error itself carries no position.
  char refused_at[160] = "";
  lua_State* L = nullptr;

  // A fault of ours that travels through Lua as an error.
  std::exception_ptr internal_error;
  // Of the call that failed last.
  std::string traceback;

  Faults* load_faults = nullptr;    // while a script loads
  const EventCall* call = nullptr;  // while a phase runs
  RoversInHand* in_hand = nullptr;  // of a prompt or a scenario
};

LuaContext& context(lua_State* L);

// The running phase call. Throws std::runtime_error naming `what` when there is none.
const EventCall& running_call(lua_State* L, const char* what);

// Takes `instructions` off the budget for work that no count hook sees. Raises when it is spent.
void charge(lua_State* L, std::int64_t instructions);

}  // namespace lsos
