// Context of the C++ functions that scripts call; one for each lua_State.
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

// Budgets of scripts. The instructions are counted per call, and long work inside C functions is
// charged to them too; the memory is that of the whole state. The processor time is a last resort:
// only instructions that take a hundred times as long as others, such as % of numbers far apart,
// exhaust it first. It does not count the engine's work for a script, such as planning or
// generating ground and sky.
struct Limits {
  std::int64_t instructions = 3'000'000;
  std::size_t memory_bytes = std::size_t{256} << 20;
  double cpu_s = 0.5;
  double compile_cpu_s = 1;  // of one text, likewise
};

// Bytes that one call may allocate per instruction of its budget, kept or not.
inline constexpr std::int64_t bytes_per_instruction = 40;

// Notes that one phase call may write into the log.
inline constexpr int notes_max = 1000;
inline constexpr std::size_t note_bytes_max = std::size_t{1} << 20;

// The phase call that is running.
struct EventCall {
  const EventDeclaration& declaration;
  const EventArguments& arguments;
  ScriptInstance instance;
  PhaseContext& phase;
  std::optional<RandomStream>& random;  // created at its first use
};

// Rovers of an interactive simulation, which a script may query and command though no phase of
// theirs runs. Their handles have ids below 0.
class InteractiveRovers {
 public:
  virtual ~InteractiveRovers() = default;
  virtual RoverPort& rover(ScriptInstance handle) = 0;
  // Prints a line of `print` or `help`.
  virtual void say(const std::string& text) = 0;
};

struct LuaContext {
  explicit LuaContext(const Limits& given) : limits(given), memory(given.memory_bytes) {}

  Limits limits;
  ScriptMemory memory;
  // Whether a script's call is running; otherwise nothing is charged.
  bool is_charging = false;
  std::int64_t instructions_max = 0, instructions_left = 0;  // of the call
  std::int64_t instructions_of_calls = 0;                    // that have ended, together
  std::optional<double> cpu_end_s;  // of the call, by cpu_now_s(); set at the first check
  // Notes that the call has written into the log.
  int notes = 0;
  std::size_t note_bytes = 0;
  // Set at a prompt: whether the user wants the running script to stop.
  bool (*is_stop_wanted)() = nullptr;

  // Set when a budget is spent: the message, with the script's line. No script may catch this
  // error.
  std::string spent;

  // A C++ exception that travels through Lua as an error and is no fault of the script.
  std::exception_ptr internal_error;
  // Traceback of the last call that failed.
  std::string traceback;
  // Message of the call's last EquipmentFault, which travels through Lua as an error.
  std::optional<std::string> equipment_fault;

  Faults* load_faults = nullptr;    // while a script loads
  int scripts_loaded = 0;           // numbers them as owners of texts
  const Script* loading = nullptr;  // the same; what it requires or is derived from is not loading
  // Scripts that the one that loads may use; nullptr for none.
  const std::vector<Script>* scripts = nullptr;
  // Scripts of lib/ that are running, and those that the last script that loaded has required.
  std::vector<std::string> requiring;
  std::set<std::string> required;
  // The bases whose scripts are running, and the bases that have run since the set was last
  // cleared.
  std::vector<std::string> deriving;
  std::set<std::string> bases;
  std::vector<std::string> doubts;                  // changes that are likely to be mistakes
  const EventCall* call = nullptr;                  // while a phase runs
  InteractiveRovers* interactive_rovers = nullptr;  // at a prompt or in a scenario
};

LuaContext& context(lua_State* L);

// Processor time of this thread, s.
double cpu_now_s();

// Marks work of the engine for a script, such as planning or generating ground, which does not
// count against the script's processor time.
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

// The running phase call. Throws std::runtime_error that names `what` when there is none.
const EventCall& running_call(lua_State* L, const char* what);

// Takes `instructions` off the budget for work that no count hook sees. Raises an error when the
// budget is spent.
void charge(lua_State* L, std::int64_t instructions);
// Charges for handling `bytes` bytes in C.
void charge_bytes(lua_State* L, std::size_t bytes);

// Writes a note of the running phase into the log. Throws std::runtime_error beyond the number and
// size that one call may write.
void write_note(lua_State* L, const EventCall& call, const std::string& name,
                const std::string& fields_json);

}  // namespace lsos
