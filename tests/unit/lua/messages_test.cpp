// Each file of tests/messages/script is a script with a mistake; tests/README.md gives its format.
#include <algorithm>
#include <sstream>

#include "script_fixture.h"

namespace lsos {
namespace {

namespace fs = std::filesystem;

const fs::path cases_folder = fs::path(LSOS_SOURCE_DIR) / "tests/messages/script";
const fs::path parts_folder = cases_folder / "parts";

std::vector<std::string> script_names(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".lua") names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

std::string text_of_file(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
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

// The errors of reading this text as the file FOLDER/NAME.lua.
std::string errors_of_script(const std::string& folder, const std::string& name,
                             const std::string& text) {
  ScriptDirectory directory;
  directory.write(folder + "/" + name + ".lua", text);
  const Catalog catalog(std::vector<ScriptFolder>{{directory.path(), ""}, {LSOS_SOURCE_DIR, ""}});
  return errors_of(catalog, kind_of(folder), name);
}

class Message : public ::testing::TestWithParam<std::string> {};

TEST_P(Message, is_as_expected) {
  const std::string text = text_of_file(cases_folder / (GetParam() + ".lua"));
  std::istringstream in(text);
  const std::string expected = value_of(in, "-- expect: ");
  const std::string folder = value_of(in, "-- as: ");
  const std::string part = value_of(in, "-- after: ");
  ASSERT_FALSE(expected.empty() || folder.empty()) << "the first two lines are wrong";
  ASSERT_TRUE(part.empty() || fs::exists(parts_folder / part)) << "no part " << part;

  const std::string before = part.empty() ? "" : text_of_file(parts_folder / part);
  const std::string errors = errors_of_script(folder, GetParam(), before + text);
  EXPECT_THAT(errors, ::testing::HasSubstr(expected));
  EXPECT_THAT(errors, ::testing::StartsWith(folder + "/" + GetParam() + ".lua"));
}

INSTANTIATE_TEST_SUITE_P(Script, Message, ::testing::ValuesIn(script_names(cases_folder)),
                         [](const auto& test) { return test.param; });

// A part must be free of faults, so that a case that includes it fails for its own mistake only.
class MessagePart : public ::testing::TestWithParam<std::string> {};

TEST_P(MessagePart, is_right_by_itself) {
  const std::string text = text_of_file(parts_folder / (GetParam() + ".lua"));
  EXPECT_EQ(errors_of_script("rovers", GetParam(), text + "return lsos.rover(whole())\n"), "");
}

INSTANTIATE_TEST_SUITE_P(Script, MessagePart, ::testing::ValuesIn(script_names(parts_folder)),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace lsos
