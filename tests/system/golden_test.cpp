// Compares the logs of all shipped plans with the digests in tests/golden/digests.txt, so that no
// change alters results unintentionally. LSOS_UPDATE_GOLDEN=1 writes the digests anew; the commit
// says why.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>

#include "record/log.h"
#include "system/run_folder.h"
#include "system/source_files.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;

const fs::path golden = repository() / "tests/golden/digests.txt";

// Digest of all layers, without the values in `run` that a new version or a comment in a script
// changes.
std::string golden_digest(const fs::path& log) {
  const Outcome outcome = run_command(
      {"sqlite3", log.string(),
       "delete from run where key = 'program_version' or key like '%\\_sha256' escape '\\'"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return LogReader(log.string()).sha256();
}

std::map<std::string, std::string> kept_digests() {
  std::map<std::string, std::string> digests;
  std::ifstream file(golden);
  for (std::string plan, digest; file >> plan >> digest;) digests[plan] = digest;
  return digests;
}

std::vector<std::string> shipped_plans() {
  std::vector<std::string> plans;
  for (const auto& entry : fs::directory_iterator(repository() / "plans")) {
    if (entry.path().extension() == ".kml") plans.push_back(entry.path().filename());
  }
  std::ranges::sort(plans);
  return plans;
}

TEST(Golden, logs_of_shipped_plans_are_as_they_were) {
  const bool is_renewed = std::getenv("LSOS_UPDATE_GOLDEN") != nullptr;
  std::map<std::string, std::string> kept = kept_digests(), found;
  for (const std::string& plan : shipped_plans()) {
    const TempFolder folder;
    run({repository() / "plans" / plan, "-o", folder / "run", "--quiet", "--no-report"});
    found[plan] = golden_digest(folder / "run/log.gpkg");
    if (is_renewed) continue;
    EXPECT_EQ(found[plan], kept[plan]) << plan;
  }
  EXPECT_GE(found.size(), 5u);
  if (!is_renewed) return;
  std::ofstream file(golden);
  for (const auto& [plan, digest] : found) file << plan << ' ' << digest << '\n';
}

}  // namespace
}  // namespace lsos::test
