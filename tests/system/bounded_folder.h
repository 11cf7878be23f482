// Folders with plans, scripts and ground that would take for ever or all memory, and what `check`
// says of them.
#pragma once

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "support/sanitizer.h"
#include "system/process.h"
#include "system/temp_folder.h"

namespace lsos::test {

// Runs the program with 4 GB of address space, but for sanitizers, which take terabytes. It is
// killed after two minutes, far more than it takes.
inline Outcome run_bounded(const Words& arguments, const Surroundings& where) {
  Words words{"timeout", "-s", "KILL", "120"};
  if (!is_sanitized) words.insert(words.begin(), {"prlimit", "--as=4200000000"});
  const Words own = program(arguments);
  words.insert(words.end(), own.begin(), own.end());
  return run_command(words, where);
}

inline std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

// A folder, and what `check` says of the plan in it.
struct Folder {
  std::string name;
  std::function<void(const TempFolder&)> fill;  // besides plan.kml, which it may replace
  int exit_code = 0;
  std::vector<std::string> told = {};
};

inline void PrintTo(const Folder& folder, std::ostream* out) { *out << folder.name; }

inline constexpr std::uintmax_t hundred_gib = std::uintmax_t{100} << 30;

inline void make_sparse(const std::filesystem::path& file) {
  EXPECT_EQ(mknod(file.c_str(), S_IFREG | 0600, 0), 0);
  std::filesystem::resize_file(file, hundred_gib);
}

// Fills the folder, and holds `check` to the time and the memory.
inline void expect_end(const Folder& of, const TempFolder& folder) {
  of.fill(folder);
  const Outcome outcome = run_bounded({"check", "plan.kml"}, {.folder = folder.path()});
  EXPECT_EQ(outcome.exit_code, of.exit_code)
      << outcome.out.substr(0, 500) << outcome.err.substr(0, 500);
  for (const std::string& told : of.told) {
    EXPECT_THAT(outcome.out + outcome.err, ::testing::HasSubstr(told));
  }
  EXPECT_LT(outcome.out.size() + outcome.err.size(), 100'000U);
}

}  // namespace lsos::test
