// `lsos-host new event NAME`: a script that works, and a scenario that tests it.
#include <fmt/format.h>

#include <cctype>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "lua/commands.h"
#include "lua/console.h"
#include "lua/mission_files.h"
#include "product/files.h"

namespace lsos {

namespace {

namespace fs = std::filesystem;

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

std::string filled_in(std::string text, const std::string& name) {
  constexpr std::string_view mark = "NAME";
  for (std::size_t at = 0; (at = text.find(mark, at)) != std::string::npos; at += name.size()) {
    text.replace(at, mark.size(), name);
  }
  return text;
}

}  // namespace

int new_event_command(const std::string& name, bool is_json) {
  const bool is_word =
      !name.empty() && std::isupper(static_cast<unsigned char>(name.front())) != 0 &&
      std::ranges::all_of(name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)); });
  if (!is_word) {
    throw InputError({}, fmt::format("'{}' cannot be an event's name: a capital, then letters and "
                                     "digits: 'DropBeacon'",
                                     name));
  }
  for (const char* taken : {"MissionInfo", "Rover", "Asset"}) {
    if (name == taken) {
      throw InputError({}, fmt::format("'{}' is what plans call something else", name));
    }
  }
  if (read_catalog("")->declarations().events.contains(name)) {
    throw InputError({}, fmt::format("there is an event '{}' already", name));
  }
  const std::string event = "events/" + name + ".lua";
  const std::string scenario = "tests/scenarios/" + name + ".lua";
  for (const std::string& file : {event, scenario}) {
    if (fs::exists(file)) throw InputError({file, 0}, "is there already");
  }
  for (const char* folder : {"events", "tests/scenarios"}) {
    std::error_code why;
    fs::create_directories(folder, why);
    if (why) throw InputError({}, fmt::format("{}: {}", folder, why.message()));
  }
  write_file(event, filled_in(event_text, name));
  write_file(scenario, filled_in(scenario_text, name));
  if (is_json) {
    const nlohmann::ordered_json wrote{{"event", event}, {"scenario", scenario}};
    print_result("{}\n", wrote.dump());
    return 0;
  }
  print_result("wrote {} and {}\ntry it: lsos-host test {}\n", event, scenario, scenario);
  return 0;
}

}  // namespace lsos
