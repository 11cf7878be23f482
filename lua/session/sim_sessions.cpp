#include "lua/session/sim_sessions.h"
#include "interchange/plan_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "lua/host/plan_table.h"
#include "plan/kml_text.h"

namespace lsos {

namespace {

constexpr ScriptInstance rovers_max = 1 << 20;  // of one simulation

constexpr std::string_view folder_prefix = "sim";

ScriptInstance next_number = 0;

}  // namespace

bool SimSessions::is_folder_name(std::string_view name) {
  return name.starts_with(folder_prefix) && name.size() > folder_prefix.size() &&
         std::ranges::all_of(name.substr(folder_prefix.size()),
                             [](unsigned char c) { return std::isdigit(c) != 0; });
}

ScriptInstance SimSessions::add(PlanSource source, std::shared_ptr<const Catalog> catalog) {
  const std::string folder = fmt::format("{}/{}{}", folder_, folder_prefix, sessions_.size() + 1);
  auto session = std::make_unique<SimSession>(std::move(source), std::move(catalog), folder);
  std::vector<Fault> warnings = session->files().faults.sorted();
  const std::vector<Fault> advice = session->simulation().advice();
  warnings.insert(warnings.end(), advice.begin(), advice.end());
  for (const Fault& warning : warnings) say_(to_string(warning));
  return adopt(std::move(session));
}

ScriptInstance SimSessions::adopt(std::unique_ptr<SimSession> session) {
  sessions_[next_number] = std::move(session);
  return next_number++;
}

std::unique_ptr<SimSession> SimSessions::release(ScriptInstance number) {
  std::unique_ptr<SimSession> session = std::move(sessions_.at(number));
  sessions_.erase(number);
  return session;
}

SimSession& SimSessions::at(ScriptInstance number) {
  const auto found = sessions_.find(number);
  if (found == sessions_.end()) {
    throw std::runtime_error("this simulation has ended with the scenario that made it");
  }
  return *found->second;
}

ScriptInstance SimSessions::open(const std::string& plan_file) {
  PlanSource source = read_plan_source(plan_file);
  allow_around(source);
  std::shared_ptr<const Catalog> catalog = read_catalog(source);
  return add(std::move(source), std::move(catalog));
}

ScriptInstance SimSessions::open(lua_State* L, int table, const Place& place) {
  const PlanTable plan = read_plan_table(L, table, place);
  if (!catalog_) catalog_ = read_catalog("");
  return add({plan.source.file, plan.source, plan.soil, kml_of(plan.source), false}, catalog_);
}

std::vector<std::string> SimSessions::take_news() {
  std::vector<std::string> news;
  for (const auto& [number, session] : sessions_) {
    for (std::string& line : session->take_news()) news.push_back(std::move(line));
  }
  return news;
}

ScriptInstance SimSessions::handle(ScriptInstance number, const std::string& rover_id) {
  const std::vector<std::string> ids = at(number).simulation().fleet().rover_ids();
  return -1 - number * rovers_max - (std::ranges::find(ids, rover_id) - ids.begin());
}

RoverPort& SimSessions::rover(ScriptInstance handle) {
  Simulation& simulation = at((-1 - handle) / rovers_max).simulation();
  const auto index = static_cast<std::size_t>((-1 - handle) % rovers_max);
  return *simulation.fleet().rovers[index].agent;
}

SimSessions& running_sessions(lua_State* L, const char* what) {
  auto* sims = dynamic_cast<SimSessions*>(context(L).interactive_rovers);
  if (sims == nullptr) {
    throw std::runtime_error(fmt::format("{} works only in scenarios and at the prompt", what));
  }
  return *sims;
}

}  // namespace lsos
