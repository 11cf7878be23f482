// `lsos-host sweep`: runs a study, or tells how far it is, or gathers what its cases have left.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/console.h"
#include "base/error.h"
#include "lua/app/commands.h"
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
  command.add_option("-j,--jobs", options->jobs, "Cases at a time (processors)").between(1, 4096);
  command.add_option("--cases", options->cases, "run: only these, as 40-59 or 3,7,12-15");
  command.add_option("--retry", options->retry, "failed: also the cases that could not be run")
      .one_of({"failed"});
  command.add_option("--threads", options->threads, "Of each case (processors by jobs)")
      .between(1, 256);
  command.add_flag("--dry-run", options->is_dry, "List and check the cases; run none");
  command.add_flag("--quiet", options->is_quiet, "No progress");
  command.add_flag("--json", options->is_json, "The answer as JSON");
  return [options] { return sweep_command(*options); };
}

}  // namespace lsos
