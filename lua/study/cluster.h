// Cases of a study that run on a cluster: their script is printed, or sent to Slurm.
#pragma once

#include "lua/study/study_files.h"
#include "lua/study/sweep_options.h"

namespace lsos {

// Return the exit code. Throw InputError. Both take those of the numbers that are missing in the
// study's folder.
int print_job_script(const StudyFiles& files, const std::vector<std::int64_t>& numbers,
                     const std::string& folder, const SweepOptions& options);
// Leaves the script, and what its tasks print, in the folder's own folder `slurm`.
int send_to_slurm(const StudyFiles& files, const std::vector<std::int64_t>& numbers,
                  const std::string& folder, const SweepOptions& options);

}  // namespace lsos
