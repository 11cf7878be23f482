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
  std::string cases;   // "": all
  int jobs = 0;        // 0: as many as there are processors
  bool is_dry = false, is_quiet = false, is_json = false;
};

// Returns the program's exit code: 0 when all cases have run, whatever became of their missions, 1
// when one could not be run, 130 or 143 when a signal stopped it. Throws InputError.
int sweep(const SweepOptions& options);

}  // namespace lsos
