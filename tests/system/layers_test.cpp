// Allowed includes: our own folders by layer, and each third-party library in its folders only.

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "system/source_files.h"

namespace lsos::test {
namespace {

// A folder includes itself and folders on lower layers, never a neighbour.
const std::map<std::string, int> layers = {
    {"base", 0},    {"access", 1}, {"planet", 1},      {"driving", 1}, {"terrain", 2},
    {"vehicle", 3}, {"view", 3},   {"power", 3},       {"route", 3},   {"plan", 3},
    {"record", 3},  {"edit", 4},   {"interchange", 4}, {"mission", 4}, {"picture", 5},
    {"study", 5},   {"product", 6}, {"lua", 7},
};

// The same of the rooms within a folder, "" being the folder's own files.
const std::map<std::string, std::map<std::string, int>> rooms = {
    {"terrain", {{"spec", 0}, {"grid", 1}, {"detail", 2}, {"raster", 2}, {"", 3}}},
    {"route", {{"map", 0}, {"cost", 1}, {"search", 2}, {"refine", 3}, {"", 4}}},
    {"view", {{"gl", 0}, {"ground", 1}, {"exposure", 2}, {"picture", 2}}},
    {"vehicle", {{"", 0}, {"suspension", 1}}},
    {"mission",
     {{"port", 0},
      {"model", 1},
      {"routes", 2},
      {"rover", 3},
      {"events", 4},
      {"light", 4},
      {"ahead", 5},
      {"fleet", 6},
      {"estimate", 7},
      {"", 8}}},
    {"product", {{"", 0}, {"comparison", 1}, {"study", 1}}},
    {"lua",
     {{"runtime", 0},
      {"api", 1},
      {"host", 2},
      {"session", 3},
      {"edit", 3},
      {"check", 3},
      {"app", 4},
      {"study", 5}}},
};

constexpr std::size_t units_max = 40;  // a header and its source, in one folder

struct Library {
  std::regex header;
  std::set<std::string> folders;
};

// The folders that may include each library. Eigen and fmt are allowed everywhere.
const std::vector<Library>& libraries() {
  static const std::vector<Library> table = {
      {std::regex("(lua|lauxlib|lualib)\\.h(pp)?"), {"lua"}},
      {std::regex("(Bullet|LinearMath|bt)[^.]*\\.h"), {"vehicle"}},
      {std::regex("(gdal|ogr|cpl_)[^/]*\\.h"),
       {"access", "terrain", "record", "plan", "interchange"}},
      {std::regex("erfa[a-z]*\\.h"), {"planet"}},
      {std::regex("tinyxml2\\.h"), {"plan", "interchange"}},
      {std::regex("libxml/.*"), {"edit"}},  // changes in place
      {std::regex("zip(conf)?\\.h"), {"plan", "interchange"}},
      {std::regex("epoxy/.*"), {"view"}},
      {std::regex("png\\.h"), {"picture"}},
      {std::regex("ft2build\\.h"), {"picture"}},  // letters: captions of pictures
      {std::regex("jpeglib\\.h"), {"picture"}},
      {std::regex("cairo/cairo\\.h"), {"product"}},  // figures for papers
      {std::regex("ompl/.*"), {"route"}},
      {std::regex("boost/.*"), {"study"}},  // Sobol's sequence, quantiles
      {std::regex("CLI/.*"), {"lua"}},
      {std::regex("(editline/.*|histedit\\.h)"), {"lua"}},
      {std::regex("gnu/libc-version\\.h"), {"route"}},  // version of the C library
      {std::regex("nlohmann/.*"), {"interchange", "picture", "product", "lua"}},
      {std::regex("openssl/.*"), {"base"}},
  };
  return table;
}

// A folder of core or lua, and a room in it, "" for the folder's own files.
struct Room {
  std::string folder, room;

  bool operator==(const Room&) const = default;
};

// `file`: relative to core, or "lua/...".
Room room_of(const std::filesystem::path& file) {
  auto part = file.begin();
  Room room{part->string(), ""};
  if (std::distance(file.begin(), file.end()) > 2) room.room = (++part)->string();
  return room;
}

struct Include {
  std::filesystem::path file;
  std::size_t line = 0;
  std::string unit;  // of the file that includes: "terrain/grid/patch"
  std::string header;
  bool is_ours = false;  // included in quotes

  std::string place() const { return file.string() + ":" + std::to_string(line) + ": "; }
};

// Without its extension, relative to core.
std::string unit_of(const std::filesystem::path& file) {
  std::string unit = file.parent_path() / file.stem();
  if (unit.starts_with("core/")) unit = unit.substr(5);
  return unit;
}

// Calls `visit` with each file of the folders in the table.
template <class Visit>
void for_each_file(const Visit& visit) {
  for (const SourceFile& file : source_files({".h", ".cpp"})) {
    if (layers.contains(room_of(unit_of(file.path)).folder)) visit(file);
  }
}

std::vector<Include> all_includes() {
  static const std::regex pattern(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
  std::vector<Include> includes;
  for_each_file([&](const SourceFile& file) {
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      std::smatch match;
      if (!std::regex_search(file.lines[i], match, pattern)) continue;
      includes.push_back({file.path, i + 1, unit_of(file.path), match[2], match[1] == "\""});
    }
  });
  return includes;
}

bool may_include(const Room& from, const Room& to) {
  if (from == to) return true;
  if (from.folder != to.folder) return layers.at(to.folder) < layers.at(from.folder);
  const auto& within = rooms.at(from.folder);
  return within.at(to.room) < within.at(from.room);
}

// Units of which each reaches each other by includes: Tarjan's strongly connected components
// (1972), of more than one unit.
class Cycles {
 public:
  explicit Cycles(const std::map<std::string, std::set<std::string>>& graph) : graph_(graph) {
    for (const auto& [unit, includes] : graph) {
      if (!number_.contains(unit)) visit(unit);
    }
  }

  std::vector<std::set<std::string>> found;

 private:
  void visit(const std::string& unit) {
    const int number = static_cast<int>(number_.size());
    number_[unit] = lowest_[unit] = number;
    stack_.push_back(unit);
    is_on_stack_.insert(unit);
    if (const auto includes = graph_.find(unit); includes != graph_.end()) {
      for (const std::string& next : includes->second) {
        if (!number_.contains(next)) {
          visit(next);
          lowest_[unit] = std::min(lowest_[unit], lowest_[next]);
        } else if (is_on_stack_.contains(next)) {
          lowest_[unit] = std::min(lowest_[unit], number_[next]);
        }
      }
    }
    if (lowest_[unit] != number) return;
    std::set<std::string> component;
    do {
      component.insert(stack_.back());
      is_on_stack_.erase(stack_.back());
      stack_.pop_back();
    } while (!component.contains(unit));
    if (component.size() > 1) found.push_back(component);
  }

  const std::map<std::string, std::set<std::string>>& graph_;
  std::map<std::string, int> number_, lowest_;
  std::vector<std::string> stack_;
  std::set<std::string> is_on_stack_;
};

TEST(Layers, every_folder_of_core_and_room_is_in_the_tables) {
  for_each_file([](const SourceFile& file) {
    const Room room = room_of(file.path.string().starts_with("core/")
                                  ? std::filesystem::relative(file.path, "core")
                                  : file.path);
    const auto within = rooms.find(room.folder);
    const bool is_known =
        within == rooms.end() ? room.room.empty() : within->second.contains(room.room);
    EXPECT_TRUE(is_known) << file.path;
  });
  for (const auto& entry : std::filesystem::directory_iterator(repository() / "core")) {
    if (!entry.is_directory()) continue;
    EXPECT_TRUE(layers.contains(entry.path().filename().string())) << entry.path();
  }
}

TEST(Layers, includes_never_point_up_or_aside) {
  int seen = 0;
  for (const Include& include : all_includes()) {
    if (!include.is_ours) continue;
    ++seen;
    const Room target = room_of(include.header);
    if (!layers.contains(target.folder)) {
      ADD_FAILURE() << include.place() << "'" << include.header
                    << "' is not FOLDER/NAME.h with a folder of core or lua";
      continue;
    }
    EXPECT_TRUE(may_include(room_of(include.unit + ".h"), target))
        << include.place() << include.unit << " may not include " << include.header;
  }
  EXPECT_GT(seen, 20);
}

TEST(Layers, units_include_each_other_in_no_circle) {
  std::map<std::string, std::set<std::string>> graph;
  for (const Include& include : all_includes()) {
    const std::string target = unit_of(include.header);
    if (include.is_ours && target != include.unit) graph[include.unit].insert(target);
  }
  std::size_t in_runtime = 0;
  for (const std::set<std::string>& cycle : Cycles(graph).found) {
    // A vec3 is described in messages, and messages describe what is no vec3.
    const bool is_of_runtime =
        cycle.size() <= 3 && cycle.begin()->starts_with("lua/runtime/") && ++in_runtime <= 2;
    EXPECT_TRUE(is_of_runtime) << testing::PrintToString(cycle);
  }
}

TEST(Layers, no_folder_has_too_many_units) {
  std::map<std::string, std::set<std::string>> units;
  for_each_file(
      [&](const SourceFile& file) { units[file.path.parent_path()].insert(file.path.stem()); });
  EXPECT_GT(units.size(), 20u);
  for (const auto& [folder, names] : units) EXPECT_LE(names.size(), units_max) << folder;
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
  // Headers of the C++ library have no extension; the others belong to the system.
  const std::regex standard(
      R"([a-z_0-9]+|(Eigen|fmt)/.*|(unistd|fcntl|iconv|poll|signal|locale|termios|errno|time|xlocale|link)\.h|sys/.*\.h)");
  int seen = 0;
  for (const Include& include : all_includes()) {
    if (include.is_ours || std::regex_match(include.header, standard)) continue;
    bool is_known = false;
    for (const Library& library : libraries()) {
      if (!std::regex_match(include.header, library.header)) continue;
      is_known = true;
      ++seen;
      EXPECT_TRUE(library.folders.contains(room_of(include.unit + ".h").folder))
          << include.place() << include.unit << " may not include <" << include.header << ">";
      break;
    }
    EXPECT_TRUE(is_known) << include.place() << "<" << include.header
                          << "> belongs to no library in the table of this test";
  }
  EXPECT_GT(seen, 10);
}

}  // namespace
}  // namespace lsos::test
