// Slurm, through the programs of its users: sbatch, scancel, squeue, scontrol and sacctmgr.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace lsos {

// What Slurm takes.
struct SlurmLimits {
  std::int64_t array_tasks = 1000;          // of one array
  std::optional<std::int64_t> submit_more;  // jobs of this user, beside those in the queue
};
// Asks Slurm; where it does not answer, its own default. Without accounting there is no limit of
// jobs.
SlurmLimits slurm_limits();

// An array of tasks, of which those before it are in other arrays.
struct TaskArray {
  std::int64_t before = 0, count = 0;
};
std::vector<TaskArray> task_arrays(std::int64_t tasks, std::int64_t array_tasks);

// The words after `sbatch` that send a script. `before`: the jobs of the arrays sent before. With a
// `limit` of tasks at a time arrays wait for each other, as Slurm counts each by itself.
std::vector<std::string> array_words(const TaskArray& array, int limit,
                                     const std::vector<std::string>& before);
// The same of the job that gathers what these arrays leave.
std::vector<std::string> gather_words(const std::vector<std::string>& arrays);

// Jobs that were sent for a study, by their numbers.
struct SlurmJobs {
  std::vector<std::string> arrays;
  std::string gather;  // "": not sent yet

  std::vector<std::string> all() const;
};

// Sends the script for the arrays, and once more to gather; what they print goes into `folder`.
// `on_sent` is called after each. Throws InputError in the words of sbatch, and then none of these
// jobs is left in the queue.
SlurmJobs send_jobs(const std::string& script, const std::vector<TaskArray>& arrays, int limit,
                    const std::string& folder,
                    const std::function<void(const SlurmJobs&)>& on_sent);

// Those of the jobs that still wait or run. Throws InputError in the words of squeue where it does
// not know.
std::vector<std::string> jobs_in_queue(const std::vector<std::string>& jobs);

}  // namespace lsos
