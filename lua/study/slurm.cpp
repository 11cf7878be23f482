#include "lua/study/slurm.h"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <sstream>

#include "base/child_process.h"
#include "base/error.h"
#include "base/quantity.h"
#include "base/replaced.h"
#include "base/text.h"

namespace lsos {

namespace {

using Words = std::vector<std::string>;

std::string user_name() { return program_output({"id", "-un"}).text; }

Words lines_of(const std::string& text) {
  std::istringstream stream(text);
  Words lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// The value of "NAME   = VALUE" in what scontrol prints.
std::optional<std::int64_t> configured(const std::string& config, const std::string& name) {
  for (const std::string& line : lines_of(config)) {
    const std::size_t equal = line.find('=');
    if (equal == std::string::npos || trimmed(line.substr(0, equal)) != name) continue;
    const Parsed<std::int64_t> value = parse_integer(trimmed(line.substr(equal + 1)));
    if (value) return *value.value;
  }
  return {};
}

// The limit of a site on the tasks of an array, among its SchedulerParameters.
std::optional<std::int64_t> max_array_tasks(const std::string& config) {
  static const std::regex pattern(
      R"((?:^|\n)\s*SchedulerParameters\s*=(?:.*,)?\s*max_array_tasks=(\d{1,9})(?!\d))");
  std::smatch match;
  if (!std::regex_search(config, match, pattern)) return {};
  return std::stoll(match[1].str());
}

// The least limit of the user's accounts.
std::optional<std::int64_t> submit_max(const std::string& user) {
  const ProgramOutput answer =
      program_output({"sacctmgr", "--noheader", "--parsable2", "show", "assoc", "where",
                      "user=" + user, "format=MaxSubmitJobs"});
  std::optional<std::int64_t> least;
  if (!answer.is_success()) return least;
  for (const std::string& line : lines_of(answer.text)) {
    const Parsed<std::int64_t> value = parse_integer(trimmed(line));
    if (value && (!least || *value.value < *least)) least = *value.value;
  }
  return least;
}

std::int64_t count_queued(const std::string& user) {
  const ProgramOutput answer =
      program_output({"squeue", "--noheader", "--array", "--user=" + user, "--format=%i"});
  if (!answer.is_success()) return 0;
  // Warnings may stand among them.
  return std::ranges::count_if(lines_of(answer.text), [](const std::string& line) {
    return !line.empty() && line[0] >= '0' && line[0] <= '9';
  });
}

// The number in what `sbatch --parsable` prints, "123" or "123;CLUSTER", among a site's own words.
// Where a site's sbatch does not know the option: "Submitted batch job 123".
std::optional<std::string> job_in(const std::string& text) {
  static const std::regex pattern(R"((?:Submitted batch job )?(\d+)(?:;.*| on cluster .*)?)");
  for (const std::string& line : lines_of(text)) {
    std::smatch match;
    if (std::regex_match(line, match, pattern)) return match[1].str();
  }
  return {};
}

// Takes the jobs out of the queue. Returns how that is to be done where it fails, else "".
std::string take_back(const Words& sent) {
  if (sent.empty()) return "";
  Words cancel{"scancel"};
  cancel.insert(cancel.end(), sent.begin(), sent.end());
  if (program_output(cancel).is_success()) return "";
  return fmt::format("; what is in the queue already goes by 'scancel {}'", fmt::join(sent, " "));
}

[[noreturn]] void refuse_job(const std::string& words, const Words& sent) {
  const std::string left = take_back(sent);
  // AssocMaxSubmitJobLimit, QOSMaxSubmitJobPerUserLimit, ...
  const bool is_limit = words.find("Submit") != std::string::npos;
  throw InputError(
      {}, fmt::format("sbatch has refused a job: {}{}{}", words.empty() ? "it says nothing" : words,
                      left.empty() ? "; nothing is in the queue" : left,
                      is_limit ? "; fewer tasks of more cases: --chunk" : ""));
}

std::string send(Words words, const Words& sent) {
  words.insert(words.begin(), {"sbatch", "--parsable"});
  const ProgramOutput answer = program_output(words);
  if (!answer.is_success()) refuse_job(answer.text, sent);
  if (const std::optional<std::string> job = job_in(answer.text)) return *job;
  throw InputError({}, fmt::format("sbatch has sent a job and given an answer without its number: "
                                   "'{}'; 'squeue --me' shows the job, and scancel ends it{}",
                                   answer.text, take_back(sent)));
}

}  // namespace

SlurmLimits slurm_limits() {
  SlurmLimits limits;
  const ProgramOutput config = program_output({"scontrol", "show", "config"});
  if (!config.is_success()) return limits;
  if (const auto size = configured(config.text, "MaxArraySize")) limits.array_tasks = *size - 1;
  if (const auto most = max_array_tasks(config.text)) {
    limits.array_tasks = std::min(limits.array_tasks, *most);
  }
  const std::string user = user_name();
  if (const auto most = submit_max(user)) {
    limits.submit_more = std::max<std::int64_t>(0, *most - count_queued(user));
  }
  return limits;
}

std::vector<TaskArray> task_arrays(std::int64_t tasks, std::int64_t array_tasks) {
  std::vector<TaskArray> arrays;
  for (std::int64_t before = 0; before < tasks; before += array_tasks) {
    arrays.push_back({before, std::min(array_tasks, tasks - before)});
  }
  return arrays;
}

Words array_words(const TaskArray& array, int limit, const Words& before) {
  Words words{fmt::format("--array=1-{}", array.count)};
  if (limit > 0) {
    words.back() += fmt::format("%{}", limit);
    if (!before.empty()) words.push_back("--dependency=afterany:" + before.back());
  }
  return words;
}

Words gather_words(const Words& arrays) {
  return {fmt::format("--dependency=afterany:{}", fmt::join(arrays, ":"))};
}

Words SlurmJobs::all() const {
  Words jobs = arrays;
  if (!gather.empty()) jobs.push_back(gather);
  return jobs;
}

SlurmJobs send_jobs(const std::string& script, const std::vector<TaskArray>& arrays, int limit,
                    const std::string& folder,
                    const std::function<void(const SlurmJobs&)>& on_sent) {
  // A % would begin a pattern.
  const std::string output = "--output=" + replaced(folder, "%", "%%");
  SlurmJobs jobs;
  for (const TaskArray& array : arrays) {
    Words words = array_words(array, limit, jobs.arrays);
    words.insert(words.end(), {output + "/%A_%a.txt", script, std::to_string(array.before)});
    jobs.arrays.push_back(send(words, jobs.arrays));
    on_sent(jobs);
  }
  Words words = gather_words(jobs.arrays);
  words.insert(words.end(), {output + "/gather.txt", script, "gather"});
  jobs.gather = send(words, jobs.arrays);
  on_sent(jobs);
  return jobs;
}

Words jobs_in_queue(const Words& jobs) {
  Words queued;
  if (jobs.empty()) return queued;
  const ProgramOutput answer = program_output(
      {"squeue", "--noheader", "--format=%F", fmt::format("--jobs={}", fmt::join(jobs, ","))});
  // The answer where a single job is long gone.
  const bool is_gone = answer.text.find("Invalid job id") != std::string::npos;
  if (!answer.is_success() && !is_gone) {
    const std::string words = answer.text.empty() ? "it cannot be run" : answer.text;
    throw InputError({},
                     fmt::format("squeue does not say whether job{} {} of this study still "
                                 "wait{} or run{}: {}",
                                 jobs.size() > 1 ? "s" : "", fmt::join(jobs, " "),
                                 jobs.size() > 1 ? "" : "s", jobs.size() > 1 ? "" : "s", words));
  }
  for (const std::string& line : lines_of(answer.text)) {
    const std::string job(trimmed(line));
    const bool is_known = std::ranges::count(jobs, job) > 0;
    if (is_known && std::ranges::count(queued, job) == 0) queued.push_back(job);
  }
  return queued;
}

}  // namespace lsos
