// `lsos-host sweep`: runs a study, or tells how far it is, or gathers what its cases have left.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/console.h"
#include "base/error.h"
#include "lua/app/commands.h"
#include "lua/study/job_script.h"
#include "lua/study/sweep.h"

namespace lsos {

namespace {

constexpr const char* verbs[] = {"run", "status", "gather"};

// "sweep STUDY" or "sweep VERB STUDY".
void read_words(SweepOptions& options) {
  std::vector<std::string> words = options.words;
  if (words.size() > 1 && std::ranges::find(verbs, words.front()) != std::end(verbs)) {
    options.verb = words.front();
    words.erase(words.begin());
  }
  if (words.size() != 1) {
    throw InputError({}, fmt::format("sweep {}: a study is wanted, as in 'sweep STUDY.lua', 'sweep "
                                     "run STUDY.lua', 'sweep status STUDY.lua' or 'sweep gather "
                                     "STUDY.lua'",
                                     fmt::join(options.words, " ")));
  }
  options.study = words.front();
  check_cluster_options(options.cluster);
  if (options.verb.empty() || !options.cluster.is_wanted()) return;
  throw InputError({}, fmt::format("sweep {}: --slurm and --print are for a whole study, as in "
                                   "'sweep {}'",
                                   options.verb, options.study));
}

void add_cluster_options(CommandOptions& command, ClusterOptions& cluster) {
  command.add_flag("--slurm", cluster.is_slurm, "Send the cases to Slurm, as tasks of job arrays");
  command.add_option("--print", cluster.print, "Print the script that runs them on a cluster")
      .one_of(engines());
  command.add_option("--chunk", cluster.chunk, "Cases of each task (20)").between(1, 999'999);
  command.add_option("--limit", cluster.limit, "Tasks at a time").between(1, 999'999);
  command.add_option("--time", cluster.time, "For each task: 90 (minutes), 1:30:00, 2-12:00:00");
  command.add_option("--partition", cluster.partition, "The partition, or queue, for the tasks");
  command
      .add_option("--directive", cluster.directives,
                  "A line of the script's head, as --directive=--account=moon")
      .repeated();
}

int sweep_command(SweepOptions options) {
  read_words(options);
  if (options.verb == "status") return sweep_status(options);
  if (options.verb == "gather") return sweep_gather(options);
  return sweep(options);
}

}  // namespace

std::function<int()> prepare_sweep(CommandOptions& command) {
  const auto options = std::make_shared<SweepOptions>();
  command.add_option("STUDY", options->words, "A study: a script that returns lsos.study {...}")
      .required();
  command.add_option("-o,--output", options->folder, "Folder of the results (out/STUDY-NAME)");
  command
      .add_option("-j,--jobs", options->jobs,
                  "Cases at a time (processors; 1 in a task of a cluster)")
      .between(1, 4096);
  command.add_option("--cases", options->cases,
                     "Only these, as 40-59 or 3,7,12-15; with run, --slurm and --print, too");
  command.add_option("--retry", options->retry, "failed: also the cases that could not be run")
      .one_of({"failed"});
  command
      .add_option("--threads", options->threads,
                  "Of each case (processors by jobs; 1 in a task of a cluster)")
      .between(1, 256);
  add_cluster_options(command, options->cluster);
  command.add_flag("--dry-run", options->is_dry, "List and check the cases; run none");
  command.add_flag("--quiet", options->is_quiet, "No progress");
  command.add_flag("--json", options->is_json, "The answer as JSON");
  return [options] { return sweep_command(*options); };
}

}  // namespace lsos
