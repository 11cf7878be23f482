#include "system/golden.h"

#include <gtest/gtest.h>

#include "system/run_folder.h"
#include "system/source_files.h"

namespace lsos::test {
namespace {

// Plans of weeks are compared where they are run, in long_plans_test.cpp.
TEST(Golden, logs_of_shipped_plans_are_as_they_were) {
  for (const std::filesystem::path& plan : shipped_plans()) {
    const TempFolder folder;
    run({plan, "-o", folder / "run", "--quiet", "--no-report"});
    expect_golden(plan, folder / "run/log.gpkg");
  }
}

}  // namespace
}  // namespace lsos::test
