// What our C functions must know of the world they are called in; one a lua_State.
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/random.h"
#include "lua/runtime/script.h"
#include "lua/runtime/script_memory.h"
#include "mission/port/script_host.h"

struct lua_State;

namespace lsos {

// What scripts may use up. The budget of instructions is per call and also pays for long work
// inside C functions; the memory is that of the whole state. The processor's time is a last resort:
// only instructions that take a hundred times as long as others, such as % of numbers far apart,
// spend it first. What the engine does for a script, planning and making ground and sky, is not
// counted there.
struct Limits {
  std::int64_t instructions = 3'000'000;
  std::size_t memory_bytes = std::size_t{256} << 20;
  double cpu_s = 0.5;
};

// What one call may allocate, whether it keeps it or not.
inline constexpr std::int64_t bytes_per_instruction = 40;

// What one phase call may write into the log.
inline constexpr int notes_max = 1000;
inline constexpr std::size_t note_bytes_max = std::size_t{1} << 20;

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
  explicit LuaContext(const Limits& given) : limits(given), memory(given.memory_bytes) {}

  Limits limits;
  ScriptMemory memory;
  // A script's call is going on; otherwise nothing is charged.
  bool is_charging = false;
  std::int64_t instructions_max = 0, instructions_left = 0;  // of the call
  std::optional<double> cpu_end_s;  // of the call, by cpu_now_s(); set at its first look
  // What the call has written into the log.
  int notes = 0;
  std::size_t note_bytes = 0;
  // Where there is one, of a prompt: whether the user wants what runs to stop.
  bool (*is_stop_wanted)() = nullptr;

  // Set when a budget is spent: the message, with the script's line. No script may catch that.
  std::string spent;

  // A fault of ours that travels through Lua as an error.
  std::exception_ptr internal_error;
  // Of the call that failed last.
  std::string traceback;
  // What the last EquipmentFault of the call said, which travels through Lua as an error.
  std::optional<std::string> equipment_fault;

  Faults* load_faults = nullptr;  // while a script loads
  // While scripts of rovers/ load: all that there are, the bases whose scripts run now, and those
  // that have run since this was last empty.
  const std::vector<Script>* scripts = nullptr;
  std::vector<std::string> deriving;
  std::set<std::string> bases;
  std::vector<std::string> doubts;  // changes that are likely to be slips
  const EventCall* call = nullptr;  // while a phase runs
  RoversInHand* in_hand = nullptr;  // of a prompt or a scenario
};

LuaContext& context(lua_State* L);

// Time that this thread has had of a processor.
double cpu_now_s();

// While it lives the engine works for a script, as long as that takes: planning, making ground.
class EngineWork {
 public:
  explicit EngineWork(lua_State* L) : context_(context(L)), begin_s_(cpu_now_s()) {}
  ~EngineWork() {
    if (context_.cpu_end_s) *context_.cpu_end_s += cpu_now_s() - begin_s_;
  }
  EngineWork(const EngineWork&) = delete;
  EngineWork& operator=(const EngineWork&) = delete;

 private:
  LuaContext& context_;
  double begin_s_;
};

// The running phase call. Throws std::runtime_error naming `what` when there is none.
const EventCall& running_call(lua_State* L, const char* what);

// Takes `instructions` off the budget for work that no count hook sees. Raises when it is spent.
void charge(lua_State* L, std::int64_t instructions);
// The same for handling that many bytes in C.
void charge_bytes(lua_State* L, std::size_t bytes);

// Writes a row of the phase that runs into the log's notes. Throws std::runtime_error beyond what
// one call may write.
void write_note(lua_State* L, const EventCall& call, const std::string& name,
                const std::string& fields_json);

}  // namespace lsos
