// Runs a study on the processors of this machine.
#pragma once

#include <string>

#include "lua/study/sweep_options.h"

namespace lsos {

// Return the program's exit code: 0 when all cases that are asked for have run, whatever became of
// their missions, 1 when one could not be run, 130 or 143 when a signal stopped it, but no_progress
// where SIGTERM has stopped `sweep run` before any case came further: what runs the same again, as
// a batch system does, would never end. Throw InputError.
inline constexpr int no_progress = 75;
int sweep(const SweepOptions& options);
int sweep_status(const SweepOptions& options);
int sweep_gather(const SweepOptions& options);

// "out/STUDY-NAME" for "some/where/STUDY-NAME.lua", where no folder is named.
std::string study_folder(const SweepOptions& options);

}  // namespace lsos
