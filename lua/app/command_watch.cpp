// `lsos-host run --watch`: each run is a process of its own, so that one that is out of date can be
// stopped.
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <map>

#include "base/console.h"
#include "base/error.h"
#include "lua/app/run_options.h"
#include "lua/host/mission_reader.h"
#include "product/run_folder.h"

namespace lsos {

namespace {

namespace fs = std::filesystem;

constexpr useconds_t look_us = 200'000;

std::atomic<int> asked_to_stop{0};

// Of each file that the run could depend on, when it was last written.
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
    for (const char* kind : {"events", "rovers", "terrain", "terrain/soils"}) {
      std::error_code absent;
      for (const auto& entry : fs::directory_iterator(fs::path(folder.path) / kind, absent)) {
        if (entry.path().extension() == ".lua") add(entry.path());
      }
    }
  }
  return written;
}

// One of those that differ, for people.
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

// Until the files have changed, and then stand still: an editor may write in several steps.
std::string wait_for_change(const std::string& plan_file, Written& written) {
  std::string changed;
  while (asked_to_stop == 0) {
    usleep(look_us);
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

// When a file was written last; of none, the least of times.
fs::file_time_type modified(const std::string& file) {
  std::error_code none;
  return fs::last_write_time(file, none);
}

void end_with_parent(pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(0);
}

// Forks with both signals held back, so that none reaches the child while our handler is still
// there to swallow it.
pid_t fork_with_own_signals() {
  sigset_t both, before;
  sigemptyset(&both);
  sigaddset(&both, SIGINT);
  sigaddset(&both, SIGTERM);
  sigprocmask(SIG_BLOCK, &both, &before);
  const pid_t process = fork();
  if (process == 0) {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
  }
  sigprocmask(SIG_SETMASK, &before, nullptr);
  return process;
}

}  // namespace

int watch_command(RunOptions options) {
  const pid_t self = getpid();
  Written written = written_now(options.plan);
  const auto note = [](int signal) { asked_to_stop = signal; };
  std::signal(SIGINT, note);
  std::signal(SIGTERM, note);
  for (;;) {
    std::fflush(nullptr);
    const std::string kept_plan =
        (options.folder.empty() ? default_run_folder(options.plan) : options.folder) + "/plan.kml";
    const auto kept_before = modified(kept_plan);
    const pid_t process = fork_with_own_signals();
    if (process < 0) throw std::runtime_error("no process for a run");
    if (process == 0) {
      end_with_parent(self);
      return run_command(options);
    }
    const std::string changed = wait_for_change(options.plan, written);
    // A run that goes on is out of date; one that has ended takes no notice.
    kill(process, asked_to_stop != 0 ? static_cast<int>(asked_to_stop) : SIGTERM);
    waitpid(process, nullptr, 0);
    if (asked_to_stop != 0) return 128 + asked_to_stop;
    // A run that took the folder wrote its plan there: what is left of it is ours.
    options.is_forced |= modified(kept_plan) != kept_before;
    if (!options.is_quiet) print_message("\n{} has changed: running again\n", changed);
  }
}

}  // namespace lsos
