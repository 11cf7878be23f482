// What a run has left, read with tools that are not ours.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "system/plan_text.h"
#include "system/process.h"
#include "system/temp_folder.h"

namespace lsos::test {

// The first column of the answer's first row, by the sqlite3 program; "" with a message on failure.
std::string query(const std::filesystem::path& database, const std::string& sql);

// summary.json of a run's folder; null when there is none.
nlohmann::json summary(const std::filesystem::path& run_folder);

// Runs a plan into `folder`/run with further options; expects exit 0.
// Answers log_sha256 of its summary.
std::string digest_of(const TempFolder& folder, const std::vector<Mark>& plan,
                      const Words& options = {});

// Waits until a run that goes on has committed rows of samples; false after half a minute.
bool wait_for_samples(Process& process, const std::filesystem::path& run_folder);

}  // namespace lsos::test
