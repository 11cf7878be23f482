#include "lua/study/case_run.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "base/error.h"
#include "base/files.h"
#include "base/output_error.h"
#include "base/replaced.h"
#include "base/stop_signal.h"
#include "lua/app/run_options.h"
#include "lua/app/run_to_end.h"
#include "lua/study/case_values.h"
#include "product/study/case_record.h"
#include "product/study/case_series.h"
#include "product/summary.h"
#include "record/log.h"

namespace lsos {

namespace {

namespace fs = std::filesystem;

// Keeps other processes out of a case. The file is removed with the lock.
class CaseLock {
 public:
  CaseLock(const std::string& file, int wait_s) : file_(file) {
    constexpr int tries_a_second = 10;
    for (int i = 0; i < wait_s * tries_a_second && !is_held(); ++i) {
      if (i > 0) std::this_thread::sleep_for(std::chrono::milliseconds(1000 / tries_a_second));
      if (stop_signal() != 0) return;
      take();
    }
  }
  ~CaseLock() {
    if (!is_held()) return;
    std::remove(file_.c_str());
    close(descriptor_);
  }
  CaseLock(const CaseLock&) = delete;
  CaseLock& operator=(const CaseLock&) = delete;

  bool is_held() const { return descriptor_ >= 0; }

 private:
  // The lock counts while the file that is locked still has its name.
  void take() {
    descriptor_ = open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (descriptor_ < 0) throw InputError({}, file_ + ": cannot be written");
    std::error_code gone;
    const bool is_ours =
        flock(descriptor_, LOCK_EX | LOCK_NB) == 0 &&
        fs::equivalent("/proc/self/fd/" + std::to_string(descriptor_), file_, gone);
    if (is_ours) return;
    close(descriptor_);
    descriptor_ = -1;
  }

  std::string file_;
  int descriptor_ = -1;
};

double cpu_s() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds_of = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
}

bool has_summary(const std::string& folder) {
  return is_summary(read_file(folder + "/summary.json").value_or(""));
}

// Whether the run in the folder has come to its end; a stopped one keeps checkpoints.
bool has_ended(const std::string& folder) {
  if (!has_summary(folder)) return false;
  try {
    return LogReader(folder + "/log.gpkg").checkpoints().empty();
  } catch (const InputError&) {
    return false;
  }
}

// The time up to which a stopped run need not be repeated. A run's first checkpoint is its start.
SimTime reached(const std::string& folder) {
  if (has_ended(folder)) return SimTime::max();
  SimTime last{};
  if (!fs::exists(folder + "/log.gpkg")) return last;
  try {
    for (const CheckpointEntry& entry : LogReader(folder + "/log.gpkg").checkpoints()) {
      last = std::max(last, entry.time);
    }
  } catch (const InputError&) {
    // It was killed before its first checkpoint.
  }
  return last;
}

CaseRecord record_of(const StudyFiles& files, std::int64_t number) {
  CaseRecord record;
  record.number = number;
  for (const Draw& drawn : draws_of_case(files, files.sampler(), number)) {
    record.values.insert(record.values.end(), drawn.values.begin(), drawn.values.end());
  }
  record.seed = files.base.plan.mission.seed;
  for (const auto& [name, value] : record.values) {
    if (name == "MissionInfo.Seed") {
      record.seed = static_cast<std::uint64_t>(std::get<std::int64_t>(value));
    }
  }
  return record;
}

void mark_not_run(const StudyFiles& files, std::int64_t number, const std::string& study_folder,
                  const std::string& reason) {
  CaseRecord record = record_of(files, number);
  record.status = not_run_status;
  record.reason = reason;
  write_file(not_run_file(study_folder, number), to_json(record));
}

// Runs the mission, or goes on with it, in the folder. Returns the exit code.
int run_mission(const StudyFiles& files, std::int64_t number, const std::string& folder,
                int threads) {
  const auto begin = std::chrono::steady_clock::now();
  ResumeOptions resumed;
  resumed.folder = folder;
  resumed.is_quiet = true;
  resumed.has_report = false;
  resumed.threads = threads;
  if (fs::exists(folder + "/" + case_file) || has_ended(folder)) return 0;
  if (fs::exists(folder + "/log.gpkg")) {
    try {
      return resume_command(resumed);
    } catch (const InputError&) {
      // It was killed before its first checkpoint.
    }
  }
  fs::remove_all(folder);
  RunOptions options;
  static_cast<OutcomeOptions&>(options) = resumed;
  options.plan = folder + "/plan.kml";
  options.folder = folder;
  options.is_forced = true;
  fs::create_directories(folder);
  const auto draws = draws_of_case(files, files.sampler(), number);
  const PlanSource source = plan_of_case(files, draws, folder);
  return run_files(read_mission(source, files.base.catalog), options, begin);
}

void keep_log(const StudyFiles& files, const CaseRecord& record, const std::string& folder) {
  const Keep keep = files.study.keep;
  if (keep == Keep::all || (keep == Keep::failed && record.status != "completed")) return;
  for (const char* name : {"log.gpkg", "log.gpkg-wal", "log.gpkg-shm", "overlay.kml", "days.csv"}) {
    fs::remove(folder + "/" + name);
  }
}

void finish(const StudyFiles& files, std::int64_t number, const std::string& study_folder,
            double cpu_before_s) {
  const std::string folder = part_folder(study_folder, number);
  if (!fs::exists(folder + "/" + case_file)) {
    // What it says of its files holds once the folder has its name.
    const std::string name = case_name(number);
    const std::string text = replaced(read_file(folder + "/summary.json").value_or(""),
                                      "/" + name + ".part/", "/" + name + "/");
    write_file(folder + "/summary.json", text);
    const auto summary = nlohmann::json::parse(text);
    CaseRecord record = record_of(files, number);
    record.status = summary.at("status").get<std::string>();
    record.reason = reason_of(text);
    CaseValues values = values_of_case(files, folder, text);
    record.gathered = std::move(values.gathered);
    record.events = std::move(values.events);
    write_file(folder + "/" + series_file, values.series);
    record.log_sha256 = summary.at("log_sha256").get<std::string>();
    record.sim_s = summary.at("sim_s").get<double>();
    record.wall_s = summary.at("wall_s").get<double>();
    record.cpu_s = cpu_s() - cpu_before_s;
    write_file(folder + "/" + case_file, to_json(record));
  }
  const auto record = read_case_record(read_file(folder + "/" + case_file).value_or(""));
  LSOS_ASSERT(record);
  keep_log(files, *record, folder);
  fs::remove(folder + "/.lsos-host.lock");
  const std::string whole = case_folder(study_folder, number);
  fs::remove_all(whole);  // one without its summary, which counts as none
  fs::rename(folder, whole);
}

}  // namespace

bool is_done(const std::string& study_folder, std::int64_t number) {
  return has_summary(case_folder(study_folder, number));
}

std::vector<std::int64_t> open_cases(std::vector<std::int64_t> numbers,
                                     const std::string& study_folder, bool tries_again) {
  std::erase_if(numbers, [&](std::int64_t number) {
    if (is_done(study_folder, number)) return true;
    return !tries_again && fs::exists(not_run_file(study_folder, number));
  });
  return numbers;
}

CaseEnd run_case(const StudyFiles& files, std::int64_t number, const std::string& study_folder,
                 int threads, int wait_s) {
  const CaseLock lock(case_folder(study_folder, number) + ".lock", wait_s);
  if (!lock.is_held()) return CaseEnd::elsewhere;
  if (is_done(study_folder, number)) return CaseEnd::done;
  const double before_s = cpu_s();
  const std::string folder = part_folder(study_folder, number);
  try {
    const SimTime before = reached(folder);
    const int code = run_mission(files, number, folder, threads);
    if (code > 128) return reached(folder) > before ? CaseEnd::stopped : CaseEnd::no_further;
    finish(files, number, study_folder, before_s);
    return CaseEnd::done;
  } catch (const OutputError& error) {
    mark_not_run(files, number, study_folder, error.what());
    return CaseEnd::machine;
  } catch (const fs::filesystem_error& error) {
    mark_not_run(files, number, study_folder, error.what());
    return CaseEnd::machine;
  } catch (const std::bad_alloc&) {
    mark_not_run(files, number, study_folder, "out of memory");
    return CaseEnd::machine;
  } catch (const std::exception& error) {
    mark_not_run(files, number, study_folder, error.what());
    fs::remove_all(folder);
    return CaseEnd::not_run;
  }
}

}  // namespace lsos
