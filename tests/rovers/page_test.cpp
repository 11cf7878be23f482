#include "rovers/page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace lsos::rovers {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::string written() {
  std::ifstream file(fs::path(LSOS_SOURCE_DIR) / "rovers/MEASURED.md", std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

bool is_rover(const fs::path& script) {
  std::ifstream file(script);
  std::stringstream text;
  text << file.rdbuf();
  return text.str().find("return lsos.rover") != std::string::npos;
}

TEST(RoversPage, has_each_shipped_rover_and_its_picture) {
  std::vector<std::string> shipped, shown;
  for (const auto& entry : fs::directory_iterator(fs::path(LSOS_SOURCE_DIR) / "rovers")) {
    if (entry.path().extension() != ".lua" || !is_rover(entry.path())) continue;
    shipped.push_back(entry.path().stem().string());
  }
  for (const Subject& subject : subjects) {
    shown.emplace_back(subject.rover);
    EXPECT_TRUE(fs::exists(fs::path(LSOS_SOURCE_DIR) / picture_path(subject)))
        << picture_path(subject) << ": run write_rovers";
    EXPECT_THAT(written(), HasSubstr("\n| " + std::string(subject.rover) + " | "));
  }
  EXPECT_THAT(shown, ::testing::UnorderedElementsAreArray(shipped));
}

// Takes minutes.
TEST(RoversPageMeasured, is_what_the_rovers_do) {
  std::vector<Figures> figures;
  for (const Subject& subject : subjects) figures.push_back(measure(subject));
  const std::string text = written();
  EXPECT_TRUE(text.substr(0, text.find(speed_heading)) == page(figures))
      << "rovers/MEASURED.md is out of date: run write_rovers";
}

}  // namespace
}  // namespace lsos::rovers
