// Plans as map tools rewrite them: fields in Data, and a Type or a folder in place of a schemaUrl.
#include <gmock/gmock.h>

#include "plan_fixture.h"

namespace lsos {
namespace {

using test::Fields;

std::string data(const Fields& fields) {
  std::string text = "<ExtendedData>";
  for (const auto& [name, value] : fields) {
    text += "<Data name=\"" + name + "\"><displayName>x</displayName><value>" + value +
            "</value></Data>";
  }
  return text + "</ExtendedData>";
}

std::string marked(const std::string& name, const std::string& inner) {
  return "<Placemark><name>" + name + "</name>" + inner + "</Placemark>\n";
}

std::string folder(const std::string& name, const std::string& inner) {
  return "<Folder><name>" + name + "</name>" + inner + "</Folder>\n";
}

struct ReadText {
  Plan plan;
  std::string faults_text;
};

ReadText read_text(const std::string& placemarks) {
  Faults faults;
  Plan plan = read_plan(test::write_file(test::document(placemarks)), test::declarations(), faults);
  return {std::move(plan), test::faults_text(faults)};
}

const Fields mission_fields_text{
    {"Planet", "Moon"}, {"StartTime", "2026-07-01T00:00:00Z"}, {"Terrain", "Flat"}};
const Fields rover_fields_text{{"RoverId", "A"}, {"RoverType", "SEV"}};
const Fields route_fields{{"RoverId", "A"}, {"Sequence", "10"}, {"Speed", "2 km/h"}};

Fields typed(const std::string& type, Fields fields) {
  fields.emplace_back("Type", type);
  return fields;
}

std::string plain() {
  return test::mission() + test::rover() +
         test::event("Route", "leg", "A", 10, {{"Speed", "2 km/h"}}, test::line());
}

TEST(MapTools, a_type_in_data_says_what_a_placemark_is) {
  const ReadText data_only =
      read_text(marked("m", data(typed("MissionInfo", mission_fields_text))) +
                marked("r", data(typed("Rover", rover_fields_text)) + test::point()) +
                marked("leg", data(typed("Route", route_fields)) + test::line()));
  EXPECT_EQ(data_only.faults_text, "");
  EXPECT_EQ(data_only.plan.hash(), read_text(plain()).plan.hash());
}

TEST(MapTools, a_folder_says_what_its_placemarks_are) {
  const ReadText folders = read_text(
      folder("MissionInfo", marked("m", data(mission_fields_text))) +
      folder("Rover", folder("today", marked("r", data(rover_fields_text) + test::point()))) +
      folder("Pause", folder("Route", marked("leg", data(route_fields) + test::line()))));
  EXPECT_EQ(folders.faults_text, "");
  EXPECT_EQ(folders.plan.hash(), read_text(plain()).plan.hash());
}

// GIS tools save a layer of many kinds with one Schema for all, which has the layer's name.
TEST(MapTools, a_type_counts_where_the_schema_is_named_after_a_layer) {
  const auto stamped = [](const std::string& name, const Fields& fields,
                          const std::string& geometry) {
    return test::placemark(name, "#Day_1.schema", fields, geometry);
  };
  Fields route = typed("Route", route_fields);
  for (const char* name : {"tessellate", "Visibility", "FID"}) route.emplace_back(name, "-1");
  route.emplace_back("Duration", "");
  const ReadText layer = read_text(stamped("m", typed("MissionInfo", mission_fields_text), "") +
                                   stamped("r", typed("Rover", rover_fields_text), test::point()) +
                                   stamped("leg", route, test::line()));
  EXPECT_EQ(layer.faults_text, "");
  EXPECT_EQ(layer.plan.hash(), read_text(plain()).plan.hash());
}

TEST(MapTools, data_beside_schema_data_are_fields_too) {
  const std::string leg = test::placemark("leg", "#Route", {{"RoverId", "A"}, {"Sequence", "10"}});
  const std::string at = "</ExtendedData>";
  std::string both = leg;
  both.replace(both.find(at), at.size(),
               "<Data name=\"Speed\"><value>2 km/h</value></Data>"
               "<Data name=\"Sequence\"><value>10</value></Data>" +
                   at + test::line());
  const ReadText joined = read_text(test::mission() + test::rover() + both);
  EXPECT_EQ(joined.faults_text, "");
  EXPECT_EQ(joined.plan.hash(), read_text(plain()).plan.hash());
}

TEST(MapTools, foreign_types_and_data_are_decoration) {
  const ReadText decorated = read_text(
      plain() + marked("trail", data({{"Type", "asphalt"}, {"width", "3"}}) + test::line()));
  EXPECT_EQ(decorated.faults_text, "");
  EXPECT_EQ(decorated.plan.decoration_count, 1);
}

}  // namespace
}  // namespace lsos
