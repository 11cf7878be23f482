// `lsos-host run --watch`: each run is a separate process, so that a run that is out of date can be
// stopped.
#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <map>

#include "base/child_process.h"
#include "base/console.h"
#include "base/error.h"
#include "base/stop_signal.h"
#include "lua/app/run_options.h"
#include "lua/host/mission_reader.h"
#include "product/run_folder.h"

namespace lsos {

namespace {

namespace fs = std::filesystem;

constexpr useconds_t poll_period_us = 200'000;

// Time at which each file that the run could depend on was last written.
using Written = std::map<std::string, fs::file_time_type>;

Written written_now(const std::string& plan_file) {
  Written written;
  const auto add = [&](const fs::path& file) {
    std::error_code absent;
    const fs::file_time_type time = fs::last_write_time(file, absent);
    if (!absent) written[file] = time;
  };
  add(plan_file);
  for (const ScriptFolder& folder : script_folders(plan_file)) {
    for (const char* kind : {"events", "rovers", "terrain", "terrain/soils", "lib"}) {
      std::error_code absent;
      for (const auto& entry : fs::directory_iterator(fs::path(folder.path) / kind, absent)) {
        if (entry.path().extension() == ".lua") add(entry.path());
      }
    }
  }
  return written;
}

// Name of one of the files that differ, for a message; "" for none.
std::string changed_file(const Written& before, const Written& after) {
  for (const auto& [file, time] : after) {
    const auto known = before.find(file);
    if (known == before.end() || known->second != time) return file;
  }
  for (const auto& [file, time] : before) {
    if (!after.contains(file)) return file;
  }
  return "";
}

// Waits until the files have changed and have then been stable for one interval, as an editor may
// write in several steps. Returns the name of a changed file.
std::string wait_for_change(const std::string& plan_file, Written& written) {
  std::string changed;
  while (stop_signal() == 0) {
    usleep(poll_period_us);
    const Written now = written_now(plan_file);
    const std::string differs = changed_file(written, now);
    written = now;
    if (!differs.empty()) {
      changed = differs;
    } else if (!changed.empty() && now.contains(plan_file)) {
      return changed;
    }
  }
  return changed;
}

// Time at which a file was last written; the least of times where there is no such file.
fs::file_time_type modified(const std::string& file) {
  std::error_code none;
  return fs::last_write_time(file, none);
}

}  // namespace

int watch_command(RunOptions options) {
  Written written = written_now(options.plan);
  catch_stop_signals();
  for (;;) {
    const std::string kept_plan =
        (options.folder.empty() ? default_run_folder(options.plan) : options.folder) + "/plan.kml";
    const auto kept_before = modified(kept_plan);
    std::optional<ChildProcess> process = ChildProcess::fork();
    if (!process) return run_command(options);
    const std::string changed = wait_for_change(options.plan, written);
    // A run still going is out of date and is stopped; one that has ended is not affected.
    // A terminal has sent its SIGINT to the run as well, and a second would cut it short.
    process->send(SIGTERM);
    process->wait();
    if (stop_signal() != 0) return 128 + stop_signal();
    // A run that took the folder has written its plan there, so what is left in it may be replaced.
    options.is_forced |= modified(kept_plan) != kept_before;
    if (!options.is_quiet) print_message("\n{} has changed: running again\n", changed);
  }
}

}  // namespace lsos
