// The command line of lsos-host.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <filesystem>

#include "base/error.h"
#include "base/output_error.h"
#include "base/units.h"
#include "lua/commands.h"
#include "lua/console.h"
#include "lua/version.h"

namespace {

using lsos::InputError;

const std::vector<std::string> built{"run",    "check",   "compare", "fsm",     "light",  "list",
                                     "new",    "overlay", "picture", "repl",    "report", "rig",
                                     "schema", "sight",   "sun",     "terrain", "test",   "verify"};
// Named in the manual, not there yet.
const std::vector<std::string> unbuilt{"resume", "import", "export"};

// `lsos-host PLAN.kml ...` is `lsos-host run PLAN.kml ...`; anything else that is no command is
// told which one was meant.
void insert_run(std::vector<std::string>& arguments) {
  if (arguments.empty()) return;
  if (arguments.front() == "help") {  // "help run" is "run --help"
    arguments.erase(arguments.begin());
    arguments.emplace_back("--help");
  }
  const std::string& first = arguments.front();
  if (first == "-h" || first == "--help" || first == "--version") return;
  if (std::ranges::count(built, first) > 0) return;
  if (std::ranges::count(unbuilt, first) > 0) {
    throw InputError({}, fmt::format("the command '{}' is not built yet", first));
  }
  std::error_code ignored;
  if (first.starts_with('-') || std::filesystem::exists(first, ignored)) {
    arguments.insert(arguments.begin(), "run");
    return;
  }
  std::vector<std::string> known = built;
  known.insert(known.end(), unbuilt.begin(), unbuilt.end());
  throw InputError({}, fmt::format("'{}' is neither a command nor a readable plan{}", first,
                                   lsos::did_you_mean(first, known)));
}

// How an instrument prints its answer.
// What a plan's Seed may be: the library would take -1 for the greatest number.
std::string seed_fault(const std::string& text) {
  const lsos::Parsed<std::int64_t> seed = lsos::parse_integer(text);
  if (seed && *seed.value >= 0) return "";
  return "a whole number from 0 to 9223372036854775807 is wanted, found " + text;
}
const CLI::Validator is_seed(seed_fault, "0..9223372036854775807");

void add_style(CLI::App& command, lsos::AnswerStyle& style) {
  command.add_flag_callback(
      "--json", [&] { style = lsos::AnswerStyle::json; }, "JSON, as in a file or a pipe");
  command.add_flag_callback(
      "--text", [&] { style = lsos::AnswerStyle::text; }, "A table, as on a terminal");
}

// Which terrain, and which part of it.
void add_ground(CLI::App& command, lsos::TerrainOptions& terrain) {
  command.add_option("NAME", terrain.name, "A terrain script by name, or a raster")->required();
  command.add_option("--beyond", terrain.beyond,
                     "The ground where that raster ends: a coarser raster, or a terrain script");
  command.add_option("--band", terrain.band, "Of the raster: a number from 1, or a description");
  command.add_option("--nodata", terrain.nodata, "The sample that stands for none");
  command.add_option("--unit", terrain.unit, "Of its samples: m, km, dm, cm, mm, ft, us-ft");
  command.add_flag_callback(
      "--radius", [&] { terrain.is_radius = true; }, "Its samples are radii (as their size says)");
  command.add_flag_callback(
      "--no-radius", [&] { terrain.is_radius = false; }, "Its samples are no radii");
  command.add_option("--crs", terrain.crs, "In place of the raster's own: IAU_2015:30135, ...");
  command.add_option("--planet", terrain.planet, "Of a script (its raster's, else Moon)");
  command.add_option("--site", terrain.site,
                     "LON,LAT where x, y and generated ground begin (the first --at, --from, or "
                     "the window's centre)");
  command.add_option("--seed", terrain.seed, "Of generated ground (0)")->check(is_seed);
  command.add_option("--window", terrain.window,
                     "LON0,LAT0,LON1,LAT1 of the map (all of the finest raster)");
  command.add_option("--resolution", terrain.resolution_m,
                     "Cell size of the map, m (the finest raster's own grid)");
}

CLI::App* add_terrain(CLI::App& app, lsos::TerrainOptions& terrain) {
  CLI::App* command = app.add_subcommand(
      "terrain", "The ground at given places, as a raster has it and as wheels feel it");
  add_ground(*command, terrain);
  command->add_option("--at", terrain.at, "LON,LAT in degrees; may come more than once")
      ->allow_extra_args(false);
  command->add_option("--export", terrain.export_file, "Write heights as a GeoTIFF");
  command->add_flag("--hillshade", terrain.is_hillshade, "Export a hillshade, not heights");
  add_style(*command, terrain.style);
  return command;
}

CLI::App* add_light(CLI::App& app, lsos::LightOptions& light) {
  CLI::App* command =
      app.add_subcommand("light", "A map of how much of the Sun the ground sees at a time");
  add_ground(*command, light.terrain);
  command->add_option("--at", light.at, "UTC: 2026-07-01T00:00:00Z")->required();
  command->add_option("-o,--output", light.file, "The GeoTIFF to write")->required();
  command->add_option("--threads", light.threads, "Threads that work on it")
      ->check(CLI::Range(1, 256));
  add_style(*command, light.terrain.style);
  return command;
}

CLI::App* add_sight(CLI::App& app, lsos::SightOptions& sight) {
  CLI::App* command = app.add_subcommand(
      "sight", "Whether places see each other over the ground, and maps of what one sees");
  add_ground(*command, sight.terrain);
  command->add_option("--from", sight.from, "LON,LAT,H: degrees, and m above the ground")
      ->required();
  command->add_option("--to", sight.to, "LON,LAT,H; may come more than once")
      ->allow_extra_args(false);
  command->add_option("--height", sight.height_m,
                      "Of what the map looks for in each cell, m above the ground");
  command->add_option("-o,--output", sight.file, "The GeoTIFF to write: 1 seen, 0 not");
  command->add_flag("--flat", sight.is_flat, "The map as if the body did not curve");
  command->add_option("--threads", sight.threads, "Threads that work on it")
      ->check(CLI::Range(1, 256));
  add_style(*command, sight.terrain.style);
  return command;
}

CLI::App* add_picture(CLI::App& app, lsos::PictureOptions& picture) {
  CLI::App* command =
      app.add_subcommand("picture", "A rover of a run as the Sun or a camera saw it");
  command->add_option("DIR", picture.folder, "Folder of a run")->required();
  command->add_option("--at", picture.at, "UTC, or a time from the start: 90, 2 h");
  command->add_option("--from", picture.from,
                      "sun (its panels green), chase, east, above, or the RoverId of one that sees "
                      "it (sun; of a film chase)");
  command->add_option("--rover", picture.rover, "RoverId (the first)");
  command->add_option("--size", picture.size_px, "Width, pixels (1280; from sun 800)")
      ->check(CLI::Range(64, 4096));
  command->add_flag("--movie", picture.is_movie, "A film of all the run, in place of --at");
  command->add_option("--every", picture.every,
                      "Of the mission, from one of its pictures to the next (for some 250, four "
                      "in five of them while the rover drives)");
  command->add_option("-o,--output", picture.file, "The PNG, or MP4, to write")->required();
  command->add_flag("--quiet", picture.is_quiet, "No progress");
  add_style(*command, picture.style);
  return command;
}

CLI::App* add_report(CLI::App& app, lsos::ReportOptions& report) {
  CLI::App* command = app.add_subcommand("report", "Write report.html of a run again from its log");
  command->add_option("DIR", report.folder, "Folder of a run")->required();
  command->add_option("-o,--output", report.file, "DIR/report.html, or with --png DIR/report.png");
  command->add_option("--shadow-at", report.shadow_at,
                      "UTC, or a time from the start: of the shadow on the map (the start)");
  command->add_flag("!--no-pictures", report.has_pictures, "Leave them out");
  command->add_flag("--png", report.is_figure, "Its plots as a figure for a paper");
  command->add_option("--dpi", report.dpi, "Of the figure, 18 cm wide (300)")
      ->check(CLI::Range(50, 1200));
  command->add_option("--threads", report.threads, "Threads that work on the map")
      ->check(CLI::Range(1, 256));
  command->add_flag("--json", report.is_json, "The name of the file as JSON");
  return command;
}

CLI::App* add_compare(CLI::App& app, lsos::CompareOptions& compare) {
  CLI::App* command = app.add_subcommand("compare", "What differs between two runs");
  command->add_option("A", compare.folders[0], "Folder of a run")->required();
  command->add_option("B", compare.folders[1], "Folder of another")->required();
  command->add_flag("--exact", compare.is_exact, "The first differing value of the logs");
  command->add_flag("--json", compare.is_json, "The answer as JSON");
  return command;
}

CLI::App* add_verify(CLI::App& app, lsos::VerifyOptions& verify) {
  CLI::App* command = app.add_subcommand(
      "verify", "Whether the log of a run is the one that its summary was written of");
  command->add_option("DIR", verify.folders, "Folders of finished runs")->required();
  command->add_flag("--json", verify.is_json, "The answer as JSON");
  return command;
}

CLI::App* add_sun(CLI::App& app, lsos::SunOptions& sun) {
  CLI::App* command = app.add_subcommand("sun", "Sun and Earth in the sky of a place");
  command->add_option("--planet", sun.planet, "Moon, Mars or Earth")->required();
  command->add_option("--site", sun.site, "LON,LAT[,HEIGHT] in degrees and m")->required();
  command->add_option("--at", sun.at, "UTC, one or several: 2026-07-01T00:00:00Z,...")
      ->required()
      ->delimiter(',');
  add_style(*command, sun.style);
  return command;
}

int run_program(std::vector<std::string> arguments) {
  insert_run(arguments);
  CLI::App app("Simulates planetary surface missions that are drawn on a map.", "lsos-host");
  app.set_version_flag("--version", lsos::program_version);
  app.require_subcommand(1);
  app.footer("lsos-host PLAN.kml is short for lsos-host run PLAN.kml.");

  lsos::RunOptions run;
  CLI::App* run_command = app.add_subcommand("run", "Simulate a plan");
  run_command->add_option("PLAN", run.plan, "A plan: KML, KMZ or GeoPackage")->required();
  run_command->add_option("-o,--output", run.folder, "Folder of the results (out/PLAN-NAME)");
  run_command->add_flag("--force", run.is_forced,
                        "Replace an unfinished run, or without -o that of another plan");
  run_command->add_flag("!--no-report", run.has_report, "No report.html, which takes some seconds");
  run_command->add_flag("--quiet", run.is_quiet, "No progress");
  run_command->add_flag("--json", run.is_json, "The summary as JSON");
  bool is_watched = false;
  run_command->add_flag("--watch", is_watched, "Run again whenever the plan or a script changes");
  run_command->add_option("--threads", run.threads, "Threads that step rovers")
      ->check(CLI::Range(1, 256));
  run_command->add_option("--seed", run.seed, "Instead of the plan's Seed")->check(is_seed);
  run_command->add_flag("--save-every-exchange", run.save_every_exchange,
                        "Write all state out and read it back every 0.1 s (a test of resuming)");

  lsos::CheckOptions check;
  CLI::App* check_command = app.add_subcommand("check", "Read and check a plan");
  check_command->add_option("PLAN", check.plan, "A plan: KML, KMZ or GeoPackage")->required();
  check_command->add_option("--seed", check.seed, "Instead of the plan's Seed")->check(is_seed);
  check_command->add_flag("--json", check.is_json, "The answer as JSON");
  check_command->add_flag("--verbose", check.is_verbose, "Each default and assumption");
  check_command->add_flag("--quiet", check.is_quiet, "No progress");

  bool is_json = false;
  std::string fsm_plan;
  CLI::App* fsm_command =
      app.add_subcommand("fsm", "The machine synthesised from a plan, as Graphviz DOT");
  fsm_command->add_option("PLAN", fsm_plan, "A plan: KML, KMZ or GeoPackage")->required();

  fsm_command->add_flag("--json", is_json, "As JSON");

  lsos::ListOptions list;
  CLI::App* list_command = app.add_subcommand("list", "What a plan can name");
  list_command->add_option("WHAT", list.what, "events, rovers, terrains or soils")
      ->required()
      ->check(CLI::IsMember({"events", "rovers", "terrains", "soils"}));
  list_command->add_option("NAME", list.name, "Only this one");
  list_command->add_flag("--json", list.is_json, "As JSON");

  lsos::TestOptions test;
  CLI::App* test_command =
      app.add_subcommand("test", "Run scenarios: scripts that say what must come of a mission");
  test_command->add_option("PATH", test.paths, "Files, or folders of them (tests/scenarios)");
  test_command->add_option("--filter", test.filter, "Only those with this in their name or file");
  test_command->add_option("--junit", test.junit_file, "Write the results as JUnit XML too");
  test_command->add_option("-o,--output", test.folder, "Logs of those that fail (out/scenarios)");
  test_command->add_option("--threads", test.threads, "Files at a time (2)")
      ->check(CLI::Range(1, 256));
  test_command->add_flag("--json", test.is_json, "The results as JSON, in place of TAP");

  std::string repl_plan;
  CLI::App* repl_command =
      app.add_subcommand("repl", "A prompt with a simulation in hand; piped input is a script");
  repl_command->add_option("PLAN", repl_plan, "A plan: KML, KMZ or GeoPackage");

  lsos::SchemaOptions schema;
  CLI::App* schema_command = app.add_subcommand(
      "schema", "KML <Schema> elements of events, and a plan with one Placemark of each");
  schema_command->add_option("NAME", schema.names, "Events (all)");
  schema_command->add_option("-o,--output", schema.file,
                             "X.kml, or X.gpkg: empty layers with forms, to draw a plan in QGIS");
  schema_command->add_option("--planet", schema.planet,
                             "Of the layers: Moon, Mars or Earth (Moon)");
  schema_command->add_flag("--json", schema.is_json, "The fields of each as JSON, in place of KML");

  lsos::NewOptions fresh;
  CLI::App* new_command = app.add_subcommand("new", "A plan or script that works, to begin from");
  new_command->add_option("WHAT", fresh.what, "plan, event, rover, terrain or scenario")
      ->required()
      ->check(CLI::IsMember({"plan", "event", "rover", "terrain", "scenario"}));
  new_command->add_option("NAME", fresh.name, "What it shall be called: DropBeacon")->required();
  new_command->add_option("--from", fresh.from, "A rover type (SEV); of a terrain a raster");
  new_command->add_option("--planet", fresh.planet, "Of a plan: Moon, Mars or Earth (Moon)");
  new_command->add_option("--terrain", fresh.terrain, "Of a plan: a script or raster (Craters)");
  new_command->add_option("--site", fresh.site, "LON,LAT where the rover of a plan starts (0,0)");
  new_command->add_flag("--json", fresh.is_json, "The names of the files as JSON");

  std::string overlay_folder;
  bool overlay_is_packed = false;
  CLI::App* overlay_command =
      app.add_subcommand("overlay", "Write overlay.kml of a run again from its log");
  overlay_command->add_option("DIR", overlay_folder, "Folder of a run")->required();

  overlay_command->add_flag("--kmz", overlay_is_packed,
                            "Write overlay.kmz instead, a tenth of the size and with its icons");
  overlay_command->add_flag("--json", is_json, "The name of the file as JSON");

  lsos::RigOptions rig;
  CLI::App* rig_command =
      app.add_subcommand("rig", "A single-wheel test bed: one wheel on a soil at given slips");
  rig_command->add_option("--soil", rig.soil, "A soil by name, or a Lua file")->required();
  rig_command->add_option("--radius", rig.radius_m, "Of the wheel's rim, m")->required();
  rig_command->add_option("--width", rig.width_m, "m")->required();
  rig_command->add_option("--load", rig.load_n, "On the wheel, N")->required();
  rig_command->add_option("--slip", rig.slips, "-1..1, one or several: 0,0.2,0.5")
      ->required()
      ->delimiter(',');
  rig_command->add_option("--slip-angle", rig.slip_angle_deg,
                          "Of the travel from the heading, deg, to the left positive");
  rig_command->add_option("--grouser-height", rig.grouser_height_m, "m");
  rig_command->add_option("--grouser-count", rig.grouser_count, "Round the whole rim");
  rig_command->add_option("--interface-friction", rig.interface_friction_ratio,
                          "Friction of soil on the rim over that in the soil, 0..1 (0.8)");
  rig_command->add_option("--stiffness", rig.stiffness_npm,
                          "Of the wheel, N/m (the load flattens it by 1 % of its radius)");
  rig_command->add_option("--gravity", rig.gravity_mps2, "m/s2 (9.80665)");
  add_style(*rig_command, rig.style);

  lsos::TerrainOptions terrain;
  CLI::App* terrain_command = add_terrain(app, terrain);

  lsos::LightOptions light;
  CLI::App* light_command = add_light(app, light);

  lsos::SightOptions sight;
  CLI::App* sight_command = add_sight(app, sight);

  lsos::PictureOptions picture;
  CLI::App* picture_command = add_picture(app, picture);

  lsos::ReportOptions report;
  CLI::App* report_command = add_report(app, report);

  lsos::CompareOptions compare;
  CLI::App* compare_command = add_compare(app, compare);

  lsos::VerifyOptions verify;
  CLI::App* verify_command = add_verify(app, verify);

  lsos::SunOptions sun;
  CLI::App* sun_command = add_sun(app, sun);

  // Every command takes what any may be given, so that scripts need not know which has a use for
  // it.
  bool is_quiet = false;
  int threads = 1;
  for (CLI::App* command : app.get_subcommands({})) {
    if (!command->get_option_no_throw("--quiet")) command->add_flag("--quiet", is_quiet)->group("");
    if (!command->get_option_no_throw("--threads")) {
      command->add_option("--threads", threads)->check(CLI::Range(1, 256))->group("");
    }
  }

  try {
    std::ranges::reverse(arguments);  // as CLI11 takes them
    app.parse(arguments);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  if (run_command->parsed()) return is_watched ? lsos::watch_command(run) : lsos::run_command(run);
  if (check_command->parsed()) return lsos::check_command(check);
  if (fsm_command->parsed()) return lsos::fsm_command(fsm_plan, is_json);
  if (rig_command->parsed()) return lsos::rig_command(rig);
  if (terrain_command->parsed()) return lsos::terrain_command(terrain);
  if (picture_command->parsed()) return lsos::picture_command(picture);
  if (report_command->parsed()) return lsos::report_command(report);
  if (compare_command->parsed()) return lsos::compare_command(compare);
  if (verify_command->parsed()) return lsos::verify_command(verify);
  if (light_command->parsed()) return lsos::light_command(light);
  if (sight_command->parsed()) return lsos::sight_command(sight);
  if (sun_command->parsed()) return lsos::sun_command(sun);
  if (repl_command->parsed()) return lsos::repl_command(repl_plan);
  if (schema_command->parsed()) return lsos::schema_command(schema);
  if (new_command->parsed()) return lsos::new_command(fresh);
  if (test_command->parsed()) return lsos::test_command(test);
  if (list_command->parsed()) return lsos::list_command(list);
  return lsos::overlay_command(overlay_folder, overlay_is_packed, is_json);
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);
  // Beyond a file size limit a write must fail and be reported, not kill the program.
  std::signal(SIGXFSZ, SIG_IGN);
  lsos::open_missing_streams();
  try {
    const int code = run_program({argv + 1, argv + argc});
    lsos::flush_results();
    return code;
  } catch (const InputError& error) {
    lsos::print_message("{}\n", error.what());
    return 2;
  } catch (const std::filesystem::filesystem_error& error) {
    // A folder that may not be entered, most of all.
    lsos::print_message("{}: {}\n", error.path1().string(), error.code().message());
    return error.code() == std::errc::no_space_on_device ? 3 : 2;
  } catch (const lsos::OutputError& error) {
    lsos::print_message("{}\n", error.what());
    return 3;
  } catch (const std::exception& error) {
    lsos::print_message("fault inside the program: {}\n", error.what());
    return 3;
  }
}
