// What people read of a plan is text: none of it acts on a terminal, whatever command prints it.
#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/visible_text.h"
#include "system/hostile_plan.h"
#include "system/process.h"
#include "system/temp_folder.h"

namespace lsos::test {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;

// Runs a command and holds that all that it prints is seen; JSON on standard output stays JSON.
Outcome expect_seen(const Words& words, const TempFolder& folder, bool says_text = true) {
  const Outcome outcome = run(words, {.folder = folder.path()});
  const std::string what = ::testing::PrintToString(words);
  EXPECT_THAT(outcome.exit_code, AnyOf(0, 1, 2)) << what << outcome.err;
  EXPECT_EQ(visible_text(outcome.out), outcome.out) << what;
  EXPECT_EQ(visible_text(outcome.err), outcome.err) << what;
  const bool is_json = std::ranges::find(words, "--json") != words.end();
  if (is_json && outcome.exit_code != 2) {
    EXPECT_FALSE(nlohmann::json::parse(outcome.out, nullptr, false).is_discarded()) << what;
  }
  // A test that prints nothing of the plan would hold nothing.
  if (says_text) {
    EXPECT_THAT(outcome.out + outcome.err, HasSubstr("\\u009b31m")) << what;
  }
  return outcome;
}

class HostileTexts : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TempFolder;
    plan_ = write_hostile_plan(*folder_);
    ran_ = expect_seen({plan_, "-o", *folder_ / "run"}, *folder_);
  }
  static void TearDownTestSuite() { delete folder_; }

  static inline TempFolder* folder_ = nullptr;
  static inline std::string plan_;
  static inline Outcome ran_;
};

TEST_F(HostileTexts, of_a_run_are_seen) {
  EXPECT_EQ(ran_.exit_code, 1) << ran_.out << ran_.err;
  EXPECT_THAT(ran_.err, HasSubstr("warning: "));
  EXPECT_THAT(ran_.err, HasSubstr("\\u001b]0;title\\u0007"));
  EXPECT_THAT(ran_.out, HasSubstr("\\u202e"));
  expect_seen({"run", plan_, "-o", *folder_ / "again", "--json", "--no-report"}, *folder_);
}

TEST_F(HostileTexts, of_a_plan_are_seen) {
  expect_seen({"check", plan_}, *folder_);
  expect_seen({"check", plan_, "--verbose"}, *folder_);
  expect_seen({"check", plan_, "--json"}, *folder_);
  expect_seen({"fsm", plan_}, *folder_);
  expect_seen({"export", plan_, "-o", *folder_ / "table.csv"}, *folder_, false);
  expect_seen({"import", *folder_ / "table.csv", "-o", *folder_ / "back.kml"}, *folder_, false);
  expect_seen({"edit", plan_, "disable", "R2/10", "-o", *folder_ / "edited.kml"}, *folder_, false);
}

TEST_F(HostileTexts, of_scripts_are_seen) {
  for (const Words& words : {Words{"list", "events"}, Words{"list", "events", "Loud"},
                             Words{"list", "events", "Loud", "--json"}, Words{"schema", "Loud"},
                             Words{"schema", "Loud", "--json"}}) {
    expect_seen(words, *folder_);
  }
  folder_->write("broken/events/Broken.lua", "error(" + in_lua(hostile_text) + ")");
  const Outcome outcome = run({"list", "events", "Broken"}, {.folder = *folder_ / "broken"});
  EXPECT_EQ(visible_text(outcome.out + outcome.err), outcome.out + outcome.err);
  EXPECT_THAT(outcome.out + outcome.err, HasSubstr("\\u001b]0;title"));
}

TEST_F(HostileTexts, of_results_are_seen) {
  const std::string ran = *folder_ / "run";
  expect_seen({"report", ran}, *folder_, false);
  expect_seen({"overlay", ran}, *folder_, false);
  expect_seen({"verify", ran}, *folder_, false);
  expect_seen({"picture", ran, "--at", "1 s", "--of", hostile_rover, "-o", *folder_ / "x.png"},
              *folder_, false);
  folder_->write("other/plan.kml",
                 read_text(plan_).replace(read_text(plan_).find("0.0005,0<"), 8, "0.0009,0"));
  folder_->write("other/events/Loud.lua", read_text(*folder_ / "events/Loud.lua"));
  ASSERT_NE(
      run({*folder_ / "other/plan.kml", "-o", *folder_ / "other_run", "--no-report"}).exit_code, 3);
  for (const char* option : {"--json", "--quiet", "--exact"}) {
    expect_seen({"compare", ran, *folder_ / "other_run", option}, *folder_);
  }
}

TEST_F(HostileTexts, of_the_prompt_are_seen) {
  folder_->write("input",
                 "sim = lsos.sim 'hostile.kml'\nsim:run_for(60)\nsim.events\nsim:where()\nprint(" +
                     in_lua(hostile_text) + ")\nerror(" + in_lua(hostile_text) + ")\n");
  const Outcome outcome = run_command(
      {"sh", "-c", "exec " + program({}).front() + " repl hostile.kml < input"}, {folder_->path()});
  EXPECT_NE(outcome.exit_code, 3) << outcome.err;
  EXPECT_EQ(visible_text(outcome.out), outcome.out);
  EXPECT_EQ(visible_text(outcome.err), outcome.err);
  EXPECT_THAT(outcome.out, HasSubstr("\\u001b]0;title"));
}

TEST_F(HostileTexts, of_names_of_files_and_of_arguments_are_seen) {
  const std::string name = "a\x1b[31m<b>\u202e.kml";
  const std::string odd = folder_->write(name, read_text(plan_));
  expect_seen({"check", odd}, *folder_);
  expect_seen({"check", odd + "x"}, *folder_, false);
  expect_seen({"\x1b[31mchek"}, *folder_, false);
  expect_seen({"check", "--\x1b[31m", plan_}, *folder_, false);
  expect_seen({"sun", "--planet", "Moon", "--site", "\x1b[31m", "--at", "2026-01-01"}, *folder_,
              false);
  expect_seen({"list", "events", "\xff\x9b"}, *folder_, false);
  expect_seen({"list", "events", "\xff\x9b", "--json"}, *folder_, false);
}

TEST_F(HostileTexts, of_sheets_and_rasters_are_seen) {
  const std::string cell =
      "\"" + hostile_markup.substr(0, hostile_markup.find('"')) + "\x1b[31m\u009b31m\"";
  folder_->write("sheet.csv", "Type,RoverId,Sequence," + cell + "\nPause,A,x" + cell + ",1\n" +
                                  cell + ",A,2,\n");
  expect_seen({"import", *folder_ / "sheet.csv", "-o", *folder_ / "sheet.kml"}, *folder_);
  folder_->write("terrain/Odd.lua",
                 "local lsos = require 'lsos'\nreturn lsos.terrain { api = 1, doc = 'x', soil = "
                 "'ApolloDense', surface = lsos.raster { file = " +
                     in_lua("x" + hostile_text) + ", crs = " + in_lua(hostile_text) + " } }\n");
  const std::string plan = folder_->write(
      "odd.kml", kml({{"MissionInfo",
                       {{"Planet", "Moon"}, {"StartTime", "2026-01-01"}, {"Terrain", "Odd"}},
                       ""},
                      sev("A", "0,0"),
                      event("Pause", "A", 1, {{"Duration", "5 s"}})}));
  expect_seen({"check", plan}, *folder_);
  expect_seen({"terrain", "Odd", "--at", "0,0"}, *folder_);
}

TEST(HostileId, with_control_characters_is_refused) {
  const TempFolder folder;
  const std::string plan = folder.write("plan.kml", kml({mission(), sev("A&#10;B", "0,0")}));
  const Outcome outcome = run({"check", plan});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.out + outcome.err,
              HasSubstr("line ends and other control characters are not allowed in an id"));
}

TEST(HostileLabel, is_one_line) {
  const TempFolder folder;
  std::vector<Mark> marks{mission(), sev("A", "0,0"),
                          event("Pause", "A", 1, {{"Duration", "5 s"}})};
  marks.back().name = "one&#10;plan.kml:1: no fault";
  const Outcome outcome = run({"check", folder.write("plan.kml", kml(marks)), "--json"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("one plan.kml:1: no fault"));
}

}  // namespace
}  // namespace lsos::test
