#include "plan/kml_writer.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <random>

#include "plan/kml_reader.h"
#include "plan/kmz_archive.h"
#include "plan_fixture.h"
#include "support/reference_data.h"

namespace lsos {
namespace {

namespace fs = std::filesystem;

KmlDocument example() {
  KmlDocument document;
  document.name = "run of <plan> & \"more\"";
  document.description = "what happened";
  document.schemas = {{"sample",
                       "Sample",
                       {{"rover_id", "string", "Rover"},
                        {"time_s", "double", ""},
                        {"slip", "float", ""},
                        {"count", "int", ""},
                        {"visible", "bool", ""}}}};
  KmlStyle track;
  track.id = "track";
  track.line_color_abgr = "ff0000ff";
  track.line_width = 3;
  KmlStyle spot;
  spot.id = "spot";
  spot.icon_color_abgr = "ff00ff00";
  spot.icon_scale = 0.5;
  spot.icon_href = "icons/dot.png";
  spot.label_scale = 0;
  document.styles = {track, spot};

  KmlPlacemark line;
  line.name = "A";
  line.style_id = "track";
  line.begin_utc = "2026-07-01T00:00:00Z";
  line.end_utc = "2026-07-01T01:00:00Z";
  line.geometry = {KmlGeometryKind::line,
                   {geodetic_from_degrees(31, 20), geodetic_from_degrees(-31.5, 20.25)},
                   true};
  KmlPlacemark sample;
  sample.name = "sample";
  sample.description = "a & b\x01";
  sample.style_id = "spot";
  sample.when_utc = "2026-07-01T00:00:00.500Z";
  sample.geometry = {KmlGeometryKind::point, {geodetic_from_degrees(31, 20, 1.5)}, false};
  sample.schema_id = "sample";
  sample.data = {
      {"rover_id", "A<1>"}, {"time_s", "0.5"}, {"slip", "0.1"}, {"count", "-3"}, {"visible", "1"}};
  KmlPlacemark bare;
  bare.name = "no geometry";
  KmlFolder inner;
  inner.name = "samples";
  inner.placemarks = {sample};
  document.folders = {{"rovers", "All of them", true, {line}, {inner}}};
  document.placemarks = {bare};
  return document;
}

TEST(KmlWriter, writes_what_the_ogc_schema_allows) {
  LSOS_NEEDS_REFERENCE("kml/xsd");
  const fs::path xsd = reference_file("kml/xsd");
  if (std::system("xmllint --version >/dev/null 2>&1") != 0) FAIL() << "no xmllint";
  const auto is_valid = [&](const std::string& kml) {
    const std::string file = test::write_file(kml);
    const std::string command = "XML_CATALOG_FILES='" + (xsd / "catalog.xml").string() +
                                "' xmllint --nonet --noout --schema '" +
                                (xsd / "ogckml22.xsd").string() + "' '" + file + "'";
    return std::system(command.c_str()) == 0;
  };
  EXPECT_TRUE(is_valid(write_kml(example())));
  EXPECT_TRUE(is_valid(write_kml({}))) << "an empty document";
}

TEST(KmlWriter, text_and_places_read_back) {
  const KmlSource source = parse_kml(write_kml(example()), "overlay.kml");
  ASSERT_EQ(source.placemarks.size(), 3u);
  const SourcePlacemark& sample = source.placemarks[0];
  EXPECT_EQ(sample.data.at(0).schema, "Sample");
  EXPECT_EQ(sample.data.at(0).fields.at(0).text, "A<1>");
  EXPECT_EQ(sample.geometries.at(0).coordinates, "31.000000000,20.000000000,1.500");
  EXPECT_EQ(source.placemarks[1].geometries.at(0).coordinates,
            "31.000000000,20.000000000 -31.500000000,20.250000000");
  EXPECT_EQ(source.placemarks[2].name, "no geometry");
}

TEST(KmlWriter, characters_that_xml_cannot_hold_are_replaced) {
  for (const std::string wrong :
       {"\x01", "\xff", "\xc0\xaf", "\xed\xa0\x80", "\xef\xbf\xbf", "\xe2\x82"}) {
    KmlDocument document;
    document.placemarks.resize(1);
    document.placemarks[0].name = "a" + wrong + "b";
    const std::string name = parse_kml(write_kml(document), "a.kml").placemarks.at(0).name;
    EXPECT_TRUE(name.starts_with("a\xef\xbf\xbd") && name.ends_with("b")) << name;
  }
  KmlDocument document;
  document.placemarks.resize(1);
  document.placemarks[0].name = "\xf0\x9f\x9a\x80 \xe2\x82\xac \xc3\xa9";
  EXPECT_EQ(parse_kml(write_kml(document), "a.kml").placemarks.at(0).name,
            document.placemarks[0].name);
}

TEST(KmlWriter, a_line_of_one_point_is_a_broken_promise) {
  KmlDocument document;
  document.placemarks.resize(1);
  document.placemarks[0].geometry = {KmlGeometryKind::line, {Geodetic{}}, true};
  EXPECT_THROW(write_kml(document), InternalError);
}

TEST(PackedZip, keeps_what_stands_before_the_file_that_is_replaced) {
  // Bytes that do not compress: of a small beginning libzip keeps nothing.
  std::mt19937 random(1);
  std::string picture(100'000, '\0');
  for (char& byte : picture) byte = static_cast<char>(random());
  const std::string zip = pack_zip({{"first.png", picture}, {"doc.kml", "old"}, {"last.png", "y"}});
  const std::string before = zip;
  // Twice, as the second begins with what the first has made.
  const std::string once = repacked_zip(zip, "doc.kml", "newer");
  const std::string again = repacked_zip(once, "last.png", "z");
  EXPECT_EQ(zip, before);
  KmzArchive archive(again, "plan.kmz");
  EXPECT_EQ(archive.unpacked("first.png"), picture);
  EXPECT_EQ(archive.unpacked("doc.kml"), "newer");
  EXPECT_EQ(archive.unpacked("last.png"), "z");
}

TEST(PackedZip, has_no_date_of_the_day_on_which_it_is_written) {
  const std::string zip = pack_zip({{"doc.kml", "old"}, {"last.png", "y"}});
  EXPECT_EQ(repacked_zip(zip, "doc.kml", "newer"),
            pack_zip({{"doc.kml", "newer"}, {"last.png", "y"}}));
}

}  // namespace
}  // namespace lsos
