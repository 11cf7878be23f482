// Reads the mission of a run again from its folder.
#pragma once

#include <map>
#include <string>

#include "lua/host/mission_files.h"
#include "record/log.h"

namespace lsos {

// The mission is read from the plan's own file where that still is what was run, since scripts and
// rasters may lie beside it. Otherwise it is read from the copy in the run's folder, with the
// scripts of the working folder where those beside the copy do not suffice. Its faults are returned
// for the caller to weigh: scripts that are gone leave the rest of the plan usable. `run`: values
// of the log's layer.
MissionFiles mission_of_run(const std::string& folder,
                            const std::map<std::string, std::string>& run);

// Throws InputError where a run was killed before its first sample, so that nothing can be drawn.
void require_samples(const LogReader& log, const std::string& folder);

}  // namespace lsos
