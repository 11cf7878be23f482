#include "system/run_folder.h"

#include <gtest/gtest.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

namespace lsos::test {

namespace fs = std::filesystem;

std::string query(const fs::path& database, const std::string& sql) {
  const Outcome outcome = run_command({"sqlite3", "-readonly", database.string(), sql});
  EXPECT_EQ(outcome.exit_code, 0) << sql << ": " << outcome.err;
  return outcome.out.substr(0, outcome.out.find_first_of("|\n"));
}

nlohmann::json summary(const fs::path& run_folder) {
  const std::string text = read_text(run_folder / "summary.json");
  return nlohmann::json::parse(text.empty() ? "null" : text);
}

std::string digest_of(const TempFolder& folder, const std::vector<Mark>& plan,
                      const Words& options) {
  Words arguments = {folder.write("plan.kml", kml(plan)), "--quiet", "--no-report", "-o",
                     folder / "run"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const nlohmann::json result = summary(folder / "run");
  return result.is_object() ? result.value("log_sha256", "") : "";
}

bool wait_for_samples(Process& process, const fs::path& run_folder) {
  const fs::path log = run_folder / "log.gpkg";
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while (process.is_running() && std::chrono::steady_clock::now() < deadline) {
    // Before the layers exist sqlite3 fails with a message on standard error.
    const Outcome outcome =
        run_command({"sqlite3", "-readonly", log.string(), "select count(*) > 0 from samples"});
    if (outcome.exit_code == 0 && outcome.out == "1\n") return process.is_running();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return false;
}

}  // namespace lsos::test
