// Machines that fail: what a run has written stays readable, the reason is said, and `resume` goes
// on to the same end when the cause is gone.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "support/sanitizer.h"
#include "system/killed_runs.h"
#include "system/moon_ground.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::Not;

// Enough rows to fill a small disk, in some seconds.
std::vector<Mark> many_rows() {
  return {mission({{"LogInterval", "0.1"}}), sev("A", "31.0,20.0"),
          event("Route", "A", 10, {{"Speed", "2"}}, line("31.0,20.0 31.01,20.0"))};
}

// A run in one piece, and others that meet with a fault.
class MachineFault : public KilledRuns {
 protected:
  MachineFault() : run_(folder_ / "run") {}

  // Runs the program by a shell in which $P is the program, $PLAN the plan and $RUN the folder.
  Outcome in_shell(const std::string& line) const {
    return run_command(
        {"bash", "-c",
         "P='" LSOS_PROGRAM "' PLAN='" + plan_ + "' RUN='" + run_.string() + "'; " + line},
        {.folder = folder_.path()});
  }
  void expect_readable() const {
    EXPECT_EQ(query(run_ / "log.gpkg", "pragma integrity_check"), "ok");
    EXPECT_NE(query(run_ / "log.gpkg", "select count(*) from samples"), "0");
    const Outcome report = run({"report", run_, "--no-pictures"});
    EXPECT_EQ(report.exit_code, 0) << report.err;
  }
  void expect_goes_on() const {
    const Outcome outcome = run({"resume", run_, "--no-report", "--quiet"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(summary(run_)["log_sha256"], digest_);
  }
  // Starts a run, and returns when it has written rows.
  std::unique_ptr<Process> start() {
    plan_ = folder_.write("plan.kml", kml(long_drive()));
    auto process = std::make_unique<Process>(program({plan_, "-o", run_, "--no-report"}));
    EXPECT_TRUE(wait_for_samples(*process, run_)) << process->wait().err;
    return process;
  }
  std::string log() const { return run_ / "log.gpkg"; }

  fs::path run_;
};

TEST_F(MachineFault, of_a_full_disk_lets_a_run_go_on_later) {
  whole_run(many_rows());
  const auto blocks = fs::file_size(folder_ / "whole/log.gpkg") / 1024;
  const Outcome outcome =
      in_shell("ulimit -f " + std::to_string(blocks * 2 / 3) +
               "; $P $PLAN -o $RUN --checkpoint-every '2 s' --no-report --quiet");
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("when the cause is gone, 'lsos-host resume "));
  EXPECT_FALSE(fs::exists(run_ / "summary.json"));
  expect_readable();
  expect_goes_on();
}

// A small file system of its own, where the tests may mount one.
TEST_F(MachineFault, of_a_disk_without_space_is_said) {
  if (in_shell("unshare -m true").exit_code != 0) GTEST_SKIP() << "no mounts here";
  plan_ = folder_.write("plan.kml", kml(many_rows()));
  fs::create_directory(folder_ / "small");
  const Outcome outcome = in_shell(
      "unshare -m bash -c \"mount -t tmpfs -o size=700k tmpfs small; $P $PLAN -o small/run "
      "--no-report --quiet; echo code \\$?; sqlite3 small/run/log.gpkg 'pragma integrity_check'; "
      "mount -o remount,size=100m small; $P resume small/run --no-report --quiet; echo code "
      "\\$?\"");
  EXPECT_THAT(outcome.out, HasSubstr("code 3\nok\n")) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("code 0\n")) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("log.gpkg: writing: no space is left on the disk"));
}

// No summary can be written when the mission has ended.
TEST_F(MachineFault, at_the_summary_loses_no_run) {
  whole_run(short_drive());
  plan_ = folder_.write("plan.kml", kml(short_drive()));
  Process process(program(with({plan_, "-o", run_}, dense)));
  while (!fs::exists(log()) && process.is_running()) usleep(1000);
  fs::create_directories(run_ / "summary.json/in the way");
  const Outcome outcome = process.wait();
  EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("summary.json: is a folder, and no file that could be"));
  EXPECT_THAT(outcome.err, HasSubstr("when the cause is gone, 'lsos-host resume "));
  EXPECT_THAT(outcome.err, Not(HasSubstr("fault inside")));
  fs::remove_all(run_ / "summary.json");
  expect_goes_on();
}

TEST_F(MachineFault, of_a_log_that_is_gone_ends_the_run) {
  for (const char* what : {"rm run/log.gpkg", "rm run/log.gpkg*", "rm -r run", "mv run away",
                           "mv run/log.gpkg x; cp x run/log.gpkg"}) {
    fs::remove_all(run_);
    fs::remove_all(folder_ / "away");
    const auto process = start();
    EXPECT_EQ(in_shell(what).exit_code, 0);
    const Outcome outcome = process->wait();
    EXPECT_EQ(outcome.exit_code, 3) << what << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("log.gpkg: is gone: another program has removed, moved or "
                                       "replaced it during the run"))
        << what;
  }
}

// As a program that edits the log in a GIS does.
// A run leaves its log to others for moments only: on a busy machine one waits half a minute.
TEST_F(MachineFault, of_a_log_that_another_program_locks_is_waited_for) {
  const auto process = start();
  EXPECT_EQ(in_shell("(echo 'begin immediate;'; sleep 2; echo 'commit;') | "
                     "sqlite3 -cmd '.timeout 100000' run/log.gpkg")
                .exit_code,
            0);
  usleep(500'000);
  EXPECT_TRUE(process->is_running());
  process->signal(SIGTERM);
  EXPECT_EQ(process->wait().exit_code, 128 + SIGTERM);
  EXPECT_EQ(query(log(), "pragma integrity_check"), "ok");
}

TEST_F(MachineFault, of_a_raster_that_changes_under_a_run_is_said) {
  write_raster(folder_, "flat", 400, [](double, double) { return 3.0; });
  write_terrain(folder_, "Flat", "lsos.raster { file = 'flat.asc' }", "'Rock'");
  std::string laps = place(0, 0);
  for (int lap = 0; lap < 10; ++lap) laps += " " + place(60, 0) + " " + place(0, 0);
  plan_ = folder_.write("plan.kml", kml({on("Flat"), sev("A", "0,0"),
                                         event("Route", "A", 10, {{"Speed", "2"}}, line(laps))}));
  Process process(program({plan_, "-o", run_, "--no-report", "--no-estimate"}));
  ASSERT_TRUE(wait_for_samples(process, run_)) << process.wait().err;
  fs::last_write_time(folder_ / "terrain/flat.asc", fs::file_time_type::clock::now());
  const Outcome outcome = process.wait();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto told = HasSubstr("terrain/flat.asc: has changed during the run");
  EXPECT_THAT(outcome.err, told);
  EXPECT_THAT(summary(run_)["warnings"].dump(), told);
}

TEST_F(MachineFault, of_a_lock_whose_holder_is_dead_is_none) {
  whole_run(short_drive());
  fs::copy(folder_ / "whole", run_);
  folder_.write("run/.lsos-host.lock", "");
  EXPECT_EQ(run({plan_, "-o", run_, "--quiet", "--no-report"}).exit_code, 0);
  EXPECT_EQ(summary(run_)["log_sha256"], digest_);
}

// Surroundings that differ change no value of the log.
TEST_F(MachineFault, of_the_surroundings_changes_nothing) {
  whole_run(short_drive());
  std::vector<std::pair<std::string, std::string>> surroundings{
      {"no variables", "env -i $P"},
      {"no home", "env -u HOME $P"},
      {"a home that is not there", "env HOME=/none XDG_CACHE_HOME=/none TMPDIR=/none $P"},
      {"another time zone", "env TZ=Pacific/Kiritimati $P"}};
  if (in_shell("mkdir l && localedef -i de_DE -f UTF-8 l/de_DE.UTF-8; "
               "LOCPATH=$PWD/l LC_ALL=de_DE.UTF-8 bash -c \"printf '%.1f' 1,5\" | grep -qx 1,5")
          .exit_code == 0) {
    surroundings.emplace_back("a decimal comma", "env LOCPATH=$PWD/l LC_ALL=de_DE.UTF-8 $P");
  }
  for (const auto& [what, command] : surroundings) {
    const Outcome outcome =
        in_shell(command + " $PLAN -o $RUN --quiet --checkpoint-every '2 s' --force --no-report");
    EXPECT_EQ(outcome.exit_code, 0) << what << outcome.err;
    EXPECT_EQ(summary(run_)["log_sha256"], digest_) << what;
  }
}

// A library that is loaded first makes the wall clock jump by months at each look.
TEST_F(MachineFault, of_the_clock_changes_nothing) {
  if (is_sanitized) GTEST_SKIP() << "the sanitizer's library must come first";
  folder_.write("clock.c", R"(
#define _GNU_SOURCE
#include <dlfcn.h>
#include <time.h>
#include <sys/time.h>
int clock_gettime(clockid_t id, struct timespec *t) {
  static int (*real)(clockid_t, struct timespec *);
  static long count;
  if (!real) real = (int (*)(clockid_t, struct timespec *))dlsym(RTLD_NEXT, "clock_gettime");
  int result = real(id, t);
  if (id == CLOCK_REALTIME) t->tv_sec += (++count % 7 - 3) * 86400 * 30;
  return result;
}
int gettimeofday(struct timeval *t, void *zone) {
  struct timespec s;
  clock_gettime(CLOCK_REALTIME, &s);
  t->tv_sec = s.tv_sec;
  t->tv_usec = s.tv_nsec / 1000;
  return 0;
}
time_t time(time_t *t) {
  struct timespec s;
  clock_gettime(CLOCK_REALTIME, &s);
  if (t) *t = s.tv_sec;
  return s.tv_sec;
}
)");
  if (in_shell("cc -shared -fPIC -o clock.so clock.c -ldl").exit_code != 0) GTEST_SKIP() << "no cc";
  whole_run(short_drive());
  const Outcome outcome = in_shell(
      "LD_PRELOAD=./clock.so $P $PLAN -o $RUN --quiet --checkpoint-every '2 s' --no-report");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(summary(run_)["log_sha256"], digest_);
  EXPECT_LT(summary(run_)["wall_s"], 100);
}

TEST_F(MachineFault, of_a_lack_of_memory_is_said) {
  if (is_sanitized) GTEST_SKIP() << "the sanitizer reserves terabytes";
  plan_ = folder_.write("plan.kml", kml(short_drive()));
  for (const int kib : {400'000, 700'000, 900'000}) {
    const Outcome outcome =
        in_shell("ulimit -v " + std::to_string(kib) + "; $P $PLAN -o $RUN --quiet --force");
    EXPECT_FALSE(outcome.was_killed) << kib << outcome.err;
    EXPECT_THAT(outcome.exit_code, AnyOf(0, 2, 3)) << kib << outcome.err;
    fs::remove_all(run_);
    if (outcome.exit_code != 0) {
      EXPECT_THAT(outcome.err, AnyOf(HasSubstr("memory"), HasSubstr("cannot draw"))) << kib;
    }
  }
}

}  // namespace
}  // namespace lsos::test
