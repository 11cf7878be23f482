// The interactive simulations of a prompt or a scenario, by number.
#pragma once

#include <functional>
#include <lua.hpp>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lua/runtime/context.h"
#include "lua/session/sim_session.h"

namespace lsos {

class SimSessions : public InteractiveRovers {
 public:
  // Each simulation leaves its log in its own folder within `folder`: sim1, sim2, ... `say` prints
  // lines. `is_loading`: a file that declares scenarios is loading.
  SimSessions(std::string folder, std::function<void(const std::string&)> say,
              bool is_loading = false)
      : folder_(std::move(folder)), say_(std::move(say)), is_loading_(is_loading) {}

  // Whether `name` is that of such a folder.
  static bool is_folder_name(std::string_view name);

  bool is_loading() const { return is_loading_; }
  // The first expectation of a scenario that failed; "": none.
  void expectation_failed(const std::string& message) {
    if (failed_expectation_.empty()) failed_expectation_ = message;
  }
  void forget_expectation() { failed_expectation_.clear(); }
  const std::string& failed_expectation() const { return failed_expectation_; }

  // Open a simulation and return its number, which is unique in the process. Throw InputError.
  ScriptInstance open(const std::string& plan_file);
  ScriptInstance open(lua_State* L, int table, const Place& place);

  // Takes a session in, and gives it back.
  ScriptInstance adopt(std::unique_ptr<SimSession> session);
  std::unique_ptr<SimSession> release(ScriptInstance number);

  // Throws std::runtime_error where the number is not of these but of an earlier scenario.
  SimSession& at(ScriptInstance number);
  // The last simulation opened; nullptr before the first.
  SimSession* last() { return sessions_.empty() ? nullptr : sessions_.rbegin()->second.get(); }
  void close_all() { sessions_.clear(); }
  // Failures and warnings of all simulations, one line each.
  std::vector<std::string> take_news();

  // Id of a rover's handles.
  ScriptInstance handle(ScriptInstance number, const std::string& rover_id);
  RoverPort& rover(ScriptInstance handle) override;
  void say(const std::string& text) override { say_(text); }

 private:
  ScriptInstance add(PlanSource source, std::shared_ptr<const Catalog> catalog);

  std::string folder_;
  std::function<void(const std::string&)> say_;
  bool is_loading_ = false;
  std::string failed_expectation_;
  std::shared_ptr<const Catalog> catalog_;  // for plans that are tables
  std::map<ScriptInstance, std::unique_ptr<SimSession>> sessions_;
};

// The simulations of the running script. Throws std::runtime_error that names `what` in event
// scripts.
SimSessions& running_sessions(lua_State* L, const char* what);

const struct HandleType& sim_handle_type();

// lsos.sim(plan or table)
int make_sim(lua_State* L);

}  // namespace lsos
