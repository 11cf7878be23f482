// `lsos-host run --watch`: runs again when the plan or one of its scripts changes.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "system/process.h"
#include "system/temp_folder.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::string event_of(double power_w) {
  return "local lsos = require 'lsos'\n"
         "local function start(ev) ev:log('said', { power_w = " +
         std::to_string(power_w) +
         " }) return lsos.done end\n"
         "return lsos.event { api = 1, doc = 'x', start = 'start', phases = { start = start } }\n";
}

bool comes(const fs::path& file, const std::string& text) {
  for (int k = 0; k < 200; ++k) {
    std::error_code absent;
    if (fs::exists(file, absent) && read_text(file).find(text) != std::string::npos) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return false;
}

TEST(Watch, runs_again_when_plan_or_script_changes_and_ends_at_a_signal) {
  const TempFolder folder;
  folder.write("events/Say.lua", event_of(11));
  const Outcome form = run({"schema", "Say"}, {folder.path()});
  ASSERT_EQ(form.exit_code, 0) << form.err;
  folder.write("say.kml", form.out);
  Process watched(program({"run", "say.kml", "--watch"}), {folder.path()});
  const fs::path overlay = folder / "out/say/overlay.kml",
                 summary = folder / "out/say/summary.json";
  ASSERT_TRUE(comes(overlay, "11.0"));
  ASSERT_TRUE(comes(summary, "completed"));

  folder.write("events/Say.lua", event_of(22));
  EXPECT_TRUE(comes(overlay, "22.0"));
  ASSERT_TRUE(comes(summary, "completed"));

  folder.write("say.kml", "<kml>");  // a fault: it is reported, and the watch goes on
  for (int k = 0; k < 200 && watched.err_so_far().find("say.kml:1: ") == std::string::npos; ++k) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  EXPECT_TRUE(watched.is_running());
  folder.write("events/Say.lua", event_of(33));
  folder.write("say.kml", form.out);
  EXPECT_TRUE(comes(overlay, "33.0"));

  watched.signal(SIGINT);
  const Outcome outcome = watched.wait();
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_THAT(outcome.err, HasSubstr("Say.lua has changed: running again"));
  EXPECT_THAT(outcome.err, HasSubstr("say.kml:1: "));
}

// The folder of another run stays as it is, even when the plan is changed: somebody may want to
// resume that run.
TEST(Watch, leaves_another_s_unfinished_run_alone) {
  const TempFolder folder;
  const Outcome form = run({"schema", "Pause"}, {folder.path()});
  folder.write("pause.kml", form.out);
  ASSERT_EQ(run({"run", "pause.kml", "-o", "kept"}, {folder.path()}).exit_code, 0);
  fs::remove(folder / "kept/summary.json");
  const auto log = read_text(folder / "kept/log.gpkg");
  Process watched(program({"run", "pause.kml", "-o", "kept", "--watch"}), {folder.path()});
  for (int k = 0; k < 2; ++k) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));
    folder.write("pause.kml", form.out + "<!-- " + std::to_string(k) + " -->");
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  watched.signal(SIGINT);
  const Outcome outcome = watched.wait();
  EXPECT_THAT(outcome.err, HasSubstr("has changed: running again"));
  EXPECT_THAT(outcome.err, HasSubstr("--force replaces it"));
  EXPECT_TRUE(read_text(folder / "kept/log.gpkg") == log) << outcome.err;
}

}  // namespace
}  // namespace lsos::test
