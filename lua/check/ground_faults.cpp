#include "lua/check/ground_faults.h"

#include <algorithm>
#include <set>

#include "plan/open_drives.h"

namespace lsos {

namespace {

bool have_own_ids(const Plan& plan) {
  std::set<std::string> ids;
  return std::ranges::all_of(plan.rovers,
                             [&](const PlanRover& r) { return ids.insert(r.id).second; }) &&
         std::ranges::all_of(plan.assets,
                             [&](const PlanAsset& a) { return ids.insert(a.id).second; });
}

// Whether faults leave known what the mission consists of and where its rovers begin.
bool is_prepared(const MissionFiles& files) {
  const Plan& plan = files.plan;
  const PlanGaps& gaps = plan.gaps;
  const bool is_known = plan.mission.planet != nullptr && !gaps.start_time && !gaps.has_ids() &&
                        !gaps.drives_of_any && gaps.unread_ids.empty() &&
                        gaps.unplaced_rovers.empty() && !files.terrain.layers.empty();
  return is_known && !plan.rovers.empty() && have_own_ids(plan) &&
         std::ranges::all_of(
             plan.rovers,
             [&](const PlanRover& r) { return files.rover_models.contains(r.model()); }) &&
         std::ranges::all_of(
             plan.assets, [&](const PlanAsset& a) { return files.asset_models.contains(a.type); });
}

}  // namespace

std::vector<Fault> ground_faults(const MissionFiles& files, SimulationSetup setup) {
  if (!is_prepared(files)) return {};
  setup.plan = with_known_drives(std::move(setup.plan));
  try {
    const Simulation simulation(std::move(setup));
    return simulation.advice();
  } catch (const InputError& error) {
    return error.faults();
  }
}

}  // namespace lsos
