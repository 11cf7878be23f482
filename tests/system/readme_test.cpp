// Runs the commands that the READMEs show, and checks the scripts and links that they name.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <regex>

#include "system/process.h"
#include "system/run_folder.h"
#include "system/source_files.h"
#include "system/temp_folder.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;

const std::string program_folder = fs::path(LSOS_PROGRAM).parent_path();

// script/run builds in the folder of these tests, where everything is up to date.
Words environment() {
  return {"LSOS_BUILD=" LSOS_BUILD_DIR, "PATH=" + program_folder + ":" + std::getenv("PATH")};
}

// The commands in fenced sh blocks that start the program; a trailing backslash joins lines. Files
// that are written as `cat > NAME <<'END'` are commands too.
Words shown_commands(const fs::path& file) {
  const std::string end_of_file = "END";
  Words commands;
  bool is_in_block = false;
  std::string command;
  for (const std::string& line : read_lines(file)) {
    if (command.starts_with("cat > ")) {
      command += "\n" + line;
      if (line != end_of_file) continue;
      commands.push_back(command);
      command.clear();
      continue;
    }
    if (line.starts_with("```")) {
      is_in_block = line == "```sh";
      continue;
    }
    if (!is_in_block) continue;
    command += line;
    if (command.starts_with("cat > ")) continue;
    if (command.ends_with('\\')) {
      command.pop_back();
      continue;
    }
    if (command.starts_with("script/run ") || command.starts_with("lsos-host ")) {
      commands.push_back(command);
    }
    command.clear();
  }
  return commands;
}

// All Markdown files of the repository.
std::vector<fs::path> documents() {
  std::vector<fs::path> files;
  for (const auto& folder : fs::directory_iterator(repository())) {
    const std::string name = folder.path().filename();
    if (name.starts_with('.') || name == "build" || name == "out") continue;
    if (folder.path().extension() == ".md") files.push_back(name);
    if (!folder.is_directory()) continue;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.path().extension() == ".md") {
        files.push_back(fs::relative(entry.path(), repository()));
      }
    }
  }
  std::ranges::sort(files);
  return files;
}

// The Markdown files that show commands.
std::vector<std::string> readmes() {
  std::vector<std::string> files;
  for (const fs::path& file : documents()) {
    if (!shown_commands(repository() / file).empty()) files.push_back(file);
  }
  return files;
}

std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::ranges::replace_if(
      name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

class Readme : public ::testing::TestWithParam<std::string> {};

// Commands run in a folder that mirrors the repository, so that their results are not left in it.
TEST_P(Readme, shows_commands_that_work) {
  const fs::path file = repository() / GetParam();
  ASSERT_TRUE(fs::exists(file)) << GetParam() << " is not there";
  const TempFolder folder;
  for (const auto& entry : fs::directory_iterator(repository())) {
    const std::string name = entry.path().filename();
    if (name == "build" || name == "out" || name == ".git") continue;
    fs::create_symlink(entry.path(), folder / name);
  }
  for (const std::string& command : shown_commands(file)) {
    const Outcome outcome = run_command({"bash", "-o", "pipefail", "-c", command},
                                        {.folder = folder.path(), .environment = environment()});
    EXPECT_EQ(outcome.exit_code, 0) << "$ " << command << "\n" << outcome.err;
  }
}

INSTANTIATE_TEST_SUITE_P(Documents, Readme, ::testing::ValuesIn(readmes()), test_name);

// Links to files of the repository, such as "](docs/picture.png)".
TEST(Documents, link_to_what_is_there) {
  const std::regex link(R"(\]\(([^)#:]+)(#[^)]*)?\))");
  int count = 0;
  for (const fs::path& file : documents()) {
    const std::string text = read_text(repository() / file);
    for (auto at = std::sregex_iterator(text.begin(), text.end(), link);
         at != std::sregex_iterator(); ++at) {
      ++count;
      const fs::path target = (repository() / file).parent_path() / (*at)[1].str();
      EXPECT_TRUE(fs::exists(target)) << file << " links to " << (*at)[1];
    }
  }
  EXPECT_GT(count, 10);
}

// The first fenced block of that language.
std::string shown_block(const std::string& language, const std::string& file = "README.md") {
  std::string block;
  bool is_in_block = false;
  for (const std::string& line : read_lines(repository() / file)) {
    if (is_in_block && line == "```") break;
    if (is_in_block) block += line + "\n";
    if (line == "```" + language) is_in_block = true;
  }
  return block;
}

TEST(FirstEvent, of_the_readme_works_beside_a_plan_without_building) {
  const TempFolder folder;
  folder.write("events/Beacon.lua", shown_block("lua"));
  std::string plan = read_text(repository() / "plans" / "first_drive.kml");
  plan.insert(plan.rfind("</Document>"), shown_block("xml"));
  const std::string file = folder.write("plan.kml", plan);
  const Outcome outcome = run({file, "-o", folder / "run", "--quiet"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  const fs::path log = folder / "run" / "log.gpkg";
  EXPECT_EQ(query(log, "select name from notes where sequence = 25"), "beacon");
  EXPECT_EQ(query(log, "select status from events where type = 'Beacon'"), "completed");
}

TEST(TerrainCommand, of_the_readme_shows_the_floor_and_the_rim_of_a_crater) {
  const Words commands = shown_commands(repository() / "README.md");
  const auto command = std::ranges::find_if(commands, [](const std::string& text) {
    return text.starts_with("script/run terrain Craters") && text.find("--at") != text.npos;
  });
  ASSERT_NE(command, commands.end());
  const Outcome outcome =
      run_command({"bash", "-c", *command}, {.folder = repository(), .environment = environment()});
  const auto points = nlohmann::json::parse(outcome.out);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_LT(points[0]["height_m"].get<double>(), -1.5);
  EXPECT_GT(points[1]["height_m"].get<double>(), 0.3);
}

// Distance driven in a plan according to plans/README.md.
double shown_distance_m(const std::string& plan) {
  const std::regex row("\\| `" + plan + "` \\| [^|]+ \\| ([0-9]+) m \\|");
  std::smatch found;
  const std::string text = read_text(repository() / "plans" / "README.md");
  return std::regex_search(text, found, row) ? std::stod(found[1]) : 0;
}

TEST(PlansReadme, says_how_far_rovers_drive) {
  for (const std::string plan : {"crater_crossing", "first_drive", "solar_stop", "two_rovers"}) {
    const TempFolder folder;
    const std::string file =
        folder.write(plan + ".kml", read_text(repository() / "plans" / (plan + ".kml")));
    ASSERT_EQ(run({file, "-o", folder / "run", "--quiet", "--no-report"}).exit_code, 0) << plan;
    double driven_m = 0;
    const auto of_run = summary(folder / "run");
    for (const auto& rover : of_run["rovers"]) driven_m += rover["distance_m"].get<double>();
    EXPECT_NEAR(driven_m, shown_distance_m(plan), 3) << plan;
  }
}

TEST(StudiesPage, shows_a_study_that_is_sound) {
  const TempFolder folder;
  folder.write("solar_stop.kml", read_text(repository() / "plans" / "solar_stop.kml"));
  folder.write("solar_stop_study.lua", shown_block("lua", "docs/studies.md"));
  const Outcome outcome = run({"sweep", "solar_stop_study.lua", "--dry-run", "--json", "--quiet"},
                              {.folder = folder.path()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto answer = nlohmann::json::parse(outcome.out);
  ASSERT_EQ(answer["cases"].size(), 6u);
  EXPECT_TRUE(answer["cases"][0]["values"].contains("Rover SEV1.Place.east_m"));
  EXPECT_GT(answer["case_wall_s"], 0) << "a case of it was run";
}

TEST(TerrainReadme, shows_a_terrain_of_rasters_that_works) {
  const TempFolder folder;
  folder.write("terrain/Nested.lua", shown_block("lua", "terrain/README.md"));
  const auto write = [&](const char* name, const char* window, const char* resolution_m) {
    const Outcome outcome = run({"terrain", "Craters", "--window", window, "--resolution",
                                 resolution_m, "--export", folder / "terrain" / name});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  };
  write("site_1m.tif", "10,-80,10.02,-79.997", "1");
  write("pole_20m.tif", "9.8,-80.03,10.2,-79.97", "20");
  const Outcome outcome =
      run({"terrain", "Nested", "--at", "10.01,-79.9985", "--at", "10.1,-79.98"},
          {.environment = {"LSOS_PATH=" + folder.path().string()}});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto points = nlohmann::json::parse(outcome.out);
  for (const auto& point : points) {
    // Detail adds some decimetres to the rasters' heights.
    EXPECT_NEAR(point["height_m"].get<double>(), point["raster_height_m"].get<double>(), 2);
    EXPECT_NE(point["height_m"], point["raster_height_m"]);
  }
}

TEST(ScriptRun, is_the_program_from_any_folder) {
  const TempFolder folder;
  const Outcome direct = run({"list", "events"}, {.folder = folder.path()});
  const Outcome scripted = run_command({repository() / "script" / "run", "list", "events"},
                                       {.folder = folder.path(), .environment = environment()});
  ASSERT_EQ(direct.exit_code, 0) << direct.err;
  EXPECT_EQ(scripted.exit_code, 0) << scripted.err;
  EXPECT_EQ(scripted.out, direct.out);
}

TEST(ScriptRun, passes_on_the_exit_code) {
  const Outcome outcome =
      run_command({repository() / "script" / "run", "nowhere.kml"}, {.environment = environment()});
  EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
}

TEST(ScriptBootstrap, knows_its_groups) {
  const std::string script = repository() / "script" / "bootstrap";
  EXPECT_EQ(run_command({script, "toys"}).exit_code, 2);
}

}  // namespace
}  // namespace lsos::test
