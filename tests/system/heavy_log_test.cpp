// What a script logs without end goes to the log: a run keeps and lists a part, and its log has a
// greatest size.
#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "system/plan_text.h"
#include "system/process.h"
#include "system/temp_folder.h"

namespace lsos::test {
namespace {

using ::testing::HasSubstr;

// A plan whose one event says so much at each exchange, for so long.
std::string write_chatty_plan(const TempFolder& folder, const std::string& duration, int warnings,
                              int notes) {
  folder.write("events/Chatty.lua", R"lua(
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'Talks.',
  params = {
    duration_s = lsos.duration { kml = 'Duration', required = true },
    warnings = lsos.integer { kml = 'Warnings', required = true },
    notes = lsos.integer { kml = 'Notes', required = true },
  },
  start = 'talk',
  phases = {
    talk = function(ev)
      if ev.elapsed_s >= ev.params.duration_s then return lsos.done end
      for i = 1, ev.params.warnings do ev:warn('number %d', i) end
      for i = 1, ev.params.notes do ev:log('talk', { text = ('x'):rep(500) }) end
      return lsos.sleep(0.1)
    end,
  },
}
)lua");
  return folder.write("plan.kml", kml({mission(), sev("A", "0,0"),
                                       event("Chatty", "A", 1,
                                             {{"Duration", duration},
                                              {"Warnings", std::to_string(warnings)},
                                              {"Notes", std::to_string(notes)}})}));
}

TEST(HeavyLog, of_warnings_is_listed_in_part) {
  const TempFolder folder;
  const std::string plan = write_chatty_plan(folder, "2 s", 500, 0);
  const Outcome outcome = run({plan, "-o", folder / "run", "--no-report"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto summary = nlohmann::json::parse(read_text(folder / "run/summary.json"));
  ASSERT_EQ(summary["warnings"].size(), 1001u);
  const std::string rest =
      "9000 more warnings are not listed, after the first 1000; those that "
      "events gave are all in the log, table notes, name warning";
  EXPECT_EQ(summary["warnings"].back(), rest);
  EXPECT_THAT(outcome.err, HasSubstr("warning: " + rest));
  EXPECT_LT(outcome.err.size(), 100'000u);
  const Outcome counted = run_command(
      {"sqlite3", folder / "run/log.gpkg", "select count(*) from notes where name = 'warning'"});
  EXPECT_EQ(counted.out, "10000\n");
}

TEST(HeavyLog, ends_the_run_at_its_greatest_size_which_resume_may_raise) {
  const TempFolder folder;
  const std::string plan = write_chatty_plan(folder, "20 s", 0, 100);
  const std::string ran = folder / "run";
  const Outcome ended = run({plan, "-o", ran, "--no-report", "--log-max", "0.001"});
  EXPECT_EQ(ended.exit_code, 3) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("where 0.001 GB are allowed; --log-max allows more"));
  const Outcome resumed = run({"resume", ran, "--no-report", "--log-max", "1"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  const Outcome counted =
      run_command({"sqlite3", ran + "/log.gpkg", "select count(*) from notes where name = 'talk'"});
  EXPECT_EQ(counted.out, "20000\n");
}

// A reason is cut to 4,000 bytes, in the middle of a letter but for the care taken.
TEST(HeavyLog, of_a_long_reason_is_read_again) {
  const TempFolder folder;
  folder.write(
      "events/Sorry.lua",
      "local lsos = require 'lsos'\n"
      "return lsos.event { api = 1, doc = 'Fails.', params = {}, start = 'fail',\n"
      "  phases = { fail = function() return lsos.fail('x' .. ('\u00e4'):rep(3000)) end } }\n");
  const std::string plan =
      folder.write("plan.kml", kml({mission(), sev("A", "0,0"), event("Sorry", "A", 1, {})}));
  const Outcome ended = run({plan, "-o", folder / "run", "--quiet"});
  EXPECT_EQ(ended.exit_code, 1) << ended.err;
  EXPECT_EQ(run({"report", folder / "run", "--no-pictures"}).exit_code, 0);
  EXPECT_EQ(run({"compare", folder / "run", folder / "run"}).exit_code, 0);
  const auto summary = nlohmann::json::parse(read_text(folder / "run/summary.json"));
  EXPECT_THAT(std::string(summary["events"][0]["reason"]), HasSubstr("x\u00e4\u00e4"));
}

TEST(HeavyLog, has_a_greatest_size_above_0) {
  const TempFolder folder;
  const std::string plan = write_chatty_plan(folder, "1 s", 0, 0);
  const Outcome outcome = run({plan, "-o", folder / "run", "--log-max", "0"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--log-max 0: more than 0 GB is wanted"));
  EXPECT_FALSE(std::filesystem::exists(folder / "run"));
}

}  // namespace
}  // namespace lsos::test
