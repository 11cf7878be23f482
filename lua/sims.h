// The simulations that a prompt or a scenario has in hand, by number.
#pragma once

#include <functional>
#include <lua.hpp>
#include <memory>
#include <string>
#include <vector>

#include "lua/context.h"
#include "lua/sim_session.h"

namespace lsos {

class Sims : public RoversInHand {
 public:
  // Each leaves its log in a folder of its own in `folder`: sim1, sim2, ...
  // `say` prints lines.
  Sims(std::string folder, std::function<void(const std::string&)> say)
      : folder_(std::move(folder)), say_(std::move(say)) {}

  // Answers its number. Throw InputError.
  ScriptInstance open(const std::string& plan_file);
  ScriptInstance open(lua_State* L, int table, const Place& place);

  SimSession& at(ScriptInstance number) { return *sessions_[static_cast<std::size_t>(number)]; }
  // nullptr before the first.
  SimSession* last() { return sessions_.empty() ? nullptr : sessions_.back().get(); }
  void close_all() { sessions_.clear(); }
  // Of all of them, a line each.
  std::vector<std::string> take_news();

  // The id of a rover's handles.
  ScriptInstance handle(ScriptInstance number, const std::string& rover_id);
  RoverPort& rover(ScriptInstance handle) override;
  void say(const std::string& text) override { say_(text); }

 private:
  ScriptInstance add(MissionFiles files, const std::string& plan_bytes);

  std::string folder_;
  std::function<void(const std::string&)> say_;
  std::shared_ptr<const Catalog> catalog_;  // of plans that are tables
  std::vector<std::unique_ptr<SimSession>> sessions_;
};

// Those of the script that runs. Throws std::runtime_error naming `what` in event scripts.
Sims& running_sims(lua_State* L, const char* what);

const struct HandleType& sim_handle_type();

// lsos.sim(plan or table)
int make_sim(lua_State* L);

}  // namespace lsos
