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
    if (file.path == "lua/library.d.lua") continue;  // for editors, made from the registry
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

// Where a number is from stands behind it, or in the comment right above it.
bool is_graded(const std::vector<std::string>& lines, std::size_t i) {
  static const std::regex grade(R"(-- .*\b[VRDA]\b.*)"), comment(" *--.*");
  if (std::regex_search(lines[i], grade)) return true;
  while (i-- > 0 && std::regex_match(lines[i], comment)) {
    if (std::regex_search(lines[i], grade)) return true;
  }
  return false;
}

TEST(Rovers, say_of_every_number_where_it_is_from) {
  // radius_m = 0.4, size_m = lsos.vec3(1, 2, 3), local mass_kg = 5; not api = 1 and what is 0.
  const std::regex number(
      R"( *(local )?(?!api )\w+ *= (vec\(|lsos\.vec3|math\.rad|[-{0-9]).*[1-9].*)");
  int numbers = 0;
  for (const SourceFile& file : source_files({".lua"})) {
    if (file.path.parent_path() != "rovers") continue;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      if (!std::regex_match(file.lines[i], number)) continue;
      ++numbers;
      EXPECT_TRUE(is_graded(file.lines, i)) << file.path << ": " << file.lines[i];
    }
  }
  EXPECT_GT(numbers, 100);
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
  const std::regex pattern("(run|test|long) [a-z0-9.+-]+ +# .+");
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
