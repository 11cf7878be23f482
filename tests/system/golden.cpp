#include "system/golden.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <string>

#include "record/log.h"
#include "system/process.h"
#include "system/source_files.h"

namespace lsos::test {

namespace {

namespace fs = std::filesystem;

fs::path kept_file() { return repository() / "tests/golden/digests.txt"; }

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
  std::ifstream file(kept_file());
  for (std::string plan, digest; file >> plan >> digest;) digests[plan] = digest;
  return digests;
}

}  // namespace

void expect_golden(const fs::path& plan, const fs::path& log) {
  std::map<std::string, std::string> kept = kept_digests();
  std::string& digest = kept[plan.filename()];
  const std::string found = golden_digest(log);
  if (std::getenv("LSOS_UPDATE_GOLDEN") == nullptr) {
    EXPECT_EQ(found, digest) << plan;
    return;
  }
  digest = found;
  std::ofstream file(kept_file());
  for (const auto& [name, of_plan] : kept) file << name << ' ' << of_plan << '\n';
}

}  // namespace lsos::test
