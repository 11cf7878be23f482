#include "lua/session/new_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "lua/runtime/text_literal.h"
#include "planet/site_frame.h"

namespace lsos {

namespace {

constexpr const char* event_text = R"(-- Say here what it does, in a sentence.

local lsos = require 'lsos'

-- A phase is called when it is due. What it returns says when it is called next, or that the event
-- has ended. Only ev.state lives between two calls.
local function stay(ev, rover)
  rover:brake()
  local left_s = ev.params.duration_s - ev.phase_elapsed_s
  if left_s > 0 then return lsos.sleep(left_s) end
  ev:log('NAME', { charge = rover.battery and rover.battery.charge })
  return lsos.done
end

return lsos.event {
  api    = 1,
  schema = 'NAME',
  doc    = 'Say here what it does, in a sentence.',

  params = {
    duration_s = lsos.duration { kml = 'Duration', default = 60, doc = 'How long it takes.' },
  },

  start  = 'stay',
  phases = { stay = stay },
}
)";

constexpr const char* scenario_text =
    R"(-- What must come of NAME. Run it by: lsos-host test tests/scenarios/NAME.lua

local lsos = require 'lsos'

lsos.scenario('NAME takes as long as it says', function(t)
  local sim = lsos.sim {
    terrain = 'Flat',
    rovers  = { A = { type = 'SEV', events = { { 'NAME', Duration = '5 min' } } } },
  }
  sim:run()
  local event = sim:event('A/10')
  t:equal(event.status, 'completed')
  t:near(event.end_s - event.start_s, '5 min', '1 s', 'duration')
  t:equal(#sim:notes('NAME'), 1, 'notes')
end)
)";

constexpr const char* rover_template =
    R"(-- Say here in which numbers it differs from BASE, and where these are from.

local lsos = require 'lsos'

-- What is not named here is as rovers/BASE.lua has it. A table changes a part, `panels = { Roof =
-- { efficiency = 0.32 } }` one of several by its name, and `false` takes a part away.
return lsos.derive('BASE', {
  api = 1,
  doc = 'Say here what it is, in a sentence.',

  chassis = { mass_kg = MASS },

  assumptions = { 'NAME: its mass is assumed' },
})
)";

constexpr const char* rover_scenario_text =
    R"(-- What NAME must be able to do. Run it by: lsos-host test tests/scenarios/NAME.lua

local lsos = require 'lsos'

lsos.scenario('NAME drives 30 m', function(t)
  local sim = lsos.sim {
    terrain = 'Flat',
    rovers  = { A = { type = 'NAME', events = { { 'Route', at = { 30, 0 } } } } },
  }
  sim:run()
  t:equal(sim:event('A/10').status, 'completed')
  t:near(sim.rovers.A.distance_m, '30 m', '1 m', 'distance')
end)
)";

constexpr const char* raster_terrain_text =
    R"(-- Say here where the heights are from, and their licence.

local lsos = require 'lsos'

return lsos.terrain {
  api = 1,
  doc = 'Say here what ground it is, in a sentence.',

  surface = lsos.raster { file = 'RASTER' },
  soil    = 'ApolloNominal',  -- lsos-host list soils names the others
}
)";

constexpr const char* synthetic_terrain_text = R"(-- Say here what ground it is made after.

local lsos = require 'lsos'

return lsos.terrain {
  api = 1,
  doc = 'Say here what ground it is, in a sentence.',

  surface = lsos.plane {},
  -- For heights of your own: surface = lsos.raster { file = 'dem.tif' }, relative to this file.
  detail  = lsos.detail {
    craters = lsos.craters {
      diameter_min_m    = 3,
      diameter_max_m    = 60,
      exponent          = 2,
      density_pm2       = 9e-4,
      depth_to_diameter = 0.08,
    },
  },
  soil = 'ApolloNominal',  -- lsos-host list soils names the others
}
)";

constexpr const char* drive_scenario_text =
    R"(-- Say here what must hold. Run it by: lsos-host test tests/scenarios/NAME.lua

local lsos = require 'lsos'

lsos.scenario('a drive of 30 m arrives', function(t)
  local sim = lsos.sim {
    terrain = 'Flat',
    rovers  = { A = { type = 'SEV', events = { { 'Route', at = { 30, 0 } } } } },
  }
  -- Or, of a plan: local sim = lsos.sim 'plan.kml'
  sim:run()
  t:equal(sim:event('A/10').status, 'completed')
  t:near(sim.rovers.A.distance_m, '30 m', '1 m', 'distance')
end)
)";

// Replaces the marks in a text in one pass: replaced text is not searched for further marks.
std::string filled_in(std::string_view text,
                      const std::vector<std::pair<std::string_view, std::string>>& marks) {
  std::string filled;
  for (std::size_t at = 0; at < text.size();) {
    const auto mark = std::ranges::find_if(
        marks, [&](const auto& each) { return text.substr(at).starts_with(each.first); });
    if (mark == marks.end()) {
      filled += text[at++];
    } else {
      filled += mark->second;
      at += mark->first.size();
    }
  }
  return filled;
}

}  // namespace

std::string new_event_text(const std::string& name) {
  return filled_in(event_text, {{"NAME", name}});
}

std::string new_event_scenario_text(const std::string& name) {
  return filled_in(scenario_text, {{"NAME", name}});
}

std::string new_rover_text(const std::string& name, const std::string& base, double mass_kg) {
  return filled_in(rover_template,
                   {{"NAME", name}, {"BASE", base}, {"MASS", fmt::format("{:g}", mass_kg)}});
}

std::string new_rover_scenario_text(const std::string& name) {
  return filled_in(rover_scenario_text, {{"NAME", name}});
}

std::string new_terrain_text(const std::string& raster) {
  return raster.empty() ? synthetic_terrain_text
                        : filled_in(raster_terrain_text, {{"'RASTER'", lua_text(raster)}});
}

std::string new_scenario_text(const std::string& name) {
  return filled_in(drive_scenario_text, {{"NAME", name}});
}

KmlDocument new_plan(const NewPlan& plan, const std::vector<Kind>& kinds) {
  constexpr double out_m = 100, aside_m = 60;
  KmlDocument document;
  document.name = plan.name;
  document.target = target_of(*plan.body);
  document.description = "A rover drives out, looks around and comes back.";
  for (const Kind& kind : kinds) document.schemas.push_back(schema_of(kind));
  // The goal lies towards the equator, where the ground continues.
  const SiteFrame site(*plan.body, plan.start);
  Geodetic goal = site.geodetic({out_m, plan.start.lat_rad > 0 ? -aside_m : aside_m, 0});
  goal.height_m = 0;
  const auto add = [&](const std::string& kind, const std::string& label, KmlGeometry geometry,
                       std::vector<std::pair<std::string, std::string>> data) {
    KmlPlacemark placemark;
    placemark.name = label;
    placemark.schema_id = kind;
    placemark.geometry = std::move(geometry);
    placemark.data = std::move(data);
    placemark.data.insert(placemark.data.begin(), {"Type", kind});
    document.placemarks.push_back(std::move(placemark));
  };
  const KmlGeometry at_start{KmlGeometryKind::point, {plan.start}},
      at_goal{KmlGeometryKind::point, {goal}};
  add("MissionInfo", plan.name, {},
      {{"Planet", std::string(plan.body->name)},
       {"StartTime", "2026-12-21T06:00:00Z"},
       {"Terrain", plan.terrain}});
  add("Rover", "Rover", at_start, {{"RoverId", "A"}, {"RoverType", plan.rover_type}});
  add("PathPlanRoute", "Out", {KmlGeometryKind::line, {plan.start, goal}},
      {{"RoverId", "A"}, {"Sequence", "10"}});
  add("Pause", "Look around", at_goal,
      {{"RoverId", "A"}, {"Sequence", "20"}, {"Duration", "10 min"}});
  add("PathPlanRoute", "Back", {KmlGeometryKind::line, {goal, plan.start}},
      {{"RoverId", "A"}, {"Sequence", "30"}});
  return document;
}

}  // namespace lsos
