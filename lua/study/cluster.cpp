#include "lua/study/cluster.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/child_process.h"
#include "base/console.h"
#include "base/error.h"
#include "base/file_lock.h"
#include "base/files.h"
#include "lua/study/case_run.h"
#include "lua/study/job_script.h"
#include "lua/study/slurm.h"
#include "lua/study/study_record.h"
#include "product/study/case_record.h"
#include "study/case_list.h"
#include "study/shell_word.h"

namespace lsos {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

constexpr const char* jobs_file = "jobs.json";

// Cases in tasks of as many as are wanted, or of more where there may not be so many jobs, of which
// one gathers.
JobTasks tasks_of(const std::vector<std::int64_t>& numbers, const ClusterOptions& options,
                  const std::optional<std::int64_t>& submit_more) {
  const auto count = static_cast<std::int64_t>(numbers.size());
  const std::int64_t wanted = options.chunk > 0 ? options.chunk : default_chunk;
  std::int64_t chunk = wanted;
  if (submit_more) {
    const std::int64_t tasks_max = std::max<std::int64_t>(1, *submit_more - 1);
    chunk = std::max(chunk, (count + tasks_max - 1) / tasks_max);
  }
  if (chunk > wanted) {
    print_message("tasks have {} cases in place of {}, as this user may send {} more jobs\n", chunk,
                  wanted, *submit_more);
  }
  return {case_chunks(numbers, static_cast<std::size_t>(chunk)), count};
}

// The commands that send a script called job.sh.
Words submit_lines(const std::vector<TaskArray>& arrays, int limit) {
  const auto line = [](const Words& words, const std::string& argument) {
    return fmt::format("{} job.sh {}", fmt::join(words, " "), argument);
  };
  Words lines, jobs;
  for (const TaskArray& array : arrays) {
    lines.push_back(
        fmt::format("job{}=$(sbatch --parsable {})", jobs.size() + 1,
                    line(array_words(array, limit, jobs), std::to_string(array.before))));
    // Where there are several clusters sbatch says "NUMBER;CLUSTER".
    jobs.push_back(fmt::format("${{job{}%%;*}}", jobs.size() + 1));
  }
  lines.push_back("sbatch " + line(gather_words(jobs), "gather"));
  return lines;
}

std::vector<TaskArray> arrays_for(const JobTasks& tasks, const SlurmLimits& limits) {
  if (limits.array_tasks < 1) {
    throw InputError({},
                     "this Slurm has no job arrays (MaxArraySize, max_array_tasks); --print "
                     "parallel prints a "
                     "script that runs all tasks in one job");
  }
  return task_arrays(static_cast<std::int64_t>(tasks.cases.size()), limits.array_tasks);
}

// Jobs of an earlier call that would run the same cases once more.
void refuse_queued(const std::string& folder) {
  const Json record = Json::parse(read_file(folder + "/" + jobs_file).value_or(""), nullptr, false);
  Words jobs;
  for (const auto& job : record.is_array() ? record : Json::array()) {
    if (job.is_string()) jobs.push_back(job.get<std::string>());
  }
  const Words queued = jobs_in_queue(jobs);
  if (queued.empty()) return;
  throw InputError({},
                   fmt::format("job{0} {1} of this study still wait{2} or run{2}: 'scancel {1}' "
                               "ends {3}, 'lsos-host sweep status' tells how far the study is",
                               queued.size() > 1 ? "s" : "", fmt::join(queued, " "),
                               queued.size() > 1 ? "" : "s", queued.size() > 1 ? "them" : "it"));
}

bool tell_if_none(const std::vector<std::int64_t>& missing, const std::string& folder) {
  if (!missing.empty()) return false;
  print_message("no case is missing in {}: 'lsos-host sweep gather' makes the table\n", folder);
  return true;
}

void print_json(const SlurmJobs& jobs, const JobTasks& tasks) {
  const Json answer{{"cases", tasks.case_count},
                    {"tasks", tasks.cases.size()},
                    {"arrays", jobs.arrays},
                    {"gather", jobs.gather.empty() ? Json() : Json(jobs.gather)}};
  print_result("{}\n", answer.dump(2));
}

void print_sent(const SlurmJobs& jobs, const JobTasks& tasks, const std::string& folder) {
  const auto count = [](std::int64_t number, const char* what) {
    return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
  };
  print_result("{} {} in the queue as {} of job{} {}; job {} gathers what they leave\n",
               count(tasks.case_count, "case"), tasks.case_count == 1 ? "is" : "are",
               count(static_cast<std::int64_t>(tasks.cases.size()), "task"),
               jobs.arrays.size() > 1 ? "s" : "", fmt::join(jobs.arrays, ", "), jobs.gather);
  print_result("'lsos-host sweep status' tells how far the study is; what tasks print is in {}\n",
               folder);
}

}  // namespace

int print_job_script(const StudyFiles& files, const std::vector<std::int64_t>& numbers,
                     const std::string& folder, const SweepOptions& options) {
  if (fs::exists(folder + "/" + study_file)) check_study_folder(files, folder);
  const auto missing = open_cases(numbers, folder, !options.retry.empty());
  if (tell_if_none(missing, folder)) return 0;
  const std::string& engine = options.cluster.print;
  SlurmLimits limits;
  if (engine == "slurm") limits = slurm_limits();
  JobTasks tasks = tasks_of(missing, options.cluster, limits.submit_more);
  tasks.retry = options.retry;
  if (engine == "slurm") {
    tasks.submit = submit_lines(arrays_for(tasks, limits), options.cluster.limit);
  }
  print_result("{}", job_script(engine, files, folder, options, tasks));
  return 0;
}

int send_to_slurm(const StudyFiles& files, const std::vector<std::int64_t>& numbers,
                  const std::string& folder, const SweepOptions& options) {
  if (program_in_path("sbatch").empty()) {
    throw InputError({},
                     "--slurm: there is no sbatch in PATH, as there is where jobs are sent from; "
                     "--print slurm prints the script");
  }
  const std::string own = path_from_root(folder) + "/slurm";
  if (own.find('\\') != std::string::npos) {
    throw InputError({folder},
                     "Slurm writes nothing into a folder whose name has a backslash; -o "
                     "names another");
  }
  open_study_folder(files, folder);
  fs::create_directories(own);
  const std::string lock_file = own + "/.lsos-host.lock";
  std::ofstream(lock_file, std::ios::app).close();
  const FileLock lock(lock_file);  // until the jobs are noted, for a second call to see them
  refuse_queued(own);
  const auto missing = open_cases(numbers, folder, !options.retry.empty());
  if (tell_if_none(missing, folder)) {
    if (options.is_json) print_json({}, {});
    return 0;
  }
  const SlurmLimits limits = slurm_limits();
  if (limits.submit_more && *limits.submit_more < 2) {  // one gathers
    throw InputError({}, fmt::format("--slurm: this user may send {} more jobs (MaxSubmitJobs), "
                                     "and 2 at least are wanted",
                                     *limits.submit_more));
  }
  JobTasks tasks = tasks_of(missing, options.cluster, limits.submit_more);
  const std::vector<TaskArray> arrays = arrays_for(tasks, limits);
  tasks.submit = submit_lines(arrays, options.cluster.limit);
  const std::string script = own + "/job.sh";
  const std::string text = job_script("slurm", files, folder, options, tasks);
  write_file(script, text);
  // Those that could not be run are tried again by this call, but not each time that a task starts.
  for (const std::int64_t number : missing) fs::remove(not_run_file(folder, number));
  const SlurmJobs jobs = send_jobs(
      script, arrays, options.cluster.limit, own,
      [&](const SlurmJobs& sent) { write_file(own + "/" + jobs_file, Json(sent.all()).dump()); });
  if (options.is_json) {
    print_json(jobs, tasks);
  } else {
    print_sent(jobs, tasks, own);
  }
  return 0;
}

}  // namespace lsos
