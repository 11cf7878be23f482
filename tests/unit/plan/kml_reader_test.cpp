#include "plan/kml_reader.h"

#include <gmock/gmock.h>
#include <zip.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "plan/kml_text.h"
#include "plan/kmz_archive.h"
#include "plan_fixture.h"
#include "support/reference_data.h"

namespace lsos {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

// The message with which these bytes are refused; "" when they are read.
std::string refusal(const std::string& bytes) {
  try {
    parse_kml(bytes, "a.kml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string utf16(const std::string& ascii, bool is_big_endian) {
  std::string wide;
  for (const char c : ascii) wide += is_big_endian ? std::string{'\0', c} : std::string{c, '\0'};
  return wide;
}

// Writes a KMZ of these files (name, bytes) and returns its path.
std::string kmz(const std::vector<std::pair<std::string, std::string>>& files) {
  const std::string path = test::write_file("", "archive.kmz");
  fs::remove(path);
  int error = 0;
  zip_t* archive = zip_open(path.c_str(), ZIP_CREATE, &error);
  for (const auto& [name, bytes] : files) {
    zip_source_t* source = zip_source_buffer(archive, bytes.data(), bytes.size(), 0);
    zip_file_add(archive, name.c_str(), source, ZIP_FL_ENC_UTF_8);
  }
  zip_close(archive);
  return path;
}

const std::string small = test::document("<Placemark><name>here</name></Placemark>\n");

TEST(KmlReader, values_keep_their_lines) {
  const KmlSource source = parse_kml(
      "<kml>\n<Document>\n"
      "<Placemark>\n"
      " <name> leg\n 2 </name>\n"
      " <ExtendedData>\n"
      "  <SchemaData schemaUrl='#Route'>\n"
      "   <SimpleData name='Speed'>\n\n  <![CDATA[2]]> m/s\n</SimpleData>\n"
      "  </SchemaData>\n"
      " </ExtendedData>\n"
      " <LineString><coordinates>\n 1,2 3,4\n</coordinates></LineString>\n"
      "</Placemark>\n</Document>\n</kml>\n",
      "a.kml");
  ASSERT_EQ(source.placemarks.size(), 1u);
  const SourcePlacemark& placemark = source.placemarks[0];
  EXPECT_EQ(placemark.line, 3);
  EXPECT_EQ(placemark.name, "leg\n 2");
  ASSERT_EQ(placemark.data.size(), 1u);
  EXPECT_EQ(placemark.data[0].line, 7);
  EXPECT_EQ(placemark.data[0].schema, "Route");
  ASSERT_EQ(placemark.data[0].fields.size(), 1u);
  EXPECT_EQ(placemark.data[0].fields[0].text, "2 m/s");
  EXPECT_EQ(placemark.data[0].fields[0].line, 10);
  ASSERT_EQ(placemark.geometries.size(), 1u);
  EXPECT_EQ(placemark.geometries[0].coordinates, "1,2 3,4");
  EXPECT_EQ(placemark.geometries[0].line, 15);
}

TEST(KmlReader, line_ends_of_windows_count_once) {
  std::string text =
      "<kml>\n<Document>\n<Placemark>\n<name>a</name></Placemark></Document></kml>\n";
  const int line = parse_kml(text, "a.kml").placemarks.at(0).line;
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) {
    text.replace(at, 1, "\r\n");
  }
  EXPECT_EQ(parse_kml(text, "a.kml").placemarks.at(0).line, line);
}

TEST(KmlReader, schema_names_are_resolved) {
  const auto data = [](const std::string& url) {
    return "<Placemark><ExtendedData><SchemaData schemaUrl=\"" + url +
           "\"/></ExtendedData></Placemark>";
  };
  const KmlSource source =
      parse_kml(test::document(data("#S1") + data("other.kml#S1") + data("#Route") + data("#S2") +
                               data("http://x/#a#Rover") + data("Route") + data("#Wait.schema") +
                               "<Schema id='S1' name='Pause'/><Schema id='S2'/>"
                               "<Schema id='Wait.schema'/>"),
                "a.kml");
  std::vector<std::string> names;
  for (const SourcePlacemark& each : source.placemarks) names.push_back(each.data.at(0).schema);
  EXPECT_THAT(names, ::testing::ElementsAre("Pause", "S1", "Route", "S2", "Rover", "", "Wait"));
}

TEST(KmlReader, prefixes_and_nesting_do_not_matter) {
  const KmlSource source = parse_kml(
      "<k:kml xmlns:k='http://www.opengis.net/kml/2.2'><k:Folder><k:Document><k:Folder>"
      "<k:Placemark><k:name>deep</k:name><k:Point><k:coordinates>1,2</k:coordinates></k:Point>"
      "</k:Placemark></k:Folder></k:Document></k:Folder><k:Placemark/></k:kml>",
      "a.kml");
  ASSERT_EQ(source.placemarks.size(), 2u);
  EXPECT_EQ(source.placemarks[0].name, "deep");
  EXPECT_EQ(source.placemarks[0].geometries.at(0).coordinates, "1,2");
}

TEST(KmlReader, kinds_of_geometry_are_told) {
  const KmlSource source =
      parse_kml(test::document("<Placemark><Polygon/></Placemark><Placemark><gx:Track/></Placemark>"
                               "<Placemark><MultiGeometry><Point/><Point/></MultiGeometry>"
                               "</Placemark>"),
                "a.kml");
  std::vector<std::string> kinds;
  for (const auto& each : source.placemarks) kinds.push_back(each.geometries.at(0).kind);
  EXPECT_THAT(kinds, ::testing::ElementsAre("Polygon", "LineString", "MultiGeometry"));
}

// Map tools write a MultiGeometry around any feature that could have several parts.
TEST(KmlReader, a_multi_geometry_of_one_is_that_one) {
  const KmlSource source = parse_kml(
      test::document("<Placemark><MultiGeometry>\n<LineString><coordinates>1,2 3,4</coordinates>"
                     "</LineString></MultiGeometry></Placemark><Placemark><MultiGeometry>"
                     "<MultiGeometry><Point><coordinates>5,6</coordinates></Point></MultiGeometry>"
                     "</MultiGeometry></Placemark><Placemark><MultiGeometry/></Placemark>"),
      "a.kml");
  EXPECT_EQ(source.placemarks[0].geometries.at(0).kind, "LineString");
  EXPECT_EQ(source.placemarks[0].geometries.at(0).coordinates, "1,2 3,4");
  EXPECT_EQ(source.placemarks[1].geometries.at(0).kind, "Point");
  EXPECT_TRUE(source.placemarks[2].geometries.empty()) << "a Placemark without a place";
}

TEST(KmlReader, rings_and_tracks_are_lines) {
  const KmlSource source = parse_kml(
      test::document("<Placemark><LinearRing><coordinates>1,2 3,4 1,2</coordinates></LinearRing>"
                     "</Placemark><Placemark><gx:MultiTrack><gx:Track><when>2026-01-01</when>"
                     "<gx:coord>1 2  3</gx:coord><gx:coord/><gx:coord>4 5 6</gx:coord>"
                     "</gx:Track></gx:MultiTrack></Placemark>"),
      "a.kml");
  std::vector<std::string> seen;
  for (const auto& each : source.placemarks) {
    seen.push_back(each.geometries.at(0).kind + " " + each.geometries.at(0).coordinates);
  }
  EXPECT_THAT(seen, ::testing::ElementsAre("LineString 1,2 3,4 1,2", "LineString 1,2,3 4,5,6"));
}

TEST(KmlReader, holes_of_a_polygon_are_read_however_they_are_wrapped) {
  const auto ring = [](const std::string& text) {
    return "<LinearRing><coordinates>" + text + "</coordinates></LinearRing>";
  };
  const KmlSource source =
      parse_kml(test::document("<Placemark><Polygon><outerBoundaryIs>" + ring("1,1") +
                               "</outerBoundaryIs>" + "<innerBoundaryIs>" + ring("2,2") +
                               ring("3,3") + "</innerBoundaryIs>" + "<innerBoundaryIs>\n" +
                               ring("4,4") + "</innerBoundaryIs></Polygon></Placemark>"),
                "a.kml");
  const SourceGeometry& polygon = source.placemarks[0].geometries.at(0);
  EXPECT_EQ(polygon.coordinates, "1,1");
  std::vector<std::string> holes;
  for (const SourceGeometry::Ring& hole : polygon.holes) holes.push_back(hole.coordinates);
  EXPECT_THAT(holes, ::testing::ElementsAre("2,2", "3,3", "4,4"));
  EXPECT_EQ(polygon.holes[2].line, polygon.holes[0].line + 1);
}

TEST(KmlReader, encodings_are_converted) {
  const std::string text = small;
  const std::string name = "h\xe9re";  // in ISO-8859-1
  std::string latin = "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>" + text;
  latin.replace(latin.find("here"), 4, name);
  std::string windows = "<?xml version='1.0' encoding='windows-1252'?>" + text;
  windows.replace(windows.find("here"), 4, "\x80");  // euro sign in windows-1252
  const auto read_name = [](const std::string& bytes) {
    return parse_kml(bytes, "a.kml").placemarks.at(0).name;
  };
  EXPECT_EQ(read_name(latin), "h\xc3\xa9re");
  EXPECT_EQ(read_name(windows), "\xe2\x82\xac");
  EXPECT_EQ(read_name("\xef\xbb\xbf" + text), "here");
  EXPECT_EQ(read_name("\xff\xfe" + utf16(text, false)), "here");
  EXPECT_EQ(read_name("\xfe\xff" + utf16(text, true)), "here");
  const std::string declared = "<?xml version=\"1.0\" encoding=\"UTF-16\"?>" + text;
  EXPECT_EQ(read_name(utf16(declared, false)), "here");
  EXPECT_EQ(read_name(utf16(declared, true)), "here");
  EXPECT_EQ(read_name(declared), "here") << "plain bytes that claim to be UTF-16";
}

TEST(KmlReader, bytes_that_are_no_text_are_refused_with_their_line) {
  EXPECT_THAT(refusal("<kml>\n\n<name>\xe9</name></kml>"),
              HasSubstr("a.kml:3: holds bytes that are not UTF-8"));
  EXPECT_THAT(refusal(std::string("<kml>\n<a\0b/></kml>", 16)),
              HasSubstr("a.kml:2: holds a zero byte"));
  EXPECT_THAT(refusal("\xff\xfe" + utf16(small, false) + "x"), HasSubstr("not UTF-16LE"));
  EXPECT_THAT(refusal("<?xml version='1.0' encoding='klingon'?><kml/>"),
              HasSubstr("a.kml:1: declares the encoding 'klingon', which is not known"));
  EXPECT_THAT(refusal("<?xml version='1.0' encoding='UTF-8//IGNORE'?><kml/>"),
              HasSubstr("which is not known"));
  EXPECT_THAT(refusal(""), HasSubstr("is empty"));
}

TEST(KmlReader, a_kmz_is_read_from_doc_kml_or_its_first_kml) {
  const std::string other = test::document("<Placemark><name>other</name></Placemark>");
  const KmlSource main = read_kml(kmz({{"a.kml", other}, {"x.png", "?"}, {"doc.kml", small}}));
  EXPECT_EQ(main.placemarks.at(0).name, "here");
  EXPECT_TRUE(main.file.ends_with("archive.kmz/doc.kml")) << main.file;
  const KmlSource first = read_kml(kmz({{"x.png", "?"}, {"in/b.KML", other}, {"c.kml", small}}));
  EXPECT_EQ(first.placemarks.at(0).name, "other");
  // Files that macOS adds to archives are skipped.
  const KmlSource mac =
      read_kml(kmz({{"__MACOSX/._plan.kml", "?"}, {"in/._plan.kml", "?"}, {"plan.kml", small}}));
  EXPECT_EQ(mac.placemarks.at(0).name, "here");
}

TEST(KmlReader, a_kmz_may_hold_its_layers_as_linked_documents) {
  const auto link = [](const std::string& href) {
    return "<NetworkLink><name>" + href + "</name><Link><href>" + href + "</href></Link>" +
           "</NetworkLink>";
  };
  const auto named = [](const std::string& name) {
    return "<name>L</name><Placemark><name>" + name + "</name></Placemark>";
  };
  const KmlSource source = read_kml(
      kmz({{"doc.kml", test::document(link("layers/my%20a.kml") + link("b.kml#x") +
                                      link("../c.kml") + link("http://x/d.kml"))},
           {"layers/my a.kml", test::document(named("a") + link("../b.kml") + link("../doc.kml"))},
           {"b.kml", test::document(named("b"))}}));
  ASSERT_EQ(source.placemarks.size(), 2u) << "each is read once, and the first is not read again";
  EXPECT_EQ(source.placemarks[0].name, "a");
  EXPECT_TRUE(source.placemarks[0].file.ends_with("archive.kmz/layers/my a.kml"));
  EXPECT_THAT(source.placemarks[0].folders, ::testing::ElementsAre("layers/my%20a.kml", "L"));
  EXPECT_EQ(source.placemarks[1].name, "b");
  ASSERT_EQ(source.links.size(), 1u);
  EXPECT_EQ(source.links[0].href, "../c.kml");
}

TEST(KmlReader, a_kmz_without_a_document_or_cut_short_is_refused) {
  EXPECT_THAT(refusal(read_bytes(kmz({{"x.png", "?"}}))), HasSubstr("holds no .kml file"));
  const std::string whole = read_bytes(kmz({{"doc.kml", small}}));
  for (const double share : {0.1, 0.5, 0.9}) {
    const std::string cut = whole.substr(0, static_cast<std::size_t>(share * double(whole.size())));
    EXPECT_THAT(refusal(cut), HasSubstr("a.kml: cannot be unpacked: not a zip archive; it "
                                        "begins as a KMZ but is cut short or damaged"))
        << share;
  }
}

TEST(KmlReader, a_damaged_kmz_is_refused) {
  std::string bytes = read_bytes(kmz({{"doc.kml", small + std::string(4000, ' ')}}));
  for (std::size_t i = 45; i < 60; ++i) bytes[i] = static_cast<char>(~bytes[i]);
  EXPECT_THAT(refusal(bytes), HasSubstr("a.kml/doc.kml: cannot be unpacked: "));
}

TEST(KmlReader, a_kmz_that_unpacks_to_too_much_is_refused) {
  constexpr std::size_t limit = 4u << 20;
  const std::string bytes = read_bytes(kmz({{"doc.kml", std::string(limit + 1, ' ')}}));
  EXPECT_LT(bytes.size(), limit / 100);
  EXPECT_NO_THROW(KmzArchive(bytes, "a.kmz", limit + 1).unpacked("doc.kml"));
  try {
    KmzArchive(bytes, "a.kmz", limit).unpacked("doc.kml");
    FAIL() << "it was read";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "a.kmz/doc.kml: unpacks to more than 4 MiB");
  }
}

TEST(KmlReader, files_that_cannot_be_read_are_refused) {
  const auto why = [](const std::string& file) -> std::string {
    try {
      read_bytes(file);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(why(::testing::TempDir()), HasSubstr("is a folder; a KML or KMZ file is wanted"));
  EXPECT_THAT(why(::testing::TempDir() + "lsos_no_such.kml"),
              HasSubstr("cannot be opened: No such file or directory"));
  const std::string huge = test::write_file("", "huge.kml");
  fs::resize_file(huge, max_kml_bytes + 1);  // sparse
  EXPECT_THAT(why(huge), HasSubstr("is larger than 256 MiB"));
  fs::remove(huge);
}

TEST(KmlReader, every_reference_file_is_read_or_refused) {
  LSOS_NEEDS_REFERENCE("kml");
  const fs::path folder = reference_file("kml");
  int read = 0;
  int refused = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    try {
      read_kml(entry.path().string());
      ++read;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(entry.path().string()));
      ++refused;
    }
  }
  EXPECT_GT(read, 40);
  EXPECT_GT(refused, 5);
}

TEST(KmlReader, no_cut_or_flipped_byte_of_a_document_crashes) {
  const std::string whole = test::document(test::mission() + test::rover() +
                                           test::event("Route", "a", "A", 1, {}, test::line()));
  for (std::size_t i = 0; i < whole.size(); ++i) {
    refusal(whole.substr(0, i));
    std::string flipped = whole;
    flipped[i] = static_cast<char>(flipped[i] ^ 0x15);
    refusal(flipped);
  }
  EXPECT_EQ(refusal(whole), "");
}

}  // namespace
}  // namespace lsos
