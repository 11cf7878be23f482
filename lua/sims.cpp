#include "lua/sims.h"

#include <fmt/format.h>

#include <algorithm>

#include "lua/plan_table.h"
#include "plan/kml_text.h"

namespace lsos {

namespace {

constexpr ScriptInstance rovers_max = 1 << 20;  // of one simulation

}  // namespace

ScriptInstance Sims::add(MissionFiles files, const std::string& plan_bytes) {
  const std::string folder = fmt::format("{}/sim{}", folder_, sessions_.size() + 1);
  std::vector<Fault> warnings = files.faults.sorted();
  sessions_.push_back(std::make_unique<SimSession>(std::move(files), plan_bytes, folder));
  const std::vector<Fault>& advice = sessions_.back()->simulation().advice();
  warnings.insert(warnings.end(), advice.begin(), advice.end());
  for (const Fault& warning : warnings) say_(to_string(warning));
  return static_cast<ScriptInstance>(sessions_.size()) - 1;
}

ScriptInstance Sims::open(const std::string& plan_file) {
  MissionFiles files = read_mission(plan_file);
  files.faults.throw_if_errors();
  return add(std::move(files), read_bytes(plan_file));
}

ScriptInstance Sims::open(lua_State* L, int table, const Place& place) {
  const PlanTable plan = read_plan_table(L, table, place);
  if (!catalog_) catalog_ = read_catalog("");
  MissionFiles files = read_mission(plan.source, plan.soil, catalog_);
  files.faults.throw_if_errors();
  return add(std::move(files), kml_of(plan.source));
}

std::vector<std::string> Sims::take_news() {
  std::vector<std::string> news;
  for (const auto& session : sessions_) {
    for (std::string& line : session->take_news()) news.push_back(std::move(line));
  }
  return news;
}

ScriptInstance Sims::handle(ScriptInstance number, const std::string& rover_id) {
  const std::vector<std::string> ids = at(number).simulation().rover_ids();
  return -1 - number * rovers_max - (std::ranges::find(ids, rover_id) - ids.begin());
}

RoverPort& Sims::rover(ScriptInstance handle) {
  Simulation& simulation = at((-1 - handle) / rovers_max).simulation();
  const auto index = static_cast<std::size_t>((-1 - handle) % rovers_max);
  return *simulation.agent(simulation.rover_ids()[index]);
}

Sims& running_sims(lua_State* L, const char* what) {
  auto* sims = dynamic_cast<Sims*>(context(L).in_hand);
  if (sims == nullptr) {
    throw std::runtime_error(fmt::format("{} works only in scenarios and at the prompt", what));
  }
  return *sims;
}

}  // namespace lsos
