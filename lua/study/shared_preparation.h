// What the cases of a study share is made once, before their processes are forked.
#pragma once

#include "lua/study/study_files.h"

namespace lsos {

// Plans the ways of the study's own plan, which are kept beside it for the cases that drive them
// too, and makes the ground along them, unless each case has its own (another seed or terrain).
// Faults of a plan that no case may have are not told: each case tells its own.
void prepare_for_cases(const StudyFiles& files, int threads, bool is_quiet);

}  // namespace lsos
