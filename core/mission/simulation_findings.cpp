// What a user is told of a simulation besides its log: warnings and assumptions.
#include <fmt/format.h>

#include <algorithm>

#include "mission/ahead/ground_end_warnings.h"
#include "mission/model/site.h"
#include "mission/simulation.h"
#include "planet/place_text.h"

namespace lsos {

std::vector<Fault> Simulation::advice() const {
  std::vector<Fault> advice = site_.ground->advice();
  advice.insert(advice.end(), routes_ahead_.faults.begin(), routes_ahead_.faults.end());
  for (const RoverMachine& rover : machine_.rovers) {
    const std::vector<Fault> coarse = coarse_ground(rover, *site_.ground);
    if (coarse.empty()) continue;
    advice.insert(advice.end(), coarse.begin(), coarse.end());
    break;
  }
  return advice;
}

std::vector<std::string> Simulation::assumptions() const {
  std::vector<std::string> assumptions = vehicle_assumptions(site_);
  const bool has_routes = std::ranges::any_of(
      routes_ahead_.rovers, [](const RoverRoutesAhead& routes) { return !routes.legs.empty(); });
  if (has_routes) {
    assumptions.push_back(
        "planned routes: wheels share the load evenly, and all roll when turning on the spot");
  }
  const auto add = [&](const std::vector<std::string>& more) {
    assumptions.insert(assumptions.end(), more.begin(), more.end());
  };
  for (const auto& [type, model] : setup_.asset_models) add(model.assumptions);
  if (sunlight_) add(sunlight_->assumptions());
  if (setup_.terrain.is_synthetic) {
    const MissionInfo& mission = setup_.plan.mission;
    const bool is_placed = std::holds_alternative<ReliefSurface>(setup_.terrain.layers.back());
    std::string where = " and laid out from the start of the first rover";
    if (mission.site || mission.earlier_site) {
      where = fmt::format(" and laid out from {}", lon_lat_text(site_of(setup_.plan)));
    }
    if (is_placed) where = ": landforms at their places, no measured heights";
    assumptions.push_back(
        fmt::format("{}: the terrain is synthetic{}", setup_.terrain.name, where));
  }
  return assumptions;
}

std::vector<Fault> Simulation::ground_end_warnings() const {
  return lsos::ground_end_warnings(machine_, setup_.rover_models, *site_.ground,
                                   sunlight_ != nullptr);
}

void Simulation::warn_of_ends() {
  const auto add = [&](const SightOverEnd& looks) {
    const auto warning = looks.warning(setup_.plan.mission.start_time);
    if (warning) warnings_.add_last(*warning);
  };
  for (const std::string& file : site_.ground->changed_files()) {
    warnings_.add_last(
        fmt::format("{}: has changed during the run, whose ground may be partly that of the old "
                    "file and partly "
                    "that of the new one; run the plan again",
                    file));
  }
  if (sunlight_) add(sunlight_->over_end());
  if (!sight_) return;
  add(sight_->watch().earth_over_end());
  add(sight_->watch().pairs_over_end());
  for (std::string& warning : sight_->warnings_of_own_way(fleet_, now_)) {
    warnings_.add_last(std::move(warning));
  }
}

}  // namespace lsos
