// Names of single files: no two files of a library give one name to two things, so that its files
// can be compiled as one (LSOS_UNITY). The code is read as clang-format writes it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <regex>

#include "system/source_files.h"

namespace lsos::test {
namespace {

struct LocalName {
  std::string name;
  std::size_t line = 0;
  std::string meaning;  // of an alias, which may stand in several files; else ""
};

// The names that a line at the left margin of an anonymous namespace declares.
std::vector<std::string> declared_names(const std::string& line) {
  static const std::regex type(R"(^(?:struct|class|union|enum class|enum) (\w+)[^;]*\{.*)"),
      call(R"(^(?:[^=({]*[ &*>])?([a-z_]\w*)\(.*)"),
      constant(R"(^[^=({]*[ &*>](\w+)(?:\[\w*\])*(?: =|\{|;).*)"), more(R"(, (\w+)(?: =|\{))"),
      value(R"([{,] (\w+))");
  std::smatch match;
  if (std::regex_match(line, match, type)) {
    std::vector<std::string> names{match[1]};
    if (!line.starts_with("enum ") || line.starts_with("enum class ")) return names;
    const std::string values = line.substr(line.find('{'));
    for (std::sregex_iterator next(values.begin(), values.end(), value), end; next != end; ++next) {
      names.push_back((*next)[1]);
    }
    return names;
  }
  if (line.starts_with("struct ") || line.starts_with("class ")) return {};  // declared ahead
  if (std::regex_match(line, match, call)) return {match[1]};
  if (!std::regex_match(line, match, constant)) return {};
  std::vector<std::string> names{match[1]};
  if (line.starts_with("const")) {
    for (std::sregex_iterator next(line.begin(), line.end(), more), end; next != end; ++next) {
      names.push_back((*next)[1]);
    }
  }
  return names;
}

std::vector<LocalName> local_names(const std::vector<std::string>& lines) {
  static const std::regex text("R\"(\\w*)\\("), macro(R"(^#define (\w+).*)"),
      alias(R"(^using (\w+) = (.*))"),
      other(R"(^(?:\}|//|#|template|namespace|using|friend|static_assert|extern|\)).*)");
  std::vector<LocalName> names;
  bool is_anonymous = false;
  std::string text_end;  // of a text of several lines
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& line = lines[i];
    std::smatch match;
    if (!text_end.empty()) {
      if (line.find(text_end) != std::string::npos) text_end.clear();
      continue;
    }
    if (line.find("R\"") != std::string::npos && std::regex_search(line, match, text)) {
      const std::string end = ")" + match[1].str() + "\"";
      if (match.suffix().str().find(end) == std::string::npos) text_end = end;
    }
    if (line.empty() || line.starts_with(' ')) continue;
    if (line == "namespace {") is_anonymous = true;
    if (line == "}  // namespace") is_anonymous = false;
    if (std::regex_match(line, match, macro)) {
      names.push_back({match[1], i + 1, ""});
    } else if (std::regex_match(line, match, alias)) {
      names.push_back({match[1], i + 1, match[2]});
    } else if (is_anonymous && !std::regex_match(line, other)) {
      for (const std::string& name : declared_names(line)) names.push_back({name, i + 1, ""});
    }
  }
  return names;
}

// The library or program that a file is compiled into; "" where each of its files is compiled
// alone.
std::string library_of(const std::filesystem::path& file) {
  std::vector<std::string> parts(file.begin(), file.end());
  if (parts.size() < 3) return "";
  if (parts[0] == "core") return parts[0] + "/" + parts[1];
  if (parts[0] == "lua") return parts[1] == "app" || parts[1] == "study" ? "lua/app" : "lua";
  if (parts[1] == "unit") return parts[1] + "/" + parts[2];
  if (parts[1] == "physics") return parts[1];
  return "";
}

// "core/plan/a.cpp:12: text_of is also that of core/plan/b.cpp:34", for each name that stands in
// several files of a library.
std::vector<std::string> clashes(const std::vector<SourceFile>& files) {
  struct Use {
    std::filesystem::path file;
    LocalName of;
  };
  std::map<std::pair<std::string, std::string>, Use> first;  // key: library, name
  std::vector<std::string> found;
  for (const SourceFile& file : files) {
    const std::string library = library_of(file.path);
    if (library.empty()) continue;
    for (const LocalName& name : local_names(file.lines)) {
      const Use& other =
          first.try_emplace({library, name.name}, Use{file.path, name}).first->second;
      const bool is_same_alias = !name.meaning.empty() && name.meaning == other.of.meaning;
      if (other.file == file.path || is_same_alias) continue;
      found.push_back(file.path.string() + ":" + std::to_string(name.line) + ": " + name.name +
                      " is also that of " + other.file.string() + ":" +
                      std::to_string(other.of.line));
    }
  }
  return found;
}

TEST(LocalNames, stand_in_one_file_of_a_library) {
  const std::vector<SourceFile> files = source_files({".cpp"});
  std::size_t files_of_libraries = 0;
  for (const SourceFile& file : files) files_of_libraries += library_of(file.path).empty() ? 0 : 1;
  EXPECT_GT(files_of_libraries, 500u);
  for (const std::string& clash : clashes(files)) {
    ADD_FAILURE() << clash << ": give it a name of its own, or both one place";
  }
}

TEST(LocalNames, are_those_of_functions_types_constants_aliases_and_macros) {
  const auto names = [](const std::string& line) {
    std::string all;
    for (const LocalName& name : local_names({"namespace {", line, "}  // namespace"})) {
      all += (all.empty() ? "" : " ") + name.name;
    }
    return all;
  };
  EXPECT_EQ(names("std::string text_of(const Fault& fault, double value = 0) {"), "text_of");
  EXPECT_EQ(names("std::pair<int, int> ends(const std::vector<int>& all);"), "ends");
  EXPECT_EQ(names("const Body& body() { return *find_body(\"Moon\"); }"), "body");
  EXPECT_EQ(names("split_at("), "split_at");
  EXPECT_EQ(names("struct Read {"), "Read");
  EXPECT_EQ(names("enum class Kind { a, b };"), "Kind");
  EXPECT_EQ(names("enum Side : int { left, right };"), "Side left right");
  EXPECT_EQ(names("class Search final : public Base {"), "Search");
  EXPECT_EQ(names("constexpr double least_m = 0.5, most_m = f(2, 3);"), "least_m most_m");
  EXPECT_EQ(names("constexpr std::array<double, 2> ends{1, 2};"), "ends");
  EXPECT_EQ(names("const Geodetic start{0.1, 0.2, 0};"), "start");
  EXPECT_EQ(names("const SiteFrame site(moon(), {});"), "site");
  EXPECT_EQ(names("const char* const names[] = {\"a\", \"b\"};"), "names");
  EXPECT_EQ(names("char key;"), "key");
  EXPECT_EQ(names("using Json = nlohmann::json;"), "Json");
  EXPECT_EQ(names("#define CHECKED(x) x"), "CHECKED");
  for (const char* line : {"", "  double inner = 0;", "template <class T>", "// text_of(fault) = 1",
                           "struct Ahead;", "void Search::go(int from) {", "using ::testing::Eq;",
                           "TEST(Names, of_tests) {", "};", "namespace fs = std::filesystem;"}) {
    EXPECT_EQ(names(line), "") << line;
  }
  EXPECT_THAT(local_names({"int f() {", "}"}), testing::IsEmpty());
  const std::vector<LocalName> behind = local_names(
      {"namespace {", "constexpr const char* text = R\"(", "int f() {", ")\";", "int g() {"});
  ASSERT_THAT(behind, testing::SizeIs(2));
  EXPECT_EQ(behind[1].name, "g");
}

TEST(LocalNames, that_stand_twice_are_told_with_file_and_line) {
  const std::vector<std::string> function = {"namespace {", "", "int count(int of) {"},
                                 constant = {"namespace {", "constexpr int count = 1;"},
                                 json = {"using Json = nlohmann::json;"},
                                 ordered = {"using Json = nlohmann::ordered_json;"};
  EXPECT_THAT(clashes({{"core/plan/a.cpp", function}, {"core/plan/b.cpp", constant}}),
              testing::ElementsAre("core/plan/b.cpp:2: count is also that of core/plan/a.cpp:3"));
  EXPECT_THAT(clashes({{"lua/app/a.cpp", function}, {"lua/study/b.cpp", function}}),
              testing::SizeIs(1));
  EXPECT_THAT(clashes({{"core/plan/a.cpp", json}, {"core/plan/b.cpp", ordered}}),
              testing::SizeIs(1));
  EXPECT_THAT(clashes({{"core/plan/a.cpp", json}, {"core/plan/b.cpp", json}}), testing::IsEmpty());
  EXPECT_THAT(clashes({{"core/plan/a.cpp", function}, {"core/edit/b.cpp", function}}),
              testing::IsEmpty());
  EXPECT_THAT(clashes({{"lua/app/a.cpp", function}, {"lua/api/b.cpp", function}}),
              testing::IsEmpty());
}

}  // namespace
}  // namespace lsos::test
