// Folders that come from elsewhere: nothing is written through what lies in them, and nothing of
// others is removed.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "system/killed_runs.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

const Words quick{"--quiet", "--no-report"};

std::vector<Mark> pause() {
  return {mission(), sev("A", "31.0,20.0"), event("Pause", "A", 10, {{"Duration", "5"}})};
}

// A folder with links to a file of the user's.
class ReceivedFolder : public ::testing::Test {
 protected:
  void link(const std::string& name) const {
    fs::create_directories((folder_ / name).parent_path());
    fs::remove_all(folder_ / name);
    fs::create_symlink(folder_ / "victim/file", folder_ / name);
  }
  void link_to_folder(const std::string& name) const {
    fs::create_directories((folder_ / name).parent_path());
    fs::create_directory_symlink(folder_ / "victim", folder_ / name);
  }
  void expect_intact() const {
    EXPECT_EQ(read_text(folder_ / "victim/file"), "theirs");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "victim"), {}), 1);
  }
  Outcome run_there(const Words& words) const { return run(words, {.folder = folder_.path()}); }
  // Runs the plan into `name` once.
  void finished_run(const std::string& name) const {
    ASSERT_EQ(run_there(with({"run", plan_, "-o", name}, quick)).exit_code, 0);
  }

  TempFolder folder_;
  std::string victim_ = folder_.write("victim/file", "theirs");
  std::string plan_ = folder_.write("plan.kml", kml(pause()));
};

TEST_F(ReceivedFolder, of_a_run_has_links_under_names_of_its_files) {
  finished_run("run");
  for (const char* name : {"summary.json", "overlay.kml", "log.gpkg", "log.gpkg-wal",
                           "log.gpkg-journal", ".lsos-host.lock", ".lsos-host.earlier"}) {
    fs::remove_all(folder_ / "copy");
    fs::copy(folder_ / "run", folder_ / "copy");
    link(std::string("copy/") + name);
    const Outcome outcome = run_there(with({"run", plan_, "-o", "copy"}, quick));
    EXPECT_EQ(outcome.exit_code, 2) << name;
    EXPECT_THAT(outcome.err, HasSubstr("copy: holds files that are no run of lsos-host")) << name;
    expect_intact();
  }
}

TEST_F(ReceivedFolder, of_a_run_has_links_under_names_of_parts) {
  finished_run("run");
  for (const char* name : {"summary.json", "overlay.kml", "plan.kml", "report.html", "mission.qgz",
                           "hillshade.tif", "report.png"}) {
    link(std::string("run/") + name + ".lsos-host.part");
    link(std::string("run/") + name + ".lsos-host.part.ovr.tmp");
    link(std::string("run/") + name + ".lsos-host.part.aux.xml");
  }
  for (const Words& words :
       {Words{"overlay", "run"}, Words{"report", "run", "--no-pictures"},
        Words{"report", "run", "--png"}, Words{"run", plan_, "-o", "run", "--quiet"}}) {
    EXPECT_EQ(run_there(words).exit_code, 0) << words.front();
    expect_intact();
  }
  EXPECT_EQ(summary(folder_ / "run")["status"], "completed");
}

TEST_F(ReceivedFolder, has_products_that_are_links_replaced) {
  finished_run("run");
  for (const char* name : {"overlay.kml", "report.html"}) link(std::string("run/") + name);
  EXPECT_EQ(run_there({"overlay", "run"}).exit_code, 0);
  EXPECT_EQ(run_there({"report", "run", "--no-pictures"}).exit_code, 0);
  expect_intact();
  for (const char* name : {"overlay.kml", "report.html"}) {
    EXPECT_FALSE(fs::is_symlink(folder_ / "run" / name)) << name;
  }
}

TEST_F(ReceivedFolder, has_products_that_are_no_files_refused) {
  finished_run("run");
  fs::remove(folder_ / "run/overlay.kml");
  ASSERT_EQ(mkfifo((folder_ / "run/overlay.kml").c_str(), 0666), 0);
  const Outcome pipe = run_there({"overlay", "run"});
  EXPECT_EQ(pipe.exit_code, 2);
  EXPECT_THAT(pipe.err, HasSubstr("overlay.kml: is a named pipe, and no file that could be"));
  fs::create_symlink("/dev/null", folder_ / "null.csv");
  const Outcome device = run_there({"check", plan_, "--csv", "null.csv"});
  EXPECT_EQ(device.exit_code, 2);
  EXPECT_THAT(device.out + device.err, HasSubstr("null.csv: is a device, and no file"));
  EXPECT_TRUE(fs::is_symlink(folder_ / "null.csv"));
}

TEST_F(ReceivedFolder, has_links_beside_files_that_commands_write) {
  finished_run("run");
  folder_.write("ppr.kml", kml({mission(), sev("A", "31.0,20.0"),
                                event("PathPlanRoute", "A", 10, {}, line("31,20 31.0005,20"))}));
  const Words window{"--window", "31,20,31.001,20.001", "--resolution", "1"};
  const std::vector<std::pair<std::string, Words>> commands{
      {"a.png", {"picture", "run", "--at", "2", "--size", "64", "-o", "a.png"}},
      {"a.csv", {"check", plan_, "--csv", "a.csv"}},
      {"b.kml", {"check", plan_, "--kml", "b.kml"}},
      {"c.gpkg", {"schema", "Pause", "-o", "c.gpkg"}},
      {"d.kml", {"schema", "Pause", "-o", "d.kml"}},
      {"e.xlsx", {"export", plan_, "-o", "e.xlsx"}},
      {"e.gpkg", {"export", plan_, "-o", "e.gpkg"}},
      {"f.kml", {"edit", plan_, "disable", "A/10", "-o", "f.kml"}},
      {"g.html", {"report", "run", "--no-pictures", "-o", "g.html"}},
      {"h.tif", with({"terrain", "Flat", "--export", "h.tif"}, window)},
      {"i.tif", with({"light", "Flat", "--at", "2026-07-01", "-o", "i.tif"}, window)},
      {"ppr.kml.routes", {"check", "ppr.kml", "--quiet"}}};
  for (const auto& [name, words] : commands) {
    for (const char* ending : {".lsos-host.part", ".lsos-host.part.ovr.tmp",
                               ".lsos-host.part.aux.xml", "-journal", "-wal"}) {
      link(name + ending);
    }
    const Outcome outcome = run_there(words);
    EXPECT_EQ(outcome.exit_code, 0) << name << outcome.out << outcome.err;
    EXPECT_TRUE(fs::is_regular_file(folder_ / name)) << name;
    expect_intact();
  }
  // Names that are taken by a link.
  for (const auto& [name, words] : commands) {
    link(name);
    const Outcome outcome = run_there(words);
    EXPECT_THAT(outcome.exit_code, ::testing::AnyOf(0, 2)) << name << outcome.err;
    expect_intact();
  }
}

TEST_F(ReceivedFolder, has_its_own_file_under_the_name_of_kept_routes) {
  folder_.write("ppr.kml", kml({mission(), sev("A", "31.0,20.0"),
                                event("PathPlanRoute", "A", 10, {}, line("31,20 31.0005,20"))}));
  folder_.write("ppr.kml.routes", "a list of bus routes");
  const Outcome outcome = run_there({"check", "ppr.kml", "--quiet"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out,
              HasSubstr("ppr.kml.routes: warning: holds something else: planned routes would "
                        "be kept under this name, and are not"));
  EXPECT_EQ(read_text(folder_ / "ppr.kml.routes"), "a list of bus routes");
}

TEST_F(ReceivedFolder, is_reached_by_no_link) {
  link_to_folder("named");
  const Outcome named = run_there(with({"run", plan_, "-o", "named"}, quick));
  EXPECT_EQ(named.exit_code, 2);
  EXPECT_THAT(named.err, HasSubstr("named: is a link, to " + (folder_ / "victim").string() +
                                   ": nothing is written through it"));
  // What the user has not named may be a link at any place.
  link_to_folder("out");
  const Outcome unnamed = run_there(with({"run", plan_}, quick));
  EXPECT_EQ(unnamed.exit_code, 2);
  EXPECT_THAT(unnamed.err, HasSubstr("out: is a link, to "));
  link_to_folder("events");
  const Outcome made = run_there({"new", "event", "Beacon"});
  EXPECT_EQ(made.exit_code, 2);
  EXPECT_THAT(made.err, HasSubstr("events: is a link, to "));
  const Outcome prompt =
      run_command({"bash", "-c", "echo 'print(1)' | '" LSOS_PROGRAM "' repl '" + plan_ + "'"},
                  {.folder = folder_.path()});
  EXPECT_EQ(prompt.exit_code, 2);
  EXPECT_THAT(prompt.err, HasSubstr("out: is a link, to "));
  expect_intact();
}

TEST_F(ReceivedFolder, gets_no_new_file_through_a_link_that_leads_nowhere) {
  fs::create_directory(folder_ / "events");
  fs::create_symlink(folder_ / "victim/new.lua", folder_ / "events/Beacon.lua");
  const Outcome made = run_there({"new", "event", "Beacon"});
  EXPECT_EQ(made.exit_code, 2);
  EXPECT_THAT(made.err, HasSubstr("events/Beacon.lua: is there already"));
  fs::create_symlink(folder_ / "victim/new.kml", folder_ / "schema.kml");
  const Outcome schema = run_there({"schema", "Pause", "-o", "schema.kml"});
  EXPECT_EQ(schema.exit_code, 2);
  EXPECT_THAT(schema.err, HasSubstr("-o schema.kml: is there already; it is not replaced"));
  expect_intact();
}

// Scenarios whose logs go to a folder that the user names.
class ReceivedScenarioFolder : public ReceivedFolder {
 protected:
  Outcome test_scenarios(int exit_code) const {
    const Outcome outcome = run_there({"test", "Documents.lua", "-o", "home"});
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.out << outcome.err;
    return outcome;
  }

  std::string scenarios_ = folder_.write("Documents.lua", R"(
local lsos = require 'lsos'
lsos.scenario('Work', function()
  local sim = lsos.sim('plan.kml')
  sim:run_for(1)
end)
)");
};

TEST_F(ReceivedScenarioFolder, keeps_what_is_not_of_the_scenario) {
  folder_.write("home/Documents/Work/thesis.txt", "four years");
  folder_.write("home/Documents/Work/sim2/thesis.txt", "two years");
  test_scenarios(0);
  EXPECT_EQ(read_text(folder_ / "home/Documents/Work/thesis.txt"), "four years");
  EXPECT_EQ(read_text(folder_ / "home/Documents/Work/sim2/thesis.txt"), "two years");
  EXPECT_FALSE(fs::exists(folder_ / "home/Documents/Work/sim1")) << "it passed";
}

TEST_F(ReceivedScenarioFolder, is_cleared_of_earlier_logs) {
  finished_run("home/Documents/Work/sim1");
  finished_run("home/Documents/Work/sim7");
  folder_.write("home/Documents/Work/sim7/12.5_s.png", "\x89PNG\r\n\x1a\n");
  test_scenarios(0);
  EXPECT_FALSE(fs::exists(folder_ / "home/Documents/Work"));
}

TEST_F(ReceivedScenarioFolder, is_told_where_a_log_cannot_go) {
  folder_.write("home/Documents/Work/sim1/thesis.txt", "four years");
  EXPECT_THAT(test_scenarios(1).out, HasSubstr("sim1: holds files that are no run of lsos-host"));
  EXPECT_EQ(read_text(folder_ / "home/Documents/Work/sim1/thesis.txt"), "four years");
}

TEST_F(ReceivedScenarioFolder, is_reached_by_no_link) {
  for (const auto& [name, exit_code] :
       {std::pair("home/Documents", 2), std::pair("home/Documents/Work", 1),
        std::pair("home/Documents/Work/sim1", 1)}) {
    fs::remove_all(folder_ / "home");
    link_to_folder(name);
    const Outcome outcome = test_scenarios(exit_code);
    EXPECT_THAT(outcome.out + outcome.err, HasSubstr(std::string(name) + ": is a link, to "));
    expect_intact();
  }
}

}  // namespace
}  // namespace lsos::test
