// The prompt: runs lines of Lua with an interactive simulation.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "lua/runtime/state.h"
#include "lua/session/sim_sessions.h"

namespace lsos {

class Repl {
 public:
  // `plan_file`: the plan of `sim`; "": the user makes `sim` by lsos.sim {...}. `say` prints lines.
  // Throws InputError.
  Repl(const std::string& plan_file, const std::string& folder,
       std::function<void(const std::string&)> say);

  enum class Outcome { done, incomplete, failed, ended };
  // Runs a text that begins in line `line`; prints the values of expressions, or the error.
  // Incomplete: more lines belong to it. Ended: the text is the word that leaves the prompt.
  Outcome run(const std::string& text, int line = 1);

  // Completions of the name at the end of `text`, as whole names: "sim.rovers" for "sim.ro".
  std::vector<std::string> completions(const std::string& text);

 private:
  Outcome run_in(lua_State* L, const std::string& text, int line);
  std::string local_hint(const std::string& message) const;

  std::function<void(const std::string&)> say_;
  LuaState lua_;
  SimSessions sim_sessions_;
  int environment_ = LUA_NOREF;
  std::set<std::string> locals_;  // names that earlier lines made local
};

}  // namespace lsos
