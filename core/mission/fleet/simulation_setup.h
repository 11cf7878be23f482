// What a simulation is made from.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "mission/model/rover_model.h"
#include "mission/model/rover_start.h"
#include "mission/port/script_host.h"
#include "plan/plan.h"
#include "terrain/ground.h"

namespace lsos {

struct SimulationSetup {
  Plan plan;
  std::map<std::string, RoverModel> rover_models;  // key: PlanRover::model()
  std::map<std::string, AssetModel> asset_models;  // key: AssetType
  TerrainSpec terrain;
  // How rovers begin that do not begin as the plan says; by RoverId. Places and headings must be
  // those of `plan`, from which routes are planned.
  std::map<std::string, RoverStart> starts = {};
  std::function<std::unique_ptr<ScriptHost>()> make_host;
  int threads = 1;
  // Torture mode: at each exchange all state is written out, thrown away, read back and compared.
  bool save_every_exchange = false;
  // Whether it is an estimate: drives are foreseen (RoverAgent::foresee_drives), light and sight
  // are evaluated less often, and nothing is logged or saved.
  bool is_estimate = false;
  // Whether it is only prepared, not started: rovers are placed and routes planned, and there is
  // neither light nor sight.
  bool is_preparation = false;
  // Whether lines of sight are evaluated, for the layers `pairs` and `sight_intervals` of the log.
  bool keeps_sight = false;
  // Legs planned by an earlier run, see PlannedLegs.
  std::string cached_legs = {};
  // Whether routes are planned before the start. A simulation that resumes a saved state needs
  // none.
  bool plans_ahead = true;
  // Called with the legs to keep for later runs, while routes are planned and once they are, also
  // when a leg has no route.
  std::function<void(const std::string& bytes)> cache_legs = {};
  // Called with a description as the planning of each leg begins, and with "" when it ends, by one
  // thread at a time; of legs planned at the same time the one that began first.
  std::function<void(const std::string& what)> on_planning = {};
};

}  // namespace lsos
