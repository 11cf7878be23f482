#include "lua/session/new_study_text.h"

#include <fmt/format.h>

#include <filesystem>

#include "lua/runtime/text_literal.h"

namespace lsos {

namespace {

constexpr const char* study_script_text = R"(-- Run it with: lsos-host sweep {file}
-- 'lsos-host sweep --dry-run' lists the cases and says how long they take. Which fields the plan's
-- events have: 'lsos-host list events'; which values studies can vary and gather: lua/README.md.
local lsos = require 'lsos'

return lsos.study {{
  api      = 1,
  doc      = 'How sure the results of {name} are.',
  plan     = {plan},
  cases    = 6,
  seed     = 1,
  sampling = 'random',  -- or 'latin_hypercube', 'sobol', 'grid'
  vary     = {{
{varied}    -- lsos.vary {{ of = 'MissionInfo.StartTime', list = {{ '2026-07-01T06:00:00Z' }} }},
    -- lsos.vary {{ of = 'Soil.cohesion_pa', factor = true, list = {{ 0.5, 1, 2 }} }},
  }},
  gather   = {{
{gathered}  }},
  keep     = 'failed',  -- logs of cases whose mission did not complete
}}
)";

std::string vary_text(const PlanRover& rover, const MissionModel& mission) {
  const auto model = mission.rover_models.find(rover.model());
  const bool has_battery = model != mission.rover_models.end() && model->second.power.battery;
  if (!has_battery) {
    return fmt::format("    lsos.vary {{ of = {}, within = '1 m' }},\n",
                       lua_text("Rover " + rover.id + ".Place"));
  }
  return fmt::format(
      "    lsos.vary {{ of = {}, uniform = {{ {:.3g}, {:.3g} }} }},\n"
      "    lsos.vary {{ of = {}, factor = true,\n"
      "                normal = {{ mean = 1, deviation = 0.05, min = 0.9, max = 1.1 }} }},\n",
      lua_text("Rover " + rover.id + ".InitialCharge"), 0.9 * rover.initial_charge,
      rover.initial_charge, lua_text("Rover " + rover.id + ".battery.capacity_j"));
}

std::string gather_text(const PlanRover& rover, const MissionModel& mission) {
  std::string lines;
  const PlanEvent* last = nullptr;
  for (const PlanEvent& event : mission.plan.events) {
    if (event.rover_id == rover.id && event.is_enabled) last = &event;
  }
  if (last != nullptr) {
    lines += fmt::format("    lsos.gather {{ event = {}, at = 'end', quantity = 'charge' }},\n",
                         lua_text(fmt::format("{}/{}", last->rover_id, last->sequence)));
  }
  return lines + fmt::format(
                     "    lsos.gather {{ rover = {}, take = 'least', quantity = 'charge' "
                     "}},\n",
                     lua_text(rover.id));
}

}  // namespace

std::string new_study_text(const MissionModel& mission, const std::string& plan_file) {
  const PlanRover& rover = mission.plan.rovers.front();
  const std::string name = std::filesystem::path(plan_file).stem().string();
  return fmt::format(fmt::runtime(study_script_text), fmt::arg("file", name + "_study.lua"),
                     fmt::arg("name", name), fmt::arg("plan", lua_text(plan_file)),
                     fmt::arg("varied", vary_text(rover, mission)),
                     fmt::arg("gathered", gather_text(rover, mission)));
}

}  // namespace lsos
