// Plans that GIS tools read and save again, through GDAL's drivers and as a GeoPackage.
#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "system/plan_text.h"
#include "system/process.h"
#include "system/run_folder.h"
#include "system/source_files.h"
#include "system/temp_folder.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;

// Hash of a plan, which is independent of how it is written, and its faults, with their severity,
// without their lines and sorted.
struct Checked {
  std::string hash;
  std::string faults;
  bool is_valid = false;
};

Checked checked(const std::string& plan) {
  const Outcome outcome = run({"check", plan, "--json"});
  const json answer = json::parse(outcome.out, nullptr, false);
  if (answer.is_discarded()) return {"", outcome.out + outcome.err, false};
  std::vector<std::string> whats;
  for (const json& fault : answer["faults"]) {
    whats.push_back(fault["severity"].get<std::string>() + ": " + fault["what"].get<std::string>());
  }
  std::ranges::sort(whats);
  std::string faults;
  for (const std::string& what : whats) faults += what + "\n";
  return {answer["plan_sha256"], faults, answer["is_valid"]};
}

struct Driver {
  std::string name, ending;
};
const std::vector<Driver> drivers{{"LIBKML", "kml"}, {"LIBKML", "kmz"}, {"KML", "kml"}};

Outcome save_again(const std::string& plan, const Driver& driver, const std::string& out) {
  return run_command({"ogr2ogr", "-f", driver.name, out, plan},
                     {.environment = {"GDAL_PAM_ENABLED=NO"}});
}

TEST(MapTools, shipped_plans_come_back_from_every_driver) {
  for (const fs::path& plan : shipped_plans()) {
    const Checked before = checked(plan);
    // Shipped plans may have warnings that are true, as of a camp that the base does not see.
    ASSERT_TRUE(before.is_valid) << plan << "\n" << before.faults;
    for (const Driver& driver : drivers) {
      const TempFolder folder;
      const std::string out = folder / ("plan." + driver.ending);
      const Outcome outcome = save_again(plan, driver, out);
      ASSERT_EQ(outcome.exit_code, 0) << plan << "\n" << outcome.err;
      const Checked after = checked(out);
      EXPECT_TRUE(after.is_valid) << plan << " by " << driver.name << "\n" << after.faults;
      EXPECT_EQ(after.faults, before.faults) << plan << " by " << driver.name;
      EXPECT_EQ(after.hash, before.hash) << plan << " by " << driver.name;
    }
  }
}

// Random plans whose labels and values have characters that are difficult in XML and for tools.
class RandomPlan {
 public:
  explicit RandomPlan(unsigned seed) : random_(seed) {}

  std::string text(const std::string& schemas) {
    // Features with places come first: GDAL takes a layer's geometry type from its first feature.
    std::string marks;
    for (const char* id : {"A", "B & C"}) {
      marks += mark("Rover", std::string("rover ") + id,
                    {{"RoverId", id},
                     {"RoverType", "SEV"},
                     {"InitialCharge", any({"0.5", "80 %", "1"})},
                     {"Heading", any({"", "90", "-1.5 rad"})}},
                    point(place()));
    }
    marks += mark("MissionInfo", "Mission",
                  {{"Planet", "Moon"},
                   {"StartTime", "2026-07-01T0" + digit() + ":00:00Z"},
                   {"Terrain", "Flat"},
                   {"Seed", digit()},
                   {"LogInterval", any({"2", "4 s", "0.1 min"})}});
    for (int sequence = 10; sequence < 80; sequence += 10) {
      marks += "<Folder><name>" + any({"Day 1", "Day &lt;2&gt;", "stop: \xc3\xa4"}) + "</name>" +
               event(any({"A", "B & C"}), std::to_string(sequence)) + "</Folder>";
    }
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<kml "
           "xmlns=\"http://www.opengis.net/kml/2.2\"><Document>" +
           schemas + marks + "</Document></kml>\n";
  }

 private:
  int below(int count) { return std::uniform_int_distribution<>(0, count - 1)(random_); }
  std::string digit() { return std::to_string(below(10)); }
  std::string any(const std::vector<std::string>& all) {
    return all[static_cast<std::size_t>(below(static_cast<int>(all.size())))];
  }
  std::string place() { return "31.00" + digit() + digit() + ",12.000" + digit() + digit(); }

  static std::string escaped(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
      escaped += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
    }
    return escaped;
  }

  std::string mark(const std::string& type, const std::string& name, const Fields& fields,
                   const std::string& geometry = "") {
    std::string text = "<Placemark><name>" + escaped(name) +
                       "</name><ExtendedData><SchemaData "
                       "schemaUrl=\"#" +
                       type + "\"><SimpleData name=\"Type\">" + type + "</SimpleData>";
    for (const auto& [field, value] : fields) {
      // GDAL reads an empty number as 0, of which check warns.
      if (value.empty() && field == "Crew") continue;
      text += "<SimpleData name=\"" + field + "\">" + escaped(value) + "</SimpleData>";
    }
    return text + "</SchemaData></ExtendedData>" + geometry + "</Placemark>\n";
  }

  std::string event(const std::string& rover, const std::string& sequence) {
    Fields fields{{"RoverId", rover},
                  {"Sequence", sequence},
                  {"Enabled", any({"true", "0", "1", ""})},
                  {"Timeout", any({"", "3 h", "PT40M"})},
                  {"OnFailure", any({"", "skip", "abort"})}};
    const std::string name =
        any({"leg", "a, \"b\"", "x < y & z", "\xe6\x9c\x88"}) + sequence + rover;
    switch (below(5)) {
      case 0:
        fields.emplace_back("Speed", any({"", "1", "6 km/h", "0.5 m/s"}));
        return mark("Route", name, fields, line(place() + " " + place() + " " + place()));
      case 1:
        fields.emplace_back("MaxSlope", any({"", "14", "0.2 rad"}));
        return mark("PathPlanRoute", name, fields, point(place()));
      case 2:
        fields.emplace_back("Duration", any({"60", "1.5 h", "PT5M", "2 min"}));
        return mark("Pause", name, fields);
      case 3:
        fields.emplace_back("Crew", any({"", "1", "3"}));
        fields.emplace_back("ActivityDuration", any({"", "1 h", "5400"}));
        return mark("EVA", name, fields, point(place()));
      default:
        fields.emplace_back("Spacing", any({"5", "10 m"}));
        return mark("Survey", name, fields,
                    "<Polygon><outerBoundaryIs><LinearRing><coordinates>31,12 31.002,12 "
                    "31.002,12.002 31,12.002 31,12</coordinates></LinearRing></outerBoundaryIs>"
                    "</Polygon>");
    }
  }

  std::mt19937 random_;
};

// The <Schema> elements of every kind of Placemark.
std::string all_schemas() {
  const std::string text = run({"schema"}).out;
  const std::size_t first = text.find("<Schema"), end = text.rfind("</Schema>");
  return text.substr(first, end + 9 - first);
}

void expect_round_trips(int count) {
  const std::string schemas = all_schemas();
  int equal = 0;
  for (int k = 0; k < count; ++k) {
    const TempFolder folder;
    const std::string plan =
        folder.write("plan.kml", RandomPlan(static_cast<unsigned>(k)).text(schemas));
    const Checked before = checked(plan);
    ASSERT_NE(before.hash, "") << before.faults;
    const Driver& driver = drivers[static_cast<std::size_t>(k) % drivers.size()];
    const std::string out = folder / ("out." + driver.ending);
    ASSERT_EQ(save_again(plan, driver, out).exit_code, 0);
    const Checked after = checked(out);
    // LIBKML writes a heading into a Camera, as a number of degrees, of which check warns.
    if (after.faults.find("stands in a Camera") != std::string::npos) continue;
    ++equal;
    EXPECT_EQ(after.hash, before.hash) << "seed " << k << " by " << driver.name << "\n"
                                       << before.faults << "\nthen\n"
                                       << after.faults;
  }
  EXPECT_GE(equal, count / 3);
}

// The long tests set a greater number.
TEST(MapTools, random_plans_come_back) {
  const char* count = std::getenv("LSOS_ROUND_TRIPS");
  expect_round_trips(count == nullptr ? 8 : std::atoi(count));
}

// GDAL converts the layers of a plan to a GeoPackage.
TEST(GeoPackagePlan, is_the_plan_that_it_was_made_of) {
  for (const char* name : {"two_rovers", "solar_stop", "lunar_traverse"}) {
    const std::string plan = repository() / "plans" / (std::string(name) + ".kml");
    const TempFolder folder;
    const std::string layers = folder / "plan.gpkg";
    ASSERT_EQ(save_again(plan, {"GPKG", "gpkg"}, layers).exit_code, 0);
    EXPECT_EQ(checked(layers).hash, checked(plan).hash) << checked(layers).faults;
    EXPECT_THAT(checked(layers).faults,
                HasSubstr("its CRS is of Earth, Planet is Moon: its degrees are taken for those"));
  }
}

TEST(GeoPackagePlan, is_run_as_any_other) {
  const TempFolder folder;
  const std::string layers = folder / "plan.gpkg";
  const std::string form = folder / "form.gpkg";
  const Outcome made = run({"schema", "Pause", "Route", "-o", form});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  // The features are drawn in metres of a map of the Moon.
  const auto ogr = [&](const Words& words) {
    const Outcome outcome = run_command(words, {.environment = {"GDAL_PAM_ENABLED=NO"}});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  };
  const std::string features =
      folder.write("drawn.csv",
                   "RoverId;RoverType;Sequence;Type;WKT\nA;SEV;;Rover;POINT (0 0)\n"
                   "A;;10;Route;\"LINESTRING (0 0, 30 0)\"\n");
  ogr({"ogr2ogr", "-f", "GPKG", layers, features, "-nln", "drawn", "-oo", "GEOM_POSSIBLE_NAMES=WKT",
       "-oo", "SEPARATOR=SEMICOLON", "-a_srs",
       "+proj=eqc +lat_ts=0 +lat_0=0 +lon_0=0 +x_0=0 +y_0=0 +R=1737400 +units=m +no_defs"});
  ogr({"ogr2ogr", "-append", layers, form, "MissionInfo"});
  const Outcome outcome = run({"run", layers, "-o", folder / "run", "--quiet", "--no-report"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  const json result = summary(folder / "run");
  EXPECT_NEAR(result["rovers"]["A"]["distance_m"], 30, 1);
  // The run keeps the same plan as KML.
  EXPECT_EQ(checked(folder / "run/plan.kml").hash, checked(layers).hash);
}

TEST(GeoPackagePlan, on_a_map_of_another_body_is_refused) {
  const TempFolder folder;
  const std::string layers = folder / "plan.gpkg";
  const std::string features =
      folder.write("drawn.csv", "RoverId;RoverType;Type;WKT\nA;SEV;Rover;POINT (500000 4e6)\n");
  run_command({"ogr2ogr", "-f", "GPKG", layers, features, "-oo", "GEOM_POSSIBLE_NAMES=WKT", "-oo",
               "SEPARATOR=SEMICOLON", "-a_srs", "EPSG:32612"});
  run({"schema", "Pause", "-o", folder / "form.gpkg"});
  run_command({"ogr2ogr", "-append", layers, folder / "form.gpkg", "MissionInfo"});
  EXPECT_THAT(checked(layers).faults, HasSubstr("its CRS is of Earth, Planet is Moon"));
  const Outcome outcome = run({"check", layers});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.out, HasSubstr("plan.gpkg/drawn: its CRS is of Earth"));
}

// Output of check for one feature of a layer Route, beside a form's MissionInfo and a rover.
std::string faults_of_route(const std::string& wkt, const std::string& columns = "",
                            const std::string& values = "") {
  const TempFolder folder;
  const std::string layers = folder / "plan.gpkg";
  const std::string rovers =
      folder.write("Rover.csv", "RoverId;RoverType;WKT\nA;SEV;POINT (0 0)\n");
  const std::string routes = folder.write(
      "Route.csv", "RoverId;Sequence;" + columns + "WKT\nA;10;" + values + "\"" + wkt + "\"\n");
  for (const std::string& file : {rovers, routes}) {
    const Outcome made =
        run_command({"ogr2ogr", "-f", "GPKG", "-update", "-append", layers, file, "-oo",
                     "GEOM_POSSIBLE_NAMES=WKT", "-oo", "SEPARATOR=SEMICOLON", "-nlt", "GEOMETRY",
                     "-a_srs", "+proj=longlat +R=1737400 +no_defs"},
                    {.environment = {"GDAL_PAM_ENABLED=NO"}});
    EXPECT_EQ(made.exit_code, 0) << made.err;
  }
  run({"schema", "Pause", "-o", folder / "form.gpkg"});
  run_command({"ogr2ogr", "-append", layers, folder / "form.gpkg", "MissionInfo"});
  const Outcome outcome = run({"check", layers});
  EXPECT_NE(outcome.exit_code, 3) << outcome.err;
  return outcome.out;
}

// Merging and dissolving in a GIS create such geometries.
TEST(GeoPackagePlan, of_several_parts_is_told_by_its_layer_and_feature) {
  EXPECT_THAT(faults_of_route("MULTILINESTRING ((0 0, 0.001 0), (0.001 0, 0.001 0.001))"),
              HasSubstr("plan.gpkg/Route:1: Route 10: has a MultiGeometry"));
  EXPECT_THAT(faults_of_route("LINESTRING (0 0)"),
              HasSubstr("plan.gpkg/Route:1: Route 10: LineString has one coordinate"));
  EXPECT_THAT(faults_of_route("GEOMETRYCOLLECTION (POINT (0 0), LINESTRING (0 0, 0.001 0))"),
              HasSubstr("has a MultiGeometry"));
  EXPECT_THAT(faults_of_route("MULTILINESTRING ((0 0, 0.001 0), EMPTY)"), HasSubstr("can be run"));
}

TEST(GeoPackagePlan, has_columns_of_its_own) {
  const std::string output =
      faults_of_route("LINESTRING (0 0, 0.001 0)", "speed_kmh;heading;", "5;90;");
  EXPECT_THAT(output, HasSubstr("can be run"));
  EXPECT_THAT(output,
              HasSubstr("the column 'speed_kmh' is no field of a Route; it is not used; did "
                        "you mean 'Speed'?"));
  EXPECT_THAT(output, ::testing::Not(HasSubstr("heading'")));
  // A misspelt column is a fault.
  EXPECT_THAT(faults_of_route("LINESTRING (0 0, 0.001 0)", "Speeed;", "5;"),
              HasSubstr("there is no field 'Speeed'; did you mean 'Speed'?"));
}

TEST(SchemaForm, names_the_unit_of_bare_numbers) {
  const TempFolder folder;
  run({"schema", "EVA", "Route", "-o", folder / "form.gpkg"});
  const auto style = [&](const char* layer) {
    return query(folder / "form.gpkg",
                 std::string("select replace(replace(styleQML, char(10), ' '), '|', '!') from "
                             "layer_styles where f_table_name = '") +
                     layer + "'");
  };
  EXPECT_THAT(style("EVA"), HasSubstr("name=\"ActivityDuration (s)&#10;"));
  EXPECT_THAT(style("Route"), HasSubstr("name=\"Speed (m/s)&#10;Driving speed"));
}

// QGIS saves a feature without a place in a layer of lines as an empty geometry.
TEST(MapTools, an_empty_geometry_is_none) {
  const TempFolder folder;
  std::vector<Mark> marks = short_drive();
  for (Mark& mark : marks) {
    if (mark.type == "Pause") mark.geometry = line("");
  }
  const Outcome outcome = run({"check", folder.write("plan.kml", kml(marks))});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
}

TEST(SchemaForm, counts_sequences_over_layers_of_any_prefix) {
  const TempFolder folder;
  run({"schema", "Route", "Pause", "-o", folder / "form.gpkg"});
  const std::string style = query(folder / "form.gpkg",
                                  "select replace(replace(styleQML, char(10), ' '), '|', '!') from "
                                  "layer_styles where f_table_name = 'Pause'");
  EXPECT_THAT(style, HasSubstr("aggregate(regexp_replace(@layer_name, 'Pause$', 'Route'), 'max'"));
  EXPECT_THAT(style, HasSubstr("<attributeEditorContainer name=\"When, and if it fails\""));
}

TEST(GeoPackagePlan, that_is_no_geopackage_says_so) {
  const TempFolder folder;
  const std::string file = folder.write("plan.gpkg", std::string("SQLite format 3\0 more", 21));
  const Outcome outcome = run({"check", file});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.out + outcome.err, HasSubstr("is an SQLite database but no GeoPackage"));
}

TEST(SchemaForm, is_not_written_over_what_is_there) {
  const TempFolder folder;
  const std::string file = folder.write("plan.gpkg", "mine");
  const Outcome outcome = run({"schema", "-o", file});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("is there already; it is not replaced"));
}

}  // namespace
}  // namespace lsos::test
