// Every file of tests/messages/plan is a wrong plan with the expected messages in its first lines.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

#include "plan_fixture.h"

namespace lsos {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> bad_plans() {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(LSOS_SOURCE_DIR "/tests/messages/plan")) {
    files.push_back(entry.path().stem().string());
  }
  std::ranges::sort(files);
  return files;
}

std::vector<std::string> expectations(const std::string& file) {
  constexpr std::string_view before = "<!-- expect: ";
  constexpr std::string_view after = " -->";
  std::vector<std::string> texts;
  std::ifstream stream(file);
  for (std::string text; std::getline(stream, text) && text.starts_with(before);) {
    texts.push_back(text.substr(before.size(), text.rfind(after) - before.size()));
  }
  return texts;
}

class BadPlan : public ::testing::TestWithParam<std::string> {};

TEST_P(BadPlan, says_what_is_expected_and_nothing_else) {
  const std::string file = LSOS_SOURCE_DIR "/tests/messages/plan/" + GetParam() + ".kml";
  const std::vector<std::string> expected = expectations(file);
  ASSERT_FALSE(expected.empty());
  Faults faults;
  read_plan(file, test::declarations(), faults);
  const std::string text = test::faults_text(faults);
  for (const std::string& each : expected) EXPECT_THAT(text, ::testing::HasSubstr(each));
  EXPECT_EQ(faults.sorted().size(), expected.size()) << text;
}

INSTANTIATE_TEST_SUITE_P(Messages, BadPlan, ::testing::ValuesIn(bad_plans()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace lsos
