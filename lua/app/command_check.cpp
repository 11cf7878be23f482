// `lsos-host check` and `lsos-host fsm`: check and show a plan without simulating it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <tuple>

#include "base/console.h"
#include "base/files.h"
#include "base/output_file.h"
#include "base/units.h"
#include "lua/app/commands.h"
#include "lua/app/common_options.h"
#include "lua/app/planning_watch.h"
#include "lua/check/annotated_plan.h"
#include "lua/check/check_text.h"
#include "lua/check/ground_faults.h"
#include "lua/check/timeline_text.h"
#include "lua/host/cached_routes.h"
#include "lua/host/mission_reader.h"
#include "lua/host/run_from.h"
#include "mission/estimate/estimate_warnings.h"
#include "mission/estimate/lack_warnings.h"
#include "product/estimate_text.h"

namespace lsos {

namespace {

struct CheckOptions {
  std::string plan;
  std::string csv;  // file for the estimate; "": none
  std::string kml;  // likewise, the plan with it
  bool has_timeline = false;
  std::string from;  // folder of the run with whose end it begins; "": none
  std::optional<std::uint64_t> seed;
  bool is_json = false;
  bool is_verbose = false;
  bool is_quiet = false;
  int threads = 2;
};

struct FsmOptions {
  std::string plan;
  bool is_json = false;
};

// Without the -0 that rounding makes.
double rounded_deg(double angle_deg) { return std::round(angle_deg * 1e6) / 1e6 + 0.0; }

std::string event_label(const Simulation& simulation, const std::string& rover_id,
                        std::int64_t sequence) {
  return std::ranges::find_if(
             simulation.plan().events,
             [&](const PlanEvent& e) { return e.rover_id == rover_id && e.sequence == sequence; })
      ->label;
}

std::vector<PlannedLegLine> planned_legs(const Simulation& simulation) {
  std::vector<PlannedLegLine> lines;
  for (const RoverRoutesAhead& routes : simulation.routes_ahead()) {
    const auto label = [&](std::int64_t sequence) {
      return event_label(simulation, routes.rover_id, sequence);
    };
    for (const PassedWaypoint& passed : routes.passed) {
      PlannedLegLine line{routes.rover_id, label(passed.sequence), passed.sequence,
                          passed.waypoint};
      line.is_passed = true;
      lines.push_back(std::move(line));
    }
    for (const LegAhead& ahead : routes.legs) {
      if (!ahead.leg.is_found()) continue;
      const Geodetic steepest = simulation.ground().site().geodetic(ahead.leg.steepest_S_m);
      lines.push_back({routes.rover_id, label(ahead.sequence), ahead.sequence, ahead.waypoint,
                       ahead.leg.length_m, ahead.leg.duration_s, ahead.leg.energy_j,
                       degrees(ahead.leg.slope_max_rad), rounded_deg(lon_deg(steepest)),
                       rounded_deg(lat_deg(steepest)), ahead.leg.gear_changes.size()});
    }
  }
  std::ranges::stable_sort(lines, {}, [](const PlannedLegLine& line) {
    return std::tuple(line.rover_id, line.sequence, line.waypoint);
  });
  return lines;
}

std::vector<DrawnEventLine> drawn_lines(const Simulation& simulation) {
  std::vector<DrawnEventLine> lines;
  for (const RoverRoutesAhead& routes : simulation.routes_ahead()) {
    for (const DrawnLine& drawn : routes.drawn) {
      lines.push_back(
          {routes.rover_id, event_label(simulation, routes.rover_id, drawn.sequence), drawn});
    }
  }
  return lines;
}

std::string json_text(const MissionFiles& files, const RoutesAhead& routes,
                      const MissionEstimate& estimate) {
  nlohmann::ordered_json paths = nlohmann::ordered_json::array();
  for (const PlannedLegLine& leg : routes.planned) {
    if (leg.is_passed) continue;
    paths.push_back({{"rover_id", leg.rover_id},
                     {"sequence", leg.sequence},
                     {"leg", leg.waypoint},
                     {"length_m", leg.length_m},
                     {"duration_s", leg.duration_s},
                     {"energy_j", leg.energy_j},
                     {"slope_max_deg", leg.slope_max_deg},
                     {"steepest_lon_deg", leg.steepest_lon_deg},
                     {"steepest_lat_deg", leg.steepest_lat_deg},
                     {"gear_changes", leg.gear_changes}});
  }
  nlohmann::ordered_json lines = nlohmann::ordered_json::array();
  for (const DrawnEventLine& line : routes.drawn) {
    nlohmann::ordered_json& entry = lines.emplace_back(
        nlohmann::ordered_json{{"rover_id", line.rover_id}, {"sequence", line.drawn.sequence}});
    if (line.drawn.to_first_m) entry["to_first_m"] = *line.drawn.to_first_m;
    entry["along_m"] = line.drawn.along_m;
  }
  nlohmann::ordered_json faults = nlohmann::ordered_json::array();
  for (const Fault& fault : files.faults.sorted()) {
    faults.push_back({{"severity", fault.severity == Severity::error ? "error" : "warning"},
                      {"file", fault.place.file},
                      {"line", fault.place.line},
                      {"what", fault.what}});
  }
  nlohmann::ordered_json timed_events = nlohmann::ordered_json::array();
  for (const PlanEvent& event : files.plan.events) {
    if (!event.at || !event.is_enabled) continue;
    timed_events.push_back({{"rover_id", event.rover_id},
                            {"sequence", event.sequence},
                            {"label", event.label},
                            {"at_s", seconds(*event.at)}});
  }
  const nlohmann::ordered_json answer{{"plan", files.plan.file},
                                      {"plan_sha256", files.plan.hash()},
                                      {"is_valid", !files.faults.has_errors()},
                                      {"rovers", files.plan.rovers.size()},
                                      {"events", files.plan.events.size()},
                                      {"decoration", files.plan.decoration_count},
                                      {"faults", faults},
                                      {"planned_paths", paths},
                                      {"drawn_lines", lines},
                                      {"timed_events", timed_events},
                                      {"estimate", estimate_json(estimate)},
                                      {"defaults", files.plan.defaults},
                                      {"assumptions", files.assumptions}};
  return answer.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string json_text(const MissionMachine& machine) {
  nlohmann::ordered_json rovers = nlohmann::ordered_json::array();
  for (const RoverMachine& rover : machine.rovers) {
    nlohmann::ordered_json events = nlohmann::ordered_json::array();
    for (const EventMachine& event : rover.events) {
      nlohmann::ordered_json phases = nlohmann::ordered_json::array();
      for (const EventDeclaration::Phase& phase : event.declaration.phases) {
        phases.push_back(phase.name);
      }
      events.push_back({{"sequence", event.event.sequence},
                        {"type", event.event.type},
                        {"label", event.event.label},
                        {"enabled", event.event.is_enabled},
                        {"phases", phases}});
      if (event.event.at) events.back()["at_s"] = seconds(*event.event.at);
    }
    rovers.push_back(
        {{"rover_id", rover.rover.id}, {"type", rover.rover.type}, {"events", events}});
  }
  return nlohmann::ordered_json{{"rovers", rovers}}.dump(2, ' ', false,
                                                         nlohmann::json::error_handler_t::replace) +
         "\n";
}

// `watch` and `not_kept`, warnings of routes that are not kept, must outlive it.
SimulationSetup check_setup(const MissionFiles& files, const CheckOptions& options,
                            PlanningWatch& watch, std::vector<Fault>& not_kept) {
  SimulationSetup setup = simulation_setup(files);
  setup.threads = options.threads;
  setup.cache_legs = [&](const std::string& bytes) {
    not_kept = cache_legs(files.plan.home, bytes);
  };
  setup.on_planning = [&](const std::string& what) { watch.plan(what); };
  return setup;
}

void check_outputs(const CheckOptions& options) {
  Faults faults;
  if (!options.csv.empty()) check_output("--csv", options.csv, {".csv"}, {options.plan}, faults);
  if (!options.kml.empty()) {
    const char* ending = options.plan.ends_with(".kmz") ? ".kmz" : ".kml";
    check_output("--kml", options.kml, {ending}, {options.plan}, faults);
  }
  faults.throw_if_errors();
}

int check_command(const CheckOptions& options) {
  check_outputs(options);
  MissionFiles files = read_mission(options.plan, options.seed);
  RoutesAhead routes;
  MissionEstimate estimate;
  std::vector<Fault> not_kept;
  if (!files.faults.has_errors()) {
    try {
      if (!options.from.empty()) begin_from(options.from, files);
      files.faults.throw_if_errors();
      // The constructor runs the machine's `initialise`: rovers are placed on the ground and routes
      // are planned, but nothing moves. Then events are gone through without dynamics.
      PlanningWatch watch(options.is_quiet);
      SimulationSetup setup = check_setup(files, options, watch, not_kept);
      setup.is_estimate = setup.keeps_sight = true;
      files.faults.add(cached_legs_advice(files.plan.home));
      Simulation simulation(std::move(setup));
      for (const std::string& line : simulation.assumptions()) files.assumptions.push_back(line);
      files.faults.add(simulation.advice());
      files.faults.add(simulation.ground_end_warnings());
      routes = {planned_legs(simulation), drawn_lines(simulation)};
      estimate = estimate_mission(simulation);
      files.faults.add(
          estimate_warnings(estimate.events, simulation.plan(), files.faults.sorted()));
      files.faults.add(lack_warnings(estimate.lacks, simulation.plan()));
      files.faults.add(doubt_warnings(estimate.events, estimate.lacks, simulation.plan()));
      if (!estimate.cut_short.empty()) {
        files.faults.warning({files.plan.file, 0},
                             "the estimate ends before the mission does: " + estimate.cut_short);
      }
      if (!options.csv.empty())
        write_file(options.csv, estimate_csv(estimate, files.plan.mission.start_time));
      if (!options.kml.empty()) {
        write_file(options.kml, annotated_plan(files, simulation, estimate));
      }
    } catch (const InputError& error) {
      if (!files.faults.has_errors()) files.faults.add(error.faults());
    }
    files.faults.add(not_kept);  // also when a leg has no route
  } else if (options.from.empty()) {
    PlanningWatch watch(options.is_quiet);
    files.faults.add(ground_faults(files, check_setup(files, options, watch, not_kept)));
  }
  if (options.is_json) {
    print_result("{}", json_text(files, routes, estimate));
  } else {
    print_result("{}{}", check_text(files, routes, options.is_verbose),
                 estimate_text(estimate, options.is_verbose));
    if (options.has_timeline && !files.faults.has_errors()) {
      print_result("{}  {}\n",
                   timeline_text(estimate, files.plan.activities, files.plan.mission.start_time),
                   timeline_legend);
    }
  }
  if (!files.faults.has_errors()) return 0;
  for (const auto& [option, file] :
       {std::pair("--csv", options.csv), std::pair("--kml", options.kml)}) {
    if (!file.empty())
      print_message("{} {}: is not written, as the plan has errors\n", option, file);
  }
  return 2;
}

int fsm_command(const FsmOptions& options) {
  const MissionFiles files = read_mission(options.plan);
  files.faults.throw_if_errors();
  const MissionMachine machine = synthesise(files.plan, files.catalog->declarations());
  print_result("{}", options.is_json ? json_text(machine) : to_dot(machine));
  return 0;
}

}  // namespace

std::function<int()> prepare_check(CommandOptions& command) {
  const auto options = std::make_shared<CheckOptions>();
  command.add_option("PLAN", options->plan, "A plan: KML, KMZ or GeoPackage").required();
  command.add_option("--from", options->from, from_help);
  command.add_option("--seed", options->seed, "Instead of the plan's Seed").seed();
  command.add_flag(
      "--timeline", options->has_timeline,
      (std::string("Days as lines of time, a letter 20 min: ") + timeline_legend).c_str());
  command.add_option("--csv", options->csv, "A file for the estimate, a row an event");
  command.add_option("--kml", options->kml,
                     "A file for the plan with the estimate in its balloons, times and a folder");
  command.add_flag("--json", options->is_json, "The answer as JSON");
  command.add_flag("--verbose", options->is_verbose, "Each leg, event, default and assumption");
  command.add_flag("--quiet", options->is_quiet, "No progress");
  add_threads(command, options->threads, "Threads that plan routes, of one rover each");
  return [options] { return check_command(*options); };
}

std::function<int()> prepare_fsm(CommandOptions& command) {
  const auto options = std::make_shared<FsmOptions>();
  command.add_option("PLAN", options->plan, "A plan: KML, KMZ or GeoPackage").required();
  command.add_flag("--json", options->is_json, "As JSON");
  return [options] { return fsm_command(*options); };
}

}  // namespace lsos
