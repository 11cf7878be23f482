// Files of all formats, and what is refused before anything is opened.
#include "interchange/source_tables.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "interchange/imported_plan.h"
#include "plan/kml_writer.h"
#include "support/reference_data.h"
#include "unit/plan/plan_fixture.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class SourceTables : public ::testing::Test {
 protected:
  SourceTables() : folder_(fs::temp_directory_path() / fmt::format("lsos_tables_{}", ::getpid())) {
    fs::create_directories(folder_);
  }
  ~SourceTables() override { fs::remove_all(folder_); }

  std::vector<Table> read(const std::string& name, const std::string& bytes) {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return read_tables((folder_ / name).string(), declarations(), left_out_);
  }
  std::string error(const std::string& name, const std::string& bytes) {
    try {
      read(name, bytes);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder_;
  std::vector<std::string> left_out_;
};

TEST_F(SourceTables, of_geojson_have_names_and_geometries) {
  const auto tables = read("map.geojson", R"({"type":"FeatureCollection","features":[
    {"type":"Feature","properties":{"name":"Ridge","depth":2.5},
     "geometry":{"type":"Point","coordinates":[0.01,0.005]}},
    {"type":"Feature","properties":{"name":"Line"},
     "geometry":{"type":"LineString","coordinates":[[0,0],[0.01,0.005]]}}]})");
  ASSERT_EQ(tables.size(), 1u);
  ASSERT_EQ(tables[0].rows.size(), 2u);
  EXPECT_EQ(tables[0].rows[0].geometry->coordinates, "0.01,0.005");
  EXPECT_EQ(tables[0].rows[1].geometry->coordinates, "0,0 0.01,0.005");
  EXPECT_EQ(tables[0].body, "");
}

TEST_F(SourceTables, of_gpx_are_waypoints_routes_and_tracks) {
  const auto tables = read("walk.gpx", R"(<gpx version="1.1" creator="x"
    xmlns="http://www.topografix.com/GPX/1/1"><wpt lat="0.005" lon="0.01"><name>Ridge</name></wpt>
    <rte><name>Out</name><rtept lat="0" lon="0"/><rtept lat="0.005" lon="0.01"/></rte></gpx>)");
  ASSERT_EQ(tables.size(), 2u);
  EXPECT_EQ(tables[0].rows[0].geometry->kind, "Point");
  EXPECT_EQ(tables[1].rows[0].geometry->coordinates, "0,0 0.01,0.005");
}

TEST_F(SourceTables, of_xpjson_are_stations_and_routes) {
  const auto tables = read("plan.json", R"({"xpjson":"0.2","type":"Plan",
    "platform":{"type":"Platform","name":"K10"},"sequence":[
    {"type":"Station","name":"Start","id":"S0","geometry":{"type":"Point","coordinates":[0,0]}},
    {"type":"Segment","speed":0.3,"tolerance":0.5,
     "sequence":[{"type":"PeriodicPancam","id":"P1"}]},
    {"type":"Station","name":"End","id":"S1","geometry":{"type":"Point","coordinates":[0.001,0]},
     "sequence":[{"type":"Pause","id":"P2","Duration":60}]}]})");
  ASSERT_EQ(tables.size(), 2u);
  EXPECT_EQ(tables[0].rows.size(), 4u);  // two stations by name and id
  ASSERT_EQ(tables[1].rows.size(), 2u);
  EXPECT_THAT(tables[1].rows[0].cells, ElementsAre("Route", "End", "K10", "0.3", "0.5"));
  EXPECT_EQ(cell(tables[1].rows[1], 0), "Pause");
  EXPECT_TRUE(tables[1].file.ends_with("plan.json/item")) << tables[1].file;
  EXPECT_EQ(tables[1].rows[1].number, 3);
  ASSERT_EQ(left_out_.size(), 1u);
  EXPECT_THAT(left_out_[0], HasSubstr("P1: there is no event PeriodicPancam"));
}

TEST_F(SourceTables, of_the_example_plan_of_xgds) {
  const char* const plan = "kml/xgds/xpjsonSpec/examplePlan.json";
  LSOS_NEEDS_REFERENCE(plan);
  const auto tables = read_tables(reference_file(plan).string(), declarations(), left_out_);
  ASSERT_EQ(tables.size(), 2u);
  EXPECT_EQ(tables[1].rows.size(), 2u);
  EXPECT_EQ(cell(tables[1].rows[0], 1), "Waypoint 1");
  EXPECT_EQ(tables[1].rows[1].geometry->coordinates, "-122.065639,37.416503");
  EXPECT_EQ(left_out_.size(), 2u);
}

TEST_F(SourceTables, are_refused_of_what_is_something_else) {
  const std::string zip = pack_zip({{"a", "b"}});
  EXPECT_THAT(error("a.csv", zip),
              HasSubstr("is a workbook, though its name ends as that of a CSV"));
  EXPECT_THAT(error("a.xlsx", "Type,Rover\n"), HasSubstr("is no .xlsx file"));
  EXPECT_THAT(error("a.xls", "x"), HasSubstr("save it as .xlsx, .ods or .csv"));
  EXPECT_THAT(error("a.doc", "x"), HasSubstr(".doc is no format that is imported; there are a "
                                             "spreadsheet"));
  EXPECT_THAT(error("a.csv", ""), HasSubstr("is empty"));
  EXPECT_THAT(error("a.gpx", "x"), HasSubstr("cannot be read as GPX"));
  EXPECT_THAT(error("a.json", R"({"xpjson":"0.2","type":"Library"})"),
              HasSubstr("is xPJSON of the type 'Library'"));
  EXPECT_THAT(error("a.json", R"({"xpjson":"0.2","type":"Plan","sequence":[)"),
              HasSubstr("is no JSON"));
  EXPECT_THROW(read_tables((folder_ / "absent.csv").string(), declarations(), left_out_),
               InputError);
}

TEST_F(SourceTables, follow_no_link_to_a_crs) {
  EXPECT_THAT(error("a.geojson", R"({"type":"FeatureCollection",
    "crs":{"type":"link","properties":{"href":"http://127.0.0.1:9/crs"}},"features":[]})"),
              HasSubstr("a.geojson:2: its crs is a link, and no link is followed"));
}

TEST_F(SourceTables, of_a_file_that_is_given_twice_are_refused) {
  for (const char* name : {"a.csv", "b.csv", "c.csv"}) {
    std::ofstream(folder_ / name) << (name[0] == 'c' ? "Type,Rover\n" : "Type,Place\n");
  }
  const auto path = [&](const char* name) { return (folder_ / name).string(); };
  Faults faults;
  report_equal_files({path("a.csv"), path("c.csv"), path("absent.csv")}, faults);
  EXPECT_EQ(faults_text(faults), "");
  report_equal_files({path("a.csv"), path("c.csv"), path("b.csv"), path("a.csv")}, faults);
  EXPECT_THAT(faults_text(faults), HasSubstr("b.csv: has the same content as " + path("a.csv") +
                                             ", so that all in it would stand twice"));
  EXPECT_THAT(faults_text(faults), HasSubstr("a.csv: is given twice, so that"));
}

// Web maps of Earth are in metres.
TEST_F(SourceTables, in_metres_of_another_body_say_what_to_do) {
  const auto tables = read("map.geojson", R"({"type":"FeatureCollection",
    "crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::3857"}},"features":[
    {"type":"Feature","properties":{"name":"Ridge"},
     "geometry":{"type":"Point","coordinates":[1000,1000]}}]})");
  Faults faults;
  const ImportedPlan made = import_tables(tables, declarations(), faults);
  KmlSource source = made.source;
  SourcePlacemark mission;
  mission.data.push_back(
      {"",
       "MissionInfo",
       {{"Planet", "Moon", 1}, {"StartTime", "2026-07-01", 1}, {"Terrain", "Flat", 1}},
       1});
  source.placemarks.push_back(mission);
  read_plan("plan.kml", source, declarations(), faults);
  EXPECT_THAT(faults_text(faults),
              HasSubstr("its CRS is of Earth, Planet is Moon; it is to be saved in IAU_2015:30100, "
                        "or in degrees of Earth, which are then taken for those of Moon"));
}

// Who draws lines in a folder Route means the row of a sheet that names them.
TEST_F(SourceTables, of_a_folder_called_as_an_event_are_lines_for_a_sheet_that_names_them) {
  auto tables = read("map.kml", R"(<kml xmlns="http://www.opengis.net/kml/2.2"><Document>
    <Folder><name>Route</name><Placemark><name>Out</name><LineString>
    <coordinates>0,0 0.01,0</coordinates></LineString></Placemark></Folder></Document></kml>)");
  tables.push_back(read("when.csv", "Type,Name,Rover\nRoute,out,A\n").at(0));
  Faults faults;
  const ImportedPlan made = import_tables(tables, declarations(), faults);
  EXPECT_EQ(faults_text(faults), "");
  ASSERT_EQ(made.source.placemarks.size(), 1u);
  EXPECT_EQ(made.source.placemarks[0].geometries.at(0).coordinates, "0,0 0.01,0");
}

TEST_F(SourceTables, of_a_folder_called_as_an_event_are_of_its_type) {
  const auto tables = read("map.kml", R"(<kml xmlns="http://www.opengis.net/kml/2.2"><Document>
    <Folder><name>Route</name><Placemark><name>Out</name><ExtendedData><Data name="RoverId">
    <value>A</value></Data></ExtendedData><LineString><coordinates>0,0 0.01,0</coordinates>
    </LineString></Placemark></Folder></Document></kml>)");
  Faults faults;
  const ImportedPlan made = import_tables(tables, declarations(), faults);
  ASSERT_EQ(made.source.placemarks.size(), 1u);
  EXPECT_EQ(made.source.placemarks[0].data.at(0).schema, "Route");
}

}  // namespace
}  // namespace lsos::test
