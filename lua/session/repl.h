// The prompt: lines of Lua with a simulation in hand.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "lua/runtime/state.h"
#include "lua/session/sims.h"

namespace lsos {

class Repl {
 public:
  // `plan_file`: what `sim` is of; "": `sim` is made by lsos.sim {...}. `say` prints lines. Throws
  // InputError.
  Repl(const std::string& plan_file, const std::string& folder,
       std::function<void(const std::string&)> say);

  enum class Outcome { done, incomplete, failed, ended };
  // Runs a piece of text that begins in that line; says what an expression gives, or what is wrong.
  // Incomplete: more lines belong to it. Ended: it is the word that leaves the prompt.
  Outcome run(const std::string& text, int line = 1);

  // What the name at the end of `text` may go on as, whole: "sim.ro" to "sim.rovers".
  std::vector<std::string> completions(const std::string& text);

 private:
  Outcome run_in(lua_State* L, const std::string& text, int line);
  std::string local_hint(const std::string& message) const;

  std::function<void(const std::string&)> say_;
  LuaState lua_;
  Sims sims_;
  int environment_ = LUA_NOREF;
  std::set<std::string> locals_;  // names that earlier lines made local
};

}  // namespace lsos
