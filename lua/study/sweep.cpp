#include "lua/study/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <thread>

#include "base/console.h"
#include "base/error.h"
#include "base/files.h"
#include "base/stop_signal.h"
#include "lua/app/progress.h"
#include "lua/app/run_to_end.h"
#include "lua/study/case_run.h"
#include "lua/study/cluster.h"
#include "lua/study/dry_run.h"
#include "lua/study/gather_request.h"
#include "lua/study/pool.h"
#include "lua/study/shared_preparation.h"
#include "lua/study/stop_early.h"
#include "lua/study/study_files.h"
#include "lua/study/study_products.h"
#include "lua/study/study_record.h"
#include "lua/study/sweep_state.h"
#include "product/study/case_record.h"
#include "study/case_list.h"

namespace lsos {

namespace {

namespace fs = std::filesystem;

std::size_t processors() { return std::max(1u, std::thread::hardware_concurrency()); }

// What is made of all cases has all processors.
int product_threads(const SweepOptions& options) {
  return options.threads > 0 ? options.threads : static_cast<int>(processors());
}

void tell_warnings(const StudyFiles& files) {
  for (const Fault& fault : files.base.faults.sorted()) print_message("{}\n", to_string(fault));
}

bool ends_as(const ChildProcess::Ending& ending, CaseEnd end) {
  return ending.code == static_cast<int>(end);
}

// Whether less is left to do than before. One that cannot be run is not tried twice, unless each
// run is told to.
bool is_further(const ChildProcess::Ending& ending, const SweepOptions& options) {
  return ends_as(ending, CaseEnd::done) || ends_as(ending, CaseEnd::stopped) ||
         (ends_as(ending, CaseEnd::not_run) && options.retry.empty());
}

// What a sweep tells while it goes on.
class SweepNews {
 public:
  SweepNews(const std::string& folder, SweepState state, std::size_t jobs, bool is_quiet)
      : folder_(folder), state_(std::move(state)), jobs_(jobs), progress_(is_quiet) {}

  void end(std::int64_t number, const ChildProcess::Ending& ending) {
    const std::string file = case_folder(folder_, number) + "/" + case_file;
    if (const auto record = read_case_record(read_file(file).value_or(""))) {
      state_.add(record->status, record->wall_s);
      return;
    }
    const auto mark = read_case_record(read_file(not_run_file(folder_, number)).value_or(""));
    if (ends_as(ending, CaseEnd::stopped) || ends_as(ending, CaseEnd::no_further)) return;
    ++state_.not_run;
    progress_.finish();
    if (mark && ends_as(ending, CaseEnd::machine)) {
      print_message("case {} was not finished: {}; the next sweep goes on with it\n", number,
                    mark->reason);
      fs::remove(not_run_file(folder_, number));
    } else if (mark) {
      print_message("case {} could not be run: {}\n", number, mark->reason);
    } else if (ends_as(ending, CaseEnd::elsewhere)) {
      print_message("case {} is run by another process\n", number);
    } else {
      print_message("case {} was ended by {} {}; the next sweep goes on with it\n", number,
                    ending.signal ? "signal" : "exit code",
                    ending.signal ? *ending.signal : ending.code.value_or(-1));
    }
  }

  void turn(std::size_t running) {
    if (!progress_.is_due()) return;
    const double share = static_cast<double>(state_.cases - state_.missing()) /
                         static_cast<double>(std::max<std::int64_t>(1, state_.cases));
    progress_.show_state(share, fmt::format("{}, {} running", to_text(state_), running),
                         state_.left_s(jobs_));
  }

  void finish() { progress_.finish(); }

 private:
  const std::string& folder_;
  SweepState state_;
  std::size_t jobs_;
  Progress progress_;
};

// Whether those of the cases that were asked for are done.
bool are_done(const std::vector<std::int64_t>& numbers, const std::string& folder) {
  return std::ranges::all_of(numbers, [&](std::int64_t number) { return is_done(folder, number); });
}

}  // namespace

std::string study_folder(const SweepOptions& options) {
  if (!options.folder.empty()) return options.folder;
  return (fs::path("out") / fs::path(options.study).stem()).string();
}

int sweep(const SweepOptions& options) {
  if (options.verb == "run") note_signals_for_pool();
  const StudyFiles files = read_study(options.study);
  check_columns(files);
  if (!options.is_quiet) tell_warnings(files);
  const std::string folder = study_folder(options);
  const auto jobs = options.jobs > 0 ? static_cast<std::size_t>(options.jobs) : processors();
  const std::vector<std::int64_t> wanted = listed_cases(options.cases, files.cases);
  if (options.is_dry) return dry_run(files, wanted, jobs, options);
  StopWatch enough(files, folder);
  const auto last_case = [&] { return enough.last_case().value_or(files.cases); };
  // Those that the study needs, unless --cases names some.
  const auto needed = [&] {
    return options.cases.empty() ? listed_cases("", last_case()) : wanted;
  };
  if (options.cluster.is_slurm) return send_to_slurm(files, needed(), folder, options);
  if (!options.cluster.print.empty()) return print_job_script(files, needed(), folder, options);
  open_study_folder(files, folder);
  const std::vector<std::int64_t> numbers = open_cases(needed(), folder, !options.retry.empty());
  for (const std::int64_t number : numbers) fs::remove(not_run_file(folder, number));
  const int threads =
      options.threads > 0 ? options.threads : std::max(1, static_cast<int>(processors() / jobs));
  // The few cases of a task are not worth it.
  if (numbers.size() > 1 && options.verb != "run") {
    prepare_for_cases(files, product_threads(options), options.is_quiet);
  }
  SweepNews news(folder, sweep_state(folder, needed()), jobs, options.is_quiet);
  // A machine that has failed holds a case on NFS for 90 s after its task runs on another one.
  const int wait_s = options.verb == "run" ? 120 : 10;
  Pool pool(jobs, [&](std::int64_t number) {
    catch_stop_signals();
    return static_cast<int>(run_case(files, number, folder, threads, wait_s));
  });
  bool has_progress = false;
  const int signal = pool.run(
      numbers,
      [&](std::int64_t number, const auto& ending) {
        news.end(number, ending);
        has_progress = has_progress || is_further(ending, options);
        if (options.cases.empty()) pool.begin_none_after(last_case());
      },
      [&] { news.turn(pool.running()); });
  news.finish();
  if (signal == SIGTERM && options.verb == "run" && !has_progress) {
    print_message("stopped before any case came further than before\n");
    return no_progress;
  }
  if (signal != 0) {
    print_message("stopped: the same command goes on\n");
    return 128 + signal;
  }
  if (options.verb != "run") write_study(files, folder, product_threads(options));
  // A task of a cluster may not see all cases that have told.
  if (enough.last_case() || options.verb != "run") note_last_case(folder, enough.last_case());
  const SweepState state = sweep_state(folder, needed());
  print_result("{}", options.is_json ? to_json(state) : to_text(state) + "\n");
  if (!options.is_json && enough.last_case()) print_result("{}\n", enough.text());
  if (!options.is_json) print_result("results in {}\n", folder);
  return are_done(needed(), folder) ? 0 : 1;
}

int sweep_status(const SweepOptions& options) {
  const std::string folder = study_folder(options);
  const SweepState state = sweep_state(folder, listed_cases("", cases_of_folder(folder)));
  print_result("{}", options.is_json ? to_json(state) : to_text(state) + "\n");
  return 0;
}

int sweep_gather(const SweepOptions& options) {
  const StudyFiles files = read_study(options.study);
  check_columns(files);
  const std::string folder = study_folder(options);
  check_study_folder(files, folder);
  const Gathered gathered = write_study(files, folder, product_threads(options));
  StopWatch enough(files, folder);
  const std::int64_t last_case = enough.last_case().value_or(files.cases);
  note_last_case(folder, enough.last_case());
  if (options.is_json) {
    print_result("{}", to_json(sweep_state(folder, listed_cases("", last_case))));
    return 0;
  }
  print_result("{} of {} cases in {}/{}, {} and {}\n", gathered.cases, last_case, folder,
               study_table, study_page_file, study_overlay_file);
  if (enough.last_case()) print_result("{}\n", enough.text());
  return 0;
}

}  // namespace lsos
