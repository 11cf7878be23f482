// Who may include whom: our folders by layer, and each third-party library in its folders alone.

#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>

#include "system/source_files.h"

namespace lsos::test {
namespace {

// A folder includes itself and folders on lower layers, never a neighbour.
const std::map<std::string, int> layers = {
    {"base", 0},    {"planet", 1}, {"terrain", 2}, {"vehicle", 3}, {"view", 3},
    {"power", 3},   {"route", 3},  {"plan", 3},    {"record", 3},  {"mission", 4},
    {"product", 4}, {"import", 4}, {"lua", 5},
};

struct Library {
  std::regex header;
  std::set<std::string> folders;
};

// Eigen and fmt are everywhere.
const std::vector<Library>& libraries() {
  static const std::vector<Library> table = {
      {std::regex("(lua|lauxlib|lualib)\\.h(pp)?"), {"lua"}},
      {std::regex("(Bullet|LinearMath|bt)[^.]*\\.h"), {"vehicle"}},
      {std::regex("(gdal|ogr|cpl_)[^/]*\\.h"), {"terrain", "record", "plan"}},
      {std::regex("proj\\.h"), {"terrain", "record", "import"}},
      {std::regex("erfa[a-z]*\\.h"), {"planet"}},
      {std::regex("tinyxml2\\.h"), {"plan"}},
      {std::regex("zip(conf)?\\.h"), {"plan"}},
      {std::regex("(EGL|GL|GLES[23]|epoxy)/.*"), {"view"}},
      {std::regex("png.h"), {"product"}},
      {std::regex("png\\.h"), {"view"}},
      {std::regex("ft2build\\.h"), {"product"}},  // letters: captions of pictures
      {std::regex("jpeglib\\.h"), {"product"}},
      {std::regex("cairo/cairo\\.h"), {"product"}},  // figures for papers
      {std::regex("ompl/.*"), {"route"}},
      {std::regex("CLI/.*"), {"lua"}},
      {std::regex("(editline/.*|histedit\\.h)"), {"lua"}},
      {std::regex("gnu/libc-version\\.h"), {"route"}},  // which one is loaded
      {std::regex("nlohmann/.*"), {"product", "lua"}},
      {std::regex("openssl/.*"), {"base"}},
      {std::regex("(Eigen|fmt)/.*"),
       {"base", "planet", "terrain", "vehicle", "view", "power", "route", "plan", "record",
        "mission", "product", "import", "lua"}},
  };
  return table;
}

struct Include {
  std::filesystem::path file;
  std::size_t line = 0;
  std::string folder;  // of the file that includes
  std::string header;
  bool is_ours = false;  // in quotes

  std::string place() const { return file.string() + ":" + std::to_string(line) + ": "; }
};

std::vector<Include> all_includes() {
  static const std::regex pattern(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
  std::vector<Include> includes;
  for (const SourceFile& file : source_files({".h", ".cpp"})) {
    auto part = file.path.begin();
    std::string folder = part->string();
    if (folder == "core") folder = (++part)->string();
    if (!layers.contains(folder)) continue;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      std::smatch match;
      if (!std::regex_search(file.lines[i], match, pattern)) continue;
      includes.push_back({file.path, i + 1, folder, match[2], match[1] == "\""});
    }
  }
  return includes;
}

TEST(Layers, every_folder_of_core_is_in_the_table) {
  for (const auto& entry : std::filesystem::directory_iterator(repository() / "core")) {
    if (!entry.is_directory()) continue;
    EXPECT_TRUE(layers.contains(entry.path().filename().string())) << entry.path();
  }
}

TEST(Layers, folders_include_only_themselves_and_lower_layers) {
  int seen = 0;
  for (const Include& include : all_includes()) {
    if (!include.is_ours) continue;
    ++seen;
    const std::string target = include.header.substr(0, include.header.find('/'));
    if (!layers.contains(target)) {
      ADD_FAILURE() << include.place() << "'" << include.header
                    << "' is not FOLDER/NAME.h with a folder of core or lua";
      continue;
    }
    EXPECT_TRUE(target == include.folder || layers.at(target) < layers.at(include.folder))
        << include.place() << include.folder << " may not include " << include.header;
  }
  EXPECT_GT(seen, 20);
}

TEST(Layers, headers_in_quotes_exist) {
  for (const Include& include : all_includes()) {
    if (!include.is_ours) continue;
    const auto base = include.header.starts_with("lua/") ? repository() : repository() / "core";
    EXPECT_TRUE(std::filesystem::exists(base / include.header))
        << include.place() << include.header;
  }
}

TEST(Layers, third_party_headers_stay_in_their_folder) {
  // The C++ library has no extension; these few are the system's.
  const std::regex standard(
      R"([a-z_0-9]+|(unistd|fcntl|iconv|poll|signal|locale|termios|errno|time|xlocale)\.h|sys/.*\.h)");
  int seen = 0;
  for (const Include& include : all_includes()) {
    if (include.is_ours || std::regex_match(include.header, standard)) continue;
    bool is_known = false;
    for (const Library& library : libraries()) {
      if (!std::regex_match(include.header, library.header)) continue;
      is_known = true;
      ++seen;
      EXPECT_TRUE(library.folders.contains(include.folder))
          << include.place() << include.folder << " may not include <" << include.header << ">";
      break;
    }
    EXPECT_TRUE(is_known) << include.place() << "<" << include.header
                          << "> belongs to no library in the table of this test";
  }
  EXPECT_GT(seen, 10);
}

}  // namespace
}  // namespace lsos::test
