// Every message that a user can cause has a file: a wrong plan in tests/messages/plan, a plan that
// does not fit its scripts or its ground in tests/messages/mission, or a command line in
// tests/messages/options. A new file is a new case; tests/README.md gives the format.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "system/process.h"
#include "system/source_files.h"
#include "system/temp_folder.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

const fs::path messages = repository() / "tests" / "messages";

std::vector<std::string> names(const fs::path& folder, const std::string& extension) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == extension) names.push_back(entry.path().filename());
  }
  std::ranges::sort(names);
  return names;
}

std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = fs::path(info.param).replace_extension();
  std::ranges::replace_if(
      name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

// The texts between `key` and `ending` in the lines that have both.
Words values(const std::vector<std::string>& lines, const std::string& key,
             const std::string& ending = "") {
  Words values;
  for (const std::string& line : lines) {
    if (!line.starts_with(key) || !line.ends_with(ending)) continue;
    values.push_back(line.substr(key.size(), line.size() - key.size() - ending.size()));
  }
  return values;
}

// "plan/a.kml", "mission/b.kml", ...
std::vector<std::string> plans() {
  std::vector<std::string> all;
  for (const char* folder : {"plan", "mission"}) {
    for (const std::string& name : names(messages / folder, ".kml")) {
      all.push_back(std::string(folder) + "/" + name);
    }
  }
  return all;
}

class PlanMessage : public ::testing::TestWithParam<std::string> {};

TEST_P(PlanMessage, is_as_expected) {
  const fs::path file = messages / GetParam();
  Words expected = values(read_lines(file), "<!-- expect: ", " -->");
  // {here} stands for the folder of the plan, in names of files beside it.
  for (std::string& text : expected) {
    const std::size_t at = text.find("{here}");
    if (at != std::string::npos) text.replace(at, 6, file.parent_path());
  }
  ASSERT_FALSE(expected.empty()) << "the first lines must be <!-- expect: TEXT -->";
  const bool only_warnings = std::ranges::all_of(expected, [](const std::string& text) {
    return text.find("warning: ") != std::string::npos;
  });

  const Outcome outcome = run({"check", file.string()});
  EXPECT_EQ(outcome.exit_code, only_warnings ? 0 : 2) << outcome.err;
  for (const std::string& text : expected) EXPECT_THAT(outcome.err + outcome.out, HasSubstr(text));
  // No other fault of the plan is reported, such as one that only follows from another.
  std::istringstream output(outcome.out);
  for (std::string line; std::getline(output, line);) {
    if (!line.starts_with(file.string() + ":") || outcome.exit_code == 0) continue;
    EXPECT_TRUE(std::ranges::any_of(expected, [&](const std::string& text) {
      return line.find(text) != std::string::npos;
    })) << line;
  }
}

INSTANTIATE_TEST_SUITE_P(Messages, PlanMessage, ::testing::ValuesIn(plans()), test_name);

class OptionsMessage : public ::testing::TestWithParam<std::string> {};

TEST_P(OptionsMessage, is_as_expected) {
  const std::vector<std::string> lines = read_lines(messages / "options" / GetParam());
  const Words expected = values(lines, "expect: ");
  const Words exit = values(lines, "exit: ");
  const Words args = values(lines, "args:");
  ASSERT_FALSE(expected.empty()) << "a line 'expect: TEXT' is wanted";
  ASSERT_EQ(exit.size(), 1u) << "one line 'exit: N' is wanted";
  ASSERT_EQ(args.size(), 1u) << "one line 'args: ...' is wanted";
  std::istringstream words(args[0]);
  const Words arguments{std::istream_iterator<std::string>(words), {}};

  // The temporary folder holds a correct plan, and the program can do no harm there.
  const TempFolder folder;
  folder.write("plan.kml", read_text(repository() / "plans" / "first_drive.kml"));
  const Outcome outcome = run(arguments, {.folder = folder.path()});
  EXPECT_EQ(outcome.exit_code, std::stoi(exit[0])) << outcome.err;
  for (const std::string& text : expected) EXPECT_THAT(outcome.err + outcome.out, HasSubstr(text));
  for (const std::string& text : values(lines, "never: ")) {
    EXPECT_THAT(outcome.err + outcome.out, Not(HasSubstr(text)));
  }
}

INSTANTIATE_TEST_SUITE_P(Messages, OptionsMessage,
                         ::testing::ValuesIn(names(messages / "options", ".txt")), test_name);

class ImportMessage : public ::testing::TestWithParam<std::string> {};

// The file is imported together with a mission, a rover and two places. A plan is made of it where
// all that is expected are warnings and notes; the line "# note: TEXT" expects a note of the file.
TEST_P(ImportMessage, is_as_expected) {
  const fs::path file = messages / "import" / GetParam();
  const std::vector<std::string> lines = read_lines(file);
  Words expected = values(lines, "# expect: ");
  for (const std::string& note : values(lines, "# note: ")) {
    expected.push_back("note: " + (messages / "import").string() + "/" + note);
  }
  ASSERT_FALSE(expected.empty()) << "the first lines must be '# expect: TEXT' or '# note: TEXT'";
  const bool is_alone = !values(lines, "# alone").empty();
  const bool is_sound = std::ranges::all_of(expected, [](const std::string& text) {
    return text.find("warning: ") != std::string::npos || text.starts_with("left out: ") ||
           text.starts_with("note: ");
  });
  const TempFolder folder;
  const std::string plan = (folder / "plan.kml").string();
  Words arguments{"import", file.string()};
  if (!is_alone) arguments.push_back((messages / "import" / "with" / "mission.csv").string());
  arguments.insert(arguments.end(), {"-o", plan});
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.exit_code, is_sound ? 0 : 2) << outcome.err;
  EXPECT_EQ(fs::exists(plan), is_sound);
  for (const std::string& text : expected) EXPECT_THAT(outcome.err + outcome.out, HasSubstr(text));
  // No other fault is reported, such as one that only follows from another.
  std::istringstream output(outcome.err);
  for (std::string line; std::getline(output, line) && !is_sound;) {
    if (!line.starts_with(file.string())) continue;
    EXPECT_TRUE(std::ranges::any_of(expected, [&](const std::string& text) {
      return line.find(text) != std::string::npos;
    })) << line;
  }
}

std::vector<std::string> imported() {
  std::vector<std::string> all = names(messages / "import", ".csv");
  for (const std::string& name : names(messages / "import", ".txt")) all.push_back(name);
  return all;
}

INSTANTIATE_TEST_SUITE_P(Messages, ImportMessage, ::testing::ValuesIn(imported()), test_name);

TEST(Messages, stand_in_the_folders_that_are_walked) {
  EXPECT_GT(names(messages / "plan", ".kml").size(), 10u);
  EXPECT_GT(names(messages / "options", ".txt").size(), 10u);
}

}  // namespace
}  // namespace lsos::test
