// Properties of the source tree that readers rely on: short files that say their purpose.

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "system/source_files.h"

namespace lsos::test {
namespace {

constexpr std::size_t lines_max = 400;

TEST(SourceFiles, are_no_longer_than_a_reader_can_hold) {
  for (const SourceFile& file : source_files({".h", ".cpp", ".lua"})) {
    if (file.path == "lua/library.d.lua") continue;  // generated from the registry, for editors
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
    // Scripts that are wrong on purpose; their first lines give the expected message.
    if (file.path.string().starts_with("tests/messages/")) continue;
    ASSERT_FALSE(file.lines.empty()) << file.path;
    EXPECT_TRUE(file.lines[0].starts_with("--")) << file.path << " starts without a comment";
  }
}

// Whether the source of a number is given behind it, or in the comment right above it.
bool is_graded(const std::vector<std::string>& lines, std::size_t i) {
  static const std::regex grade(R"(-- .*\b[VSRDA]\b.*)"), comment(" *--.*");
  if (std::regex_search(lines[i], grade)) return true;
  while (i-- > 0 && std::regex_match(lines[i], comment)) {
    if (std::regex_search(lines[i], grade)) return true;
  }
  return false;
}

TEST(Rovers, say_of_every_number_where_it_is_from) {
  // Matches radius_m = 0.4, size_m = lsos.vec3(1, 2, 3), local mass_kg = 5; not api = 1 or zeros.
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

// A comment that begins so is a fragment whose subject the reader has to guess.
TEST(Comments, begin_with_their_subject) {
  static const std::regex comment(R"(^(.*?)// (.*)$)"), fragment(R"(^(Of|That|By|So)\b.*)");
  for (const SourceFile& file : source_files({".h", ".cpp"})) {
    bool is_in_block = false;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      std::smatch match;
      const bool is_comment = std::regex_match(file.lines[i], match, comment);
      const bool is_alone =
          is_comment && match[1].str().find_first_not_of(' ') == std::string::npos;
      if (is_comment && !(is_alone && is_in_block)) {
        EXPECT_FALSE(std::regex_match(match[2].str(), fragment))
            << file.path << ":" << i + 1 << ": " << match[2];
      }
      is_in_block = is_alone;
    }
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
