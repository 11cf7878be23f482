// Reads the results of a run with other tools than the program's own.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "system/plan_text.h"
#include "system/process.h"
#include "system/temp_folder.h"

namespace lsos::test {

// First column of the result's first row, by the sqlite3 program. "" on failure, with a message.
std::string query(const std::filesystem::path& database, const std::string& sql);

// summary.json of a run's folder; null when there is none.
nlohmann::json summary(const std::filesystem::path& run_folder);

// Runs a plan into `folder`/run with further options, expects exit code 0, and returns log_sha256
// of its summary.
std::string digest_of(const TempFolder& folder, const std::vector<Mark>& plan,
                      const Words& options = {});

// Waits until a running program has committed rows of samples. False when it ended before, or after
// half a minute.
bool wait_for_samples(Process& process, const std::filesystem::path& run_folder);

}  // namespace lsos::test
