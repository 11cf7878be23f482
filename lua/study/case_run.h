// One case of a study, run in this process.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lua/study/study_files.h"

namespace lsos {

// How a case has ended in this process.
enum class CaseEnd {
  done,       // its folder is complete, whatever became of its mission
  stopped,    // by a signal, with a later checkpoint than before, from which it goes on
  not_run,    // its plan has faults, or the program failed; the mark says why
  machine,    // a full disk, too little memory; the mark says why, and the next sweep tries again
  elsewhere,  // another process runs it
  no_further  // stopped by a signal, where it was before
};

// Runs a case to its end, or goes on with it where another process was stopped or killed. The case
// is made in a folder NNNNNN.part, which is renamed once all is in it. `threads`: of this case.
// `wait_s`: how long it waits for another process to leave the case; one that was just killed may
// have left a process behind that writes its last checkpoint.
CaseEnd run_case(const StudyFiles& files, std::int64_t number, const std::string& study_folder,
                 int threads, int wait_s = 10);

bool is_done(const std::string& study_folder, std::int64_t number);

// Those of the numbers that are to be run: not done, and not marked as one that could not be run,
// unless these are tried again.
std::vector<std::int64_t> open_cases(std::vector<std::int64_t> numbers,
                                     const std::string& study_folder, bool tries_again);

}  // namespace lsos
