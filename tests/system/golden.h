// Digests of the logs of shipped plans, kept in tests/golden/digests.txt, so that no change alters
// results unintentionally. LSOS_UPDATE_GOLDEN=1 writes them anew; the commit says why.
#pragma once

#include <filesystem>

namespace lsos::test {

// Expects the log of a run of the plan to have the digest that is kept of it, or writes that anew.
// Changes the log.
void expect_golden(const std::filesystem::path& plan, const std::filesystem::path& log);

}  // namespace lsos::test
