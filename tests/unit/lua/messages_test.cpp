// Each file of tests/messages/script is a script with a mistake. Its first line is the message that
// must come ("-- expect: TEXT", a part of it), its second where it belongs ("-- as: rovers").
#include <algorithm>

#include "script_fixture.h"

namespace lsos {
namespace {

namespace fs = std::filesystem;

const fs::path cases_folder = fs::path(LSOS_SOURCE_DIR) / "tests/messages/script";

std::vector<std::string> case_names() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(cases_folder)) {
    if (entry.path().extension() == ".lua") names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

std::string value_of(std::istream& in, const std::string& mark) {
  std::string line;
  std::getline(in, line);
  return line.starts_with(mark) ? line.substr(mark.size()) : "";
}

ScriptKind kind_of(const std::string& folder) {
  if (folder == "events") return ScriptKind::event;
  if (folder == "rovers") return ScriptKind::rover;
  return folder == "terrain" ? ScriptKind::terrain : ScriptKind::soil;
}

class Message : public ::testing::TestWithParam<std::string> {};

TEST_P(Message, is_as_expected) {
  const fs::path file = cases_folder / (GetParam() + ".lua");
  std::ifstream in(file);
  const std::string expected = value_of(in, "-- expect: ");
  const std::string folder = value_of(in, "-- as: ");
  ASSERT_FALSE(expected.empty() || folder.empty()) << "the first two lines are wrong";

  ScriptDirectory directory;
  fs::create_directories(fs::path(directory.path()) / folder);
  fs::copy_file(file, fs::path(directory.path()) / folder / file.filename());
  const Catalog catalog(std::vector<ScriptFolder>{{directory.path(), ""}, {LSOS_SOURCE_DIR, ""}});
  const std::string errors = errors_of(catalog, kind_of(folder), GetParam());
  EXPECT_THAT(errors, ::testing::HasSubstr(expected));
  EXPECT_THAT(errors, ::testing::StartsWith(folder + "/" + GetParam() + ".lua"));
}

INSTANTIATE_TEST_SUITE_P(Script, Message, ::testing::ValuesIn(case_names()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace lsos
