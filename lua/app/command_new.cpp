// `lsos-host new WHAT NAME`: writes a working event, rover, terrain, scenario or plan to start
// from.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "access/file_access.h"
#include "base/console.h"
#include "base/error.h"
#include "base/files.h"
#include "lua/app/commands.h"
#include "lua/app/place_options.h"
#include "lua/host/mission_reader.h"
#include "lua/host/script_folders.h"
#include "lua/session/new_study_text.h"
#include "lua/session/new_text.h"
#include "mission/model/site.h"
#include "plan/kml_writer.h"
#include "terrain/spec/terrain_beyond.h"

namespace lsos {

namespace {

// A script that works to begin from, and a scenario that tests it; or a plan. Says in JSON or for
// people which files it wrote.
struct NewOptions {
  std::string what;  // event, rover, terrain, scenario, plan, study
  std::string name;
  std::string from;  // a rover type; of a terrain a raster; "": SEV, or synthetic ground
  std::string planet, terrain, site;  // of a plan; "": Moon, Craters, 0,0
  bool is_json = false;
};

namespace fs = std::filesystem;

// Kind, name and text of each file to write. None of the files may exist already.
using NewFiles = std::vector<std::pair<std::string, std::pair<std::string, std::string>>>;

void check_word(const NewOptions& options) {
  const std::string& name = options.name;
  const bool needs_capital = options.what == "event";
  const auto is_letter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
  const bool is_word =
      !name.empty() && std::isalpha(static_cast<unsigned char>(name.front())) != 0 &&
      (!needs_capital || std::isupper(static_cast<unsigned char>(name.front())) != 0) &&
      std::ranges::all_of(
          name, [&](char c) { return is_letter(c) || (!needs_capital && (c == '_' || c == '-')); });
  if (is_word) return;
  throw InputError({}, needs_capital
                           ? fmt::format("'{}' cannot be an event's name: a capital, then letters "
                                         "and digits: 'DropBeacon'",
                                         name)
                           : fmt::format("'{}' cannot be a name: a letter, then letters, digits, "
                                         "'_' and '-'",
                                         name));
}

void refuse_known(const NewOptions& options, bool is_known) {
  if (!is_known) return;
  const char* article = options.what == "event" ? "an" : "a";
  throw InputError({},
                   fmt::format("there is {} {} '{}' already", article, options.what, options.name));
}

NewFiles new_event(const NewOptions& options, const Catalog& catalog) {
  for (const char* taken : {"MissionInfo", "Rover", "Asset"}) {
    if (options.name == taken) {
      throw InputError({}, fmt::format("'{}' is what plans call something else", options.name));
    }
  }
  refuse_known(options, catalog.declarations().events.contains(options.name));
  return {{"event", {"events/" + options.name + ".lua", new_event_text(options.name)}},
          {"scenario",
           {"tests/scenarios/" + options.name + ".lua", new_event_scenario_text(options.name)}}};
}

NewFiles new_rover(const NewOptions& options, const Catalog& catalog) {
  refuse_known(options, catalog.declarations().rover_types.contains(options.name));
  const std::string base = options.from.empty() ? "SEV" : options.from;
  const double mass_kg = catalog.load_rover(base).spec.vehicle.chassis.mass_kg;
  return {
      {"rover", {"rovers/" + options.name + ".lua", new_rover_text(options.name, base, mass_kg)}},
      {"scenario",
       {"tests/scenarios/" + options.name + ".lua", new_rover_scenario_text(options.name)}}};
}

NewFiles new_terrain(const NewOptions& options, const Catalog& catalog) {
  refuse_known(options, std::ranges::count(catalog.declarations().terrains, options.name) > 0);
  std::string raster;
  if (!options.from.empty()) {
    if (!fs::exists(options.from)) throw InputError({options.from, 0}, "there is no such file");
    raster = fs::path(options.from).is_absolute() ? options.from : "../" + options.from;
  }
  return {{"terrain", {"terrain/" + options.name + ".lua", new_terrain_text(raster)}}};
}

// Throws InputError for options that do not apply to what is made.
void refuse_stray_options(const NewOptions& options) {
  const bool is_plan = options.what == "plan";
  const bool takes_from =
      options.what == "plan" || options.what == "rover" || options.what == "terrain";
  const auto refuse = [&](bool is_given, const char* option) {
    if (!is_given) return;
    throw InputError({}, fmt::format("{} says nothing of a new {}", option, options.what));
  };
  refuse(!options.from.empty() && !takes_from, "--from");
  refuse(!is_plan && !options.planet.empty(), "--planet");
  refuse(!is_plan && !options.terrain.empty(), "--terrain");
  refuse(!is_plan && !options.site.empty(), "--site");
}

NewFiles new_plan_file(const NewOptions& options, const Catalog& catalog) {
  Faults faults;
  NewPlan plan;
  plan.name = options.name;
  plan.body = option_body("--planet", options.planet.empty() ? "Moon" : options.planet, faults);
  plan.terrain = options.terrain.empty() ? "Craters" : options.terrain;
  const auto& terrains = catalog.declarations().terrains;
  if (fs::exists(plan.terrain)) allow_raster(plan.terrain);
  if (std::ranges::count(terrains, plan.terrain) == 0 && !fs::exists(plan.terrain)) {
    faults.error({}, fmt::format("--terrain {}: there is no such terrain and no such file{}",
                                 plan.terrain, did_you_mean(plan.terrain, terrains)));
  }
  plan.rover_type = options.from.empty() ? "SEV" : options.from;
  const std::string site = options.site.empty() ? "0,0" : options.site;
  const auto start = option_site("--site", site, faults);
  faults.throw_if_errors();
  plan.start = *start;
  catalog.load_rover(plan.rover_type);
  try {
    const bool is_script = std::ranges::count(terrains, plan.terrain) > 0;
    drivable_ground_at(
        is_script ? catalog.load_terrain(plan.terrain) : raster_terrain({plan.terrain}, {}),
        *plan.body, plan.start, 0);
  } catch (const InputError& error) {
    throw InputError({}, fmt::format("--site {}{}: {} has no ground there: {}; --site LON,LAT says "
                                     "where the rover starts",
                                     site, options.site.empty() ? " (the default)" : "",
                                     plan.terrain, error.faults().front().what));
  }
  return {{"plan", {options.name + ".kml", write_kml(new_plan(plan, kinds_of(catalog, {})))}}};
}

// A study of a plan in any folder; it is written into the working folder.
NewFiles new_study(const NewOptions& options) {
  const MissionFiles mission = read_mission(options.name);
  mission.faults.throw_if_errors();
  const std::string stem = fs::path(options.name).stem().string();
  return {{"study", {stem + "_study.lua", new_study_text(mission, options.name)}}};
}

NewFiles new_files(const NewOptions& options, const Catalog& catalog) {
  if (options.what == "study") return new_study(options);
  if (options.what == "event") return new_event(options, catalog);
  if (options.what == "rover") return new_rover(options, catalog);
  if (options.what == "terrain") return new_terrain(options, catalog);
  if (options.what == "plan") return new_plan_file(options, catalog);
  return {
      {"scenario", {"tests/scenarios/" + options.name + ".lua", new_scenario_text(options.name)}}};
}

// Adds settings for editors with the Lua language server, unless the folder has such settings.
void add_editor_settings(NewFiles& files) {
  constexpr const char* settings = ".luarc.json";
  const std::string library = library_file();
  if (library.empty() || fs::exists(settings)) return;
  const nlohmann::ordered_json json{{"runtime.version", "Lua 5.4"},
                                    {"workspace.library", {library}}};
  files.push_back({"editor settings", {settings, json.dump(2) + "\n"}});
}

int new_command(const NewOptions& options) {
  if (options.what != "study") check_word(options);
  refuse_stray_options(options);
  const std::shared_ptr<const Catalog> catalog = read_catalog("");
  NewFiles files = new_files(options, *catalog);
  for (const auto& [what, file] : files) {
    if (fs::exists(file.first)) throw InputError({file.first, 0}, "is there already");
  }
  if (options.what != "plan" && options.what != "study") add_editor_settings(files);
  nlohmann::ordered_json wrote;
  std::vector<std::string> names;
  for (const auto& [what, file] : files) {
    const fs::path folder = fs::path(file.first).parent_path();
    std::error_code why;
    if (!folder.empty()) fs::create_directories(folder, why);
    if (why) throw InputError({}, fmt::format("{}: {}", folder.string(), why.message()));
    write_file(file.first, file.second);
    wrote[what] = file.first;
    names.push_back(file.first);
  }
  if (options.is_json) {
    print_result("{}\n", wrote.dump());
    return 0;
  }
  const std::string& first = files.front().second.first;
  std::string next = "test tests/scenarios/" + options.name + ".lua";
  if (options.what == "plan") next = first;
  if (options.what == "study") next = "sweep " + first;
  if (options.what == "terrain") next = "list terrains " + options.name;
  print_result("wrote {}\ntry it: lsos-host {}\n", fmt::join(names, ", "), next);
  return 0;
}

}  // namespace

std::function<int()> prepare_new(CommandOptions& command) {
  const auto options = std::make_shared<NewOptions>();
  command.add_option("WHAT", options->what, "plan, event, rover, terrain, scenario or study")
      .required()
      .one_of({"plan", "event", "rover", "terrain", "scenario", "study"});
  command
      .add_option("NAME", options->name,
                  "What it shall be called: DropBeacon; of a study, the plan: PLAN.kml")
      .required();
  command.add_option("--from", options->from, "A rover type (SEV); of a terrain a raster");
  command.add_option("--planet", options->planet, "Of a plan: Moon, Mars or Earth (Moon)");
  command.add_option("--terrain", options->terrain, "Of a plan: a script or raster (Craters)");
  command.add_option("--site", options->site, "LON,LAT where the rover of a plan starts (0,0)");
  command.add_flag("--json", options->is_json, "The names of the files as JSON");
  return [options] { return new_command(*options); };
}

}  // namespace lsos
