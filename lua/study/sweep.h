// Runs a study on the processors of this machine.
#pragma once

#include <string>
#include <vector>

namespace lsos {

struct SweepOptions {
  std::vector<std::string> words;  // of the command line
  std::string verb;                // run, status, gather; "": run all and gather
  std::string study;
  std::string folder;  // "": out/STUDY-NAME
  std::string cases;   // "40-59,71"; "": all
  std::string retry;   // "failed": those that could not be run, too
  int jobs = 0;        // 0: as many as there are processors
  int threads = 0;     // of each case; 0: processors by jobs
  bool is_dry = false, is_quiet = false, is_json = false;
};

// Return the program's exit code: 0 when all cases that are asked for have run, whatever became of
// their missions, 1 when one could not be run, 130 or 143 when a signal stopped it. Throw
// InputError.
int sweep(const SweepOptions& options);
int sweep_status(const SweepOptions& options);
int sweep_gather(const SweepOptions& options);

// "out/STUDY-NAME" for "some/where/STUDY-NAME.lua", where no folder is named.
std::string study_folder(const SweepOptions& options);

// "40-59,71" as numbers in ascending order, each once. Throws InputError beyond 1..cases.
std::vector<std::int64_t> listed_cases(const std::string& text, std::int64_t cases);

}  // namespace lsos
