// The engine's ScriptHost, implemented in Lua: runs the phases of event scripts.
#pragma once

#include <memory>
#include <set>
#include <string>

#include "lua/host/catalog.h"
#include "lua/host/condition_world.h"
#include "lua/runtime/context.h"
#include "mission/model/plan_names.h"
#include "mission/model/rover_model.h"
#include "mission/port/script_host.h"
#include "plan/plan.h"

namespace lsos {

class LuaHost : public ScriptHost {
 public:
  // Loads the catalog's sound event scripts anew. The same catalog always gives the same host, so
  // that saved states fit.
  explicit LuaHost(const Catalog& catalog, const Limits& limits = {});
  ~LuaHost() override;

  // Result of an event's `check` for its parameters and for the rover that runs it; empty texts
  // when all is well or it has no `check`. `rover` and `model` are nullptr where faults of the plan
  // keep them from being known. Throws ScriptError.
  struct CheckAnswer {
    std::string fault, warning;
  };
  CheckAnswer check(const std::string& type, const EventArguments& arguments, Instant mission_start,
                    const PlanRover* rover, const RoverModel* model);

  // What an event breaks or repairs, as its script says before the run; absent: nothing. Throws
  // ScriptError.
  std::optional<Breakage> breakage(const std::string& type, const EventArguments& arguments,
                                   Instant mission_start);

  // What an event takes of its rover's resources and fills up, as its script says before the run.
  // Throws ScriptError.
  ResourceChange resource_change(const std::string& type, const EventArguments& arguments,
                                 Instant mission_start);

  bool is_open_ended(const std::string& type, const EventArguments& arguments,
                     Instant mission_start) override;
  bool awaits_sunlight(const std::string& type, const EventArguments& arguments,
                       Instant mission_start) override;

  // What is wrong with a condition of a plan; "" for a sound one.
  std::string condition_fault(const std::string& text, const ConditionWorld& world);

  bool holds(const std::string& condition, const SampleRow& row, const RoverPort& rover) override;
  std::optional<RouteSettings> route_settings(const std::string& type,
                                              const EventArguments& arguments,
                                              Instant mission_start) override;
  const Declarations& declarations() const override;
  ScriptInstance begin(const std::string& type, const EventArguments& arguments) override;
  PhaseAnswer run_phase(ScriptInstance instance, const std::string& phase,
                        PhaseContext& context) override;
  std::string values_in(const std::string& condition, const SampleRow& row,
                        const RoverPort& rover) override;
  std::string run_abort(ScriptInstance instance, PhaseContext& context) override;
  void end(ScriptInstance instance) override;
  std::string save(ScriptInstance instance) override;
  void restore(ScriptInstance instance, const std::string& bytes) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lsos
