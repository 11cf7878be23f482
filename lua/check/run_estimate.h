// The estimate of a mission that has been run, which its report sets beside the results.
#pragma once

#include <string>

#include "lua/host/mission_files.h"
#include "record/log.h"

namespace lsos {

// The text of `estimate_file`. `legs`: routes that the run planned, see PlannedLegs; "": those that
// are kept beside the plan, what is missing is planned again. Throws InputError where the mission
// cannot be estimated.
std::string run_estimate(const MissionFiles& files, const std::string& legs, int threads);

// The same of the run in that folder, whose mission is read again. Throws InputError also where the
// run began as another one ended, which is not read again.
std::string run_estimate_again(const std::string& run_dir, const LogReader& log, int threads);

}  // namespace lsos
