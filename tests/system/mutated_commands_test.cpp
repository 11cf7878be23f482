// Commands of the built program on files that chance has changed: whatever stands in them, a
// command ends by itself, soon, and with a message rather than a fault of the program.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <functional>

#include "plan/kml_writer.h"
#include "system/moon_ground.h"
#include "system/mutations.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;

constexpr int cpu_max_s = 20;
constexpr double memory_max_mib = 2048;
constexpr int parts = 8;  // tests that share the cases

std::size_t setting(const char* name, std::size_t otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::stoul(text);
}

std::vector<Mark> small_plan() {
  return {mission({{"LogInterval", "2"}}),
          sev("SEV1", "0,0"),
          rover("MER", "MER1", "0.0003,0.0003"),
          event("Route", "SEV1", 10, {{"Speed", "2"}}, line("0,0 0.0005,0")),
          event("Pause", "SEV1", 20, {{"Duration", "20"}}),
          event("PathPlanRoute", "MER1", 10, {{"StartAfter", "SEV1/10"}}, point("0.0002,0.0003")),
          event("Recharge", "MER1", 20, {{"EnergyRate", "100"}, {"Duration", "10"}})};
}

// The sound files, made once: a plan, its run, rasters, tables.
class Sound {
 public:
  Sound() {
    const std::string plan = kml(small_plan());
    folder.write("plan.kml", plan);
    std::ofstream(folder / "plan.kmz", std::ios::binary) << pack_kmz(plan);
    EXPECT_EQ(call({"run", "plan.kml", "-o", "run", "--checkpoint-every", "10", "--quiet"}), 0);
    fs::copy(folder / "run", folder / "other", fs::copy_options::recursive);
    folder.write("telemetry.csv",
                 "time,rover,lon,lat,charge\n2026-01-01T00:00:02Z,SEV1,0.0001,0,0.9\n"
                 "2026-01-01T00:00:04Z,SEV1,0.0002,0,0.8\n");
    call({"export", "plan.kml", "-o", "sheet.csv", "--force"});  // 2 where the plan has doubts
    EXPECT_TRUE(fs::exists(folder / "sheet.csv"));
    write_raster(folder, "dem", 24, [](double x_m, double y_m) { return 0.1 * x_m - 0.02 * y_m; });
    EXPECT_EQ(call({"terrain", "terrain/dem.asc", "--export", "dem.tif"}), 0);
    std::ofstream(folder / "dem.zip", std::ios::binary)
        << pack_zip({{"dem.tif", read_text(folder / "dem.tif")}});
    write_terrain(folder, "Bumpy", "lsos.plane { slope = 2 }", "'ApolloNominal'");
    folder.write("save.lua",
                 "local lsos = require 'lsos'\nlsos.scenario('saves', function(t)\n  local sim = "
                 "lsos.sim('plan.kml')\n  sim:run_for(12)\n  sim:save('saved.state')\nend)\n");
    folder.write("load.lua",
                 "local lsos = require 'lsos'\nlsos.scenario('loads', function(t)\n  local sim = "
                 "lsos.sim('plan.kml')\n  sim:load('saved.state')\n  sim:step(20)\nend)\n");
    EXPECT_EQ(call({"test", "save.lua"}), 0);
  }

  int call(const Words& words) const { return run(words, {folder.path(), {}, 0}).exit_code; }

  TempFolder folder;
};

// One kind of input: how it is changed in a copy of the sound files, and the commands that read it.
struct Kind {
  const char* name;
  std::vector<std::string> files;  // that are copied
  std::function<void(const fs::path& folder, Random& random)> mutate;
  std::vector<Words> commands;
};

using Change = std::string (*)(std::string, Random&);

auto file_changer(const char* name, Change change) {
  return [name, change](const fs::path& folder, Random& random) {
    const std::string bytes = change(read_text(folder / name), random);
    std::ofstream(folder / name, std::ios::binary | std::ios::trunc) << bytes;
  };
}

const std::vector<Words>& log_commands() {
  static const std::vector<Words> commands{
      {"overlay", "run"},
      {"overlay", "run", "--kmz"},
      {"report", "run", "--no-pictures"},
      {"report", "run"},
      {"report", "run", "--png"},
      {"report", "run", "other", "-o", "both.html"},
      {"compare", "run", "other"},
      {"compare", "other", "run", "--exact"},
      {"compare", "run", "telemetry.csv", "-o", "telemetry.html"},
      {"verify", "run"},
      {"picture", "run", "--at", "12", "-o", "x.png", "--size", "320"},
      {"check", "plan.kml", "--from", "run"},
      {"branch", "run", "--at", "20", "-o", "branch"},
  };
  return commands;
}

const std::vector<Kind>& kinds() {
  static const std::vector<Words> check_plan{{"check", "plan.kml", "--json"},
                                             {"check", "plan.kml", "--verbose"},
                                             {"check", "plan.kml", "--kml", "notes.kml"},
                                             {"fsm", "plan.kml"},
                                             {"export", "plan.kml", "-o", "plan.xlsx"}};
  static const std::vector<std::string> run_files{"plan.kml", "telemetry.csv", "run", "other"};
  static const std::vector<Kind> all{
      {"bytes of a plan", {"plan.kml"}, file_changer("plan.kml", mutated_bytes), check_plan},
      {"values of a plan", {"plan.kml"}, file_changer("plan.kml", mutated_kml), check_plan},
      {"bytes of an archive",
       {"plan.kmz"},
       file_changer("plan.kmz", mutated_bytes),
       {{"check", "plan.kmz"}, {"fsm", "plan.kmz"}}},
      {"cells of a log", run_files,
       [](const fs::path& folder, Random& random) {
         mutate_cells(folder / "run/log.gpkg", random);
       },
       log_commands()},
      {"bytes of a log", run_files, file_changer("run/log.gpkg", mutated_bytes), log_commands()},
      {"a checkpoint",
       run_files,
       [](const fs::path& folder, Random& random) {
         mutate_checkpoint(folder / "run/log.gpkg", random);
         fs::remove(folder / "run/summary.json");
       },
       {{"resume", "run", "--quiet"}, {"branch", "run", "--at", "20", "-o", "branch"}}},
      {"a saved state",
       {"plan.kml", "saved.state", "load.lua"},
       [](const fs::path& folder, Random& random) {
         const std::string bytes = mutated_after_hash(read_text(folder / "saved.state"), random);
         std::ofstream(folder / "saved.state", std::ios::binary | std::ios::trunc) << bytes;
       },
       {{"test", "load.lua"}}},
      {"kept routes",
       {"plan.kml", "plan.kml.routes"},
       [](const fs::path& folder, Random& random) {
         const std::string bytes =
             mutated_after_hash(read_text(folder / "plan.kml.routes"), random);
         std::ofstream(folder / "plan.kml.routes", std::ios::binary | std::ios::trunc) << bytes;
       },
       {{"check", "plan.kml", "--verbose"}}},
      {"a summary",
       run_files,
       file_changer("run/summary.json", mutated_json),
       {{"compare", "run", "other"},
        {"compare", "run", "other", "other"},
        {"report", "run", "--no-pictures"},
        {"report", "other", "run", "-o", "both.html"},
        {"verify", "run"}}},
      {"a raster",
       {"dem.tif"},
       file_changer("dem.tif", mutated_bytes),
       {{"terrain", "dem.tif", "--at", "0,0"},
        {"terrain", "dem.tif", "--export", "x.tif", "--hillshade"},
        {"sight", "dem.tif", "--from", "0,0,2", "--horizon", "--step", "30"},
        {"light", "dem.tif", "--at", "2026-01-01T00:00:00Z", "-o", "x.tif"}}},
      {"a raster in an archive",
       {"dem.zip"},
       file_changer("dem.zip", mutated_bytes),
       {{"terrain", "/vsizip/dem.zip/dem.tif", "--at", "0,0"},
        {"terrain", "/vsizip/dem.zip/dem.tif", "--export", "x.tif", "--hillshade"}}},
      {"a terrain's script",
       {"terrain"},
       file_changer("terrain/Bumpy.lua", mutated_bytes),
       {{"terrain", "Bumpy", "--at", "0,0"}}},
      {"a sheet",
       {"sheet.csv"},
       file_changer("sheet.csv", mutated_bytes),
       {{"import", "sheet.csv", "-o", "made.kml", "--force"}}},
  };
  return all;
}

std::string joined(const Words& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

// What is wrong with how a command ended; "": nothing.
std::string fault_of(const Outcome& outcome) {
  if (outcome.was_killed) return fmt::format("ended by signal {}", outcome.exit_code - 128);
  if (outcome.exit_code > 2) return fmt::format("exit code {}", outcome.exit_code);
  if (outcome.cpu_s > cpu_max_s) return fmt::format("took {:.1f} s", outcome.cpu_s);
  if (outcome.memory_mib > memory_max_mib)
    return fmt::format("took {:.0f} MiB", outcome.memory_mib);
  return "";
}

void run_case(const Sound& sound, std::size_t number, std::size_t seed) {
  Random random(seed * 1'000'003 + number);
  const Kind& kind = kinds()[number % kinds().size()];
  const TempFolder folder;
  for (const std::string& name : kind.files) {
    if (!fs::exists(sound.folder / name)) continue;
    fs::create_directories((folder / name).parent_path());
    fs::copy(sound.folder / name, folder / name, fs::copy_options::recursive);
  }
  kind.mutate(folder.path(), random);
  const Words& command = kind.commands[any(random, kind.commands.size())];
  const Outcome outcome = run(command, {folder.path(), {}, cpu_max_s + 5});
  const std::string fault = fault_of(outcome);
  if (fault.empty()) return;
  const fs::path kept = fs::path(LSOS_BUILD_DIR) / fmt::format("findings/{}-{}", seed, number);
  fs::remove_all(kept);
  fs::create_directories(kept.parent_path());
  fs::copy(folder.path(), kept, fs::copy_options::recursive);
  ADD_FAILURE() << "case " << number << " of seed " << seed << ", " << kind.name << ": lsos-host "
                << joined(command) << ": " << fault << "\nin " << kept << "\n"
                << outcome.err.substr(0, 500);
}

class MutatedCommands : public ::testing::TestWithParam<int> {};

// LSOS_MUTATIONS and LSOS_MUTATION_SEED: how many cases there are in all, and from which seed;
// LSOS_MUTATION_CASE: that case alone.
TEST_P(MutatedCommands, end_by_themselves) {
  static const Sound sound;
  const std::size_t seed = setting("LSOS_MUTATION_SEED", 41);
  const std::size_t one = setting("LSOS_MUTATION_CASE", 0);
  const std::size_t last = one == 0 ? setting("LSOS_MUTATIONS", 2000) : one;
  for (std::size_t number = one == 0 ? 1 : one; number <= last; ++number) {
    if (static_cast<int>(number % parts) == GetParam()) run_case(sound, number, seed);
  }
}

INSTANTIATE_TEST_SUITE_P(Parts, MutatedCommands, ::testing::Range(0, parts));

}  // namespace
}  // namespace lsos::test
