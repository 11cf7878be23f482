// `lsos-host sweep --dry-run`: what a sweep would run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lua/study/study_files.h"
#include "lua/study/sweep_options.h"

namespace lsos {

// Lists the cases with their values, reads and checks the plan of each, and runs one to estimate
// what all take. Nothing is left behind. Returns the exit code: 2 where a plan has faults.
int dry_run(const StudyFiles& files, const std::vector<std::int64_t>& numbers, std::size_t jobs,
            const SweepOptions& options);

}  // namespace lsos
