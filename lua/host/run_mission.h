// The mission that a run was made of, read again from its folder.
#pragma once

#include <map>
#include <string>

#include "lua/host/mission_files.h"
#include "record/log.h"

namespace lsos {

// From the plan's own file where that is what was run, since scripts and rasters may lie beside it;
// else from the copy in the run's folder, with the scripts of the working folder where those beside
// the copy do not do. With its faults, which the caller weighs: those of scripts that
// are gone leave the rest of the plan. `run`: values of the log's layer.
MissionFiles mission_of_run(const std::string& folder,
                            const std::map<std::string, std::string>& run);

// Throws InputError where a run was killed before its first sample: nothing of it can be drawn.
void require_samples(const LogReader& log, const std::string& folder);

}  // namespace lsos
