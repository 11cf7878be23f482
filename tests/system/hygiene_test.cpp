// Habits of the tree that a reader relies on: short files that say what they are for.

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "system/source_files.h"

namespace lsos::test {
namespace {

constexpr std::size_t lines_max = 400;

TEST(SourceFiles, are_no_longer_than_a_reader_can_hold) {
  for (const SourceFile& file : source_files({".h", ".cpp", ".lua"})) {
    EXPECT_LE(file.lines.size(), lines_max) << file.path;
  }
}

TEST(Headers, say_what_they_are_for_and_are_included_once) {
  for (const SourceFile& file : source_files({".h"})) {
    ASSERT_FALSE(file.lines.empty()) << file.path;
    EXPECT_TRUE(file.lines[0].starts_with("// ")) << file.path << " starts without a comment";
    EXPECT_GT(std::ranges::count(file.lines, "#pragma once"), 0) << file.path;
  }
}

TEST(Scripts, say_what_they_are_for) {
  for (const SourceFile& file : source_files({".lua"})) {
    // Wrong on purpose; the first lines say what message is expected.
    if (file.path.string().starts_with("tests/messages/")) continue;
    ASSERT_FALSE(file.lines.empty()) << file.path;
    EXPECT_TRUE(file.lines[0].starts_with("--")) << file.path << " starts without a comment";
  }
}

TEST(Sources, start_with_a_comment_or_with_their_header) {
  for (const SourceFile& file : source_files({".cpp"})) {
    ASSERT_FALSE(file.lines.empty()) << file.path;
    EXPECT_TRUE(file.lines[0].starts_with("// ") || file.lines[0].starts_with("#include"))
        << file.path << ": " << file.lines[0];
  }
}

TEST(SourceFiles, are_found_at_all) { EXPECT_GT(source_files({".h", ".cpp"}).size(), 40u); }

TEST(Changelog, has_an_entry_for_this_version) {
  const std::vector<std::string> lines = read_lines(repository() / "CHANGELOG.md");
  const std::string heading = std::string("## ") + LSOS_VERSION;
  EXPECT_TRUE(std::ranges::any_of(
      lines, [&](const std::string& line) { return line.starts_with(heading); }))
      << "no '" << heading << "' in CHANGELOG.md";
}

TEST(Packages, have_a_group_and_a_reason_each) {
  const std::regex pattern("(run|test) [a-z0-9.+-]+ +# .+");
  int packages = 0;
  for (const std::string& line : read_lines(repository() / "script" / "packages.txt")) {
    if (line.starts_with('#')) continue;
    ++packages;
    EXPECT_TRUE(std::regex_match(line, pattern)) << line;
  }
  EXPECT_GT(packages, 10);
}

}  // namespace
}  // namespace lsos::test
