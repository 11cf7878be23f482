// Shipped plans, and KML files by what they say.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "system/process.h"
#include "system/source_files.h"

namespace lsos::test {

inline std::string plan(const std::string& name) {
  return repository() / "plans" / (name + ".kml");
}

// The document in W3C's canonical form.
inline std::string canonical(const std::string& file) {
  const Outcome outcome = run_command({"xmllint", "--nonet", "--c14n", file});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return outcome.out;
}

}  // namespace lsos::test
