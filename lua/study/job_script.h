// The script by which a cluster's engine runs the cases of a study, from a template of cluster/.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lua/study/study_files.h"
#include "lua/study/sweep_options.h"

namespace lsos {

// The engines that have a template.
const std::vector<std::string>& engines();

// Cases of one task of an array each, "40-59", and what is said of them.
struct JobTasks {
  std::vector<std::string> cases;
  std::int64_t case_count = 0;
  std::vector<std::string> submit = {};  // the commands that send the script
  std::string retry = {};  // "failed": so the tasks are told, where that was not done for them
};

// A path from the root, by the name of the working folder that the user sees: what it is a link to
// need not be there on other machines.
std::string path_from_root(const std::string& path);

// The script of an engine. `folder`: of the study's results. Throws InputError where there is no
// template, where an option has no place in it, and where a name has a line break, which would end
// a line of the script.
std::string job_script(const std::string& engine, const StudyFiles& files,
                       const std::string& folder, const SweepOptions& options,
                       const JobTasks& tasks);

}  // namespace lsos
