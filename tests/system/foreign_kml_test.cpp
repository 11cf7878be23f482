// `check` with other people's maps: whatever file it is given, it ends and says why that is not a
// plan.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tinyxml2.h>
#include <zip.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <thread>

#include "support/reference_data.h"
#include "system/process.h"
#include "system/temp_folder.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;

// Time limit of a check. The files are small; the margin is for a busy machine.
constexpr std::chrono::seconds limit{10};

std::vector<fs::path> foreign_files() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(reference_file("kml"))) {
    const std::string extension = entry.path().extension();
    if (!entry.is_regular_file()) continue;
    if (extension == ".kml" || extension == ".kmz" || extension == ".xml") {
      files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  return files;
}

// Outcome of `check`; nothing when it does not end within `longest`.
std::optional<Outcome> check(const fs::path& file, std::chrono::seconds longest = limit) {
  const auto start = std::chrono::steady_clock::now();
  Process process(program({"check", file}));
  while (process.is_running()) {
    if (std::chrono::steady_clock::now() - start > longest) return {};
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return process.wait();
}

fs::path packed(const fs::path& kml, const TempFolder& folder) {
  const fs::path file = folder / (kml.stem().string() + ".kmz");
  fs::remove(file);
  int error = 0;
  zip_t* archive = zip_open(file.c_str(), ZIP_CREATE, &error);
  if (archive == nullptr) throw std::runtime_error("cannot write " + file.string());
  zip_source_t* source = zip_source_file(archive, kml.c_str(), 0, -1);
  if (zip_file_add(archive, "doc.kml", source, 0) < 0 || zip_close(archive) != 0) {
    throw std::runtime_error("cannot write " + file.string());
  }
  return file;
}

// Kind of a file, as tinyxml2 reads it directly.
enum class Kind { malformed, other_xml, kml };

Kind kind_of(const fs::path& file) {
  tinyxml2::XMLDocument document;
  if (document.LoadFile(file.c_str()) != tinyxml2::XML_SUCCESS) return Kind::malformed;
  const std::string name = document.RootElement()->Name();
  const std::set<std::string> roots{"kml", "Document", "Folder", "Placemark"};
  return roots.contains(name.substr(name.rfind(':') + 1)) ? Kind::kml : Kind::other_xml;
}

// Expects the right refusal of a file; `seen` is its name in messages.
void expect_answer(const std::optional<Outcome>& outcome, const std::string& seen, Kind kind) {
  ASSERT_TRUE(outcome) << "no answer within " << limit.count() << " s";
  EXPECT_FALSE(outcome->was_killed) << "by signal " << outcome->exit_code - 128;
  // None of them has a MissionInfo.
  EXPECT_EQ(outcome->exit_code, 2) << outcome->out << outcome->err;
  const std::string text = outcome->out + outcome->err;
  EXPECT_EQ(std::ranges::count(text, '\n'), 1) << text;
  switch (kind) {
    case Kind::malformed:
      EXPECT_TRUE(text.starts_with(seen + ":")) << text;
      EXPECT_THAT(text.substr(seen.size()), ContainsRegex("^:[0-9]+: is no XML: "));
      break;
    case Kind::other_xml:
      EXPECT_TRUE(text.starts_with(seen + ":")) << text;
      EXPECT_THAT(text.substr(seen.size()),
                  ContainsRegex("^:[0-9]+: is no KML: its outermost element is <"));
      break;
    case Kind::kml:
      EXPECT_TRUE(text.starts_with(seen + ": is KML but no plan: ")) << text;
      EXPECT_THAT(text, HasSubstr("schemaUrl=\"#MissionInfo\""));
      break;
  }
}

TEST(ForeignKml, is_answered_by_what_it_is) {
  LSOS_NEEDS_REFERENCE("kml");
  std::map<Kind, int> seen;
  for (const fs::path& file : foreign_files()) {
    SCOPED_TRACE(file);
    const bool is_kmz = file.extension() == ".kmz";
    const Kind kind = is_kmz ? Kind::kml : kind_of(file);
    ++seen[kind];
    expect_answer(check(file), is_kmz ? file.string() + "/doc.kml" : file.string(), kind);
  }
  EXPECT_GE(seen[Kind::kml], 50);
  EXPECT_GE(seen[Kind::other_xml], 15);
  EXPECT_GE(seen[Kind::malformed], 3);
}

TEST(ForeignKml, is_answered_by_what_it_is_in_a_kmz) {
  LSOS_NEEDS_REFERENCE("kml");
  const TempFolder folder;
  int count = 0;
  for (const fs::path& file : foreign_files()) {
    if (file.extension() != ".kml") continue;
    SCOPED_TRACE(file);
    const fs::path kmz = packed(file, folder);
    expect_answer(check(kmz), kmz.string() + "/doc.kml", kind_of(file));
    ++count;
  }
  EXPECT_GE(count, 40);
}

TEST(ForeignKml, of_fifty_megabytes_is_answered) {
  const TempFolder folder;
  std::string text = "<kml><Document>\n";
  const std::string placemark =
      "<Placemark><name>p</name><Point><coordinates>1,2,3</coordinates></Point></Placemark>\n";
  while (text.size() < (50u << 20)) text += placemark;
  const std::string file = folder.write("big.kml", text + "</Document></kml>\n");
  expect_answer(check(file, std::chrono::minutes(1)), file, Kind::kml);
}

TEST(ForeignKml, with_thousands_of_attributes_is_refused_at_once) {
  const TempFolder folder;
  std::string text = "<kml>\n<Document";
  for (int i = 0; i < 200000; ++i) text += " a" + std::to_string(i) + "=''";
  const std::string file = folder.write("wide.kml", text + "/></kml>\n");
  const std::optional<Outcome> outcome = check(file);
  ASSERT_TRUE(outcome) << "no answer within " << limit.count() << " s";
  EXPECT_EQ(outcome->exit_code, 2);
  EXPECT_THAT(outcome->out, HasSubstr(file + ":2: has a tag with 200000 attributes; 1000 at most"));
}

// Each entity expands to ten of the one before, to a gigabyte in all.
TEST(ForeignKml, with_entities_of_its_own_is_refused) {
  const TempFolder folder;
  std::string text = "<?xml version=\"1.0\"?>\n<!DOCTYPE kml [\n<!ENTITY e0 \"ha\">\n";
  for (int i = 1; i < 10; ++i) {
    text += "<!ENTITY e" + std::to_string(i) + " \"";
    for (int k = 0; k < 10; ++k) text += "&e" + std::to_string(i - 1) + ";";
    text += "\">\n";
  }
  text += "]>\n<kml><Placemark><name>&e9;</name></Placemark></kml>\n";
  const std::string file = folder.write("laughs.kml", text);
  const std::optional<Outcome> outcome = check(file);
  ASSERT_TRUE(outcome) << "no answer within " << limit.count() << " s";
  EXPECT_EQ(outcome->exit_code, 2);
  EXPECT_THAT(outcome->out, HasSubstr(file + ":2: declares entities or elements of its own in "
                                             "<!DOCTYPE ... [ ... ]>; they are not read"));
}

TEST(ForeignKml, that_links_to_itself_is_not_followed) {
  const TempFolder folder;
  const std::string file = folder.write(
      "self.kml", "<kml><NetworkLink><Link><href>self.kml</href></Link></NetworkLink></kml>\n");
  expect_answer(check(file), file, Kind::kml);
}

}  // namespace
}  // namespace lsos::test
