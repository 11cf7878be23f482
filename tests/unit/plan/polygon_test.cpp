// Outlines and holes of polygons, and where a rover is after driving within one.
#include <gmock/gmock.h>

#include "plan_fixture.h"

namespace lsos {
namespace {

using ::testing::HasSubstr;

// Adds to the fixture's declarations Survey, which drives within a polygon, and Meet, whose goal is
// not known.
Declarations declarations() {
  Declarations known = test::declarations();
  EventDeclaration survey, meet;
  survey.name = "Survey";
  survey.geometries = {GeometryKind::polygon};
  meet.name = "Meet";
  meet.geometries = {GeometryKind::none};
  survey.drives = meet.drives = true;
  for (const EventDeclaration& each : {survey, meet}) known.events[each.name] = each;
  return known;
}

// The faults of a plan with one rover at 31,20 and these events.
std::string faults_of_polygon(const std::string& events) {
  const std::string file =
      test::write_file(test::document(test::mission() + test::rover() + events));
  Faults faults;
  read_plan(file, declarations(), faults);
  return test::faults_text(faults);
}

std::string survey(int sequence, const std::string& outline, const std::string& hole = "") {
  const auto ring = [](const std::string& coordinates) {
    return "<LinearRing><coordinates>" + coordinates + "</coordinates></LinearRing>";
  };
  std::string polygon = "<Polygon><outerBoundaryIs>" + ring(outline) + "</outerBoundaryIs>";
  if (!hole.empty()) polygon += "<innerBoundaryIs>" + ring(hole) + "</innerBoundaryIs>";
  return test::event("Survey", "area", "A", sequence, {}, polygon + "</Polygon>");
}

std::string rest_at(int sequence, const std::string& coordinates) {
  return test::event("Pause", "rest", "A", sequence, {{"Duration", "10"}},
                     test::point(coordinates));
}

// A square with sides of 300 m.
constexpr const char* area = "31,20 31.0105,20 31.0105,20.01 31,20.01 31,20";

TEST(Polygon, that_crosses_or_touches_itself_is_refused) {
  EXPECT_EQ(faults_of_polygon(survey(1, area)), "");
  EXPECT_THAT(faults_of_polygon(survey(1, "31,20 31.01,20.01 31.01,20 31,20.01 31,20")),
              HasSubstr("Survey 'area': the outline of the Polygon crosses itself"));
  EXPECT_THAT(faults_of_polygon(
                  survey(1, "31,20 31.01,20 31.005,20.005 31.01,20.01 31,20.01 31.005,20.005")),
              HasSubstr("Survey 'area': the outline of the Polygon touches itself"));
  EXPECT_THAT(
      faults_of_polygon(survey(1, area, "31.002,20.002 31.005,20.005 31.005,20.002 31.002,20.005")),
      HasSubstr("Survey 'area': hole 1 of the Polygon crosses itself"));
}

TEST(Polygon, may_have_corners_that_are_written_twice) {
  EXPECT_EQ(faults_of_polygon(
                survey(1, "31,20 31.0105,20 31.0105,20 31.0105,20.01 31,20.01 31,20 31,20",
                       "31.002,20.002 31.005,20.002 31.005,20.002 31.005,20.005 31.002,20.005")),
            "");
  EXPECT_THAT(faults_of_polygon(survey(1, "31,20 31,20 31.01,20 31.01,20 31,20")),
              HasSubstr("Polygon has 2 corners; three or more are wanted"));
}

TEST(Polygon, leaves_a_rover_anywhere_within) {
  EXPECT_EQ(faults_of_polygon(survey(1, area) + rest_at(2, "31.0105,20.0")), "");
  EXPECT_EQ(faults_of_polygon(survey(1, area) + rest_at(2, "31.005,20.005")), "");
  EXPECT_THAT(faults_of_polygon(survey(1, area) + rest_at(2, "31.005,20.02")),
              HasSubstr("its Point is 303 m from where rover 'A' then is expected"));
  // The leg to the next waypoint is still measured.
  EXPECT_THAT(faults_of_polygon(survey(1, area) +
                                test::event("Route", "leg", "A", 2, {}, test::line("0,0 31,20"))),
              HasSubstr("waypoint 1 (0.000000,0.000000) is"));
}

TEST(Meeting, leaves_a_rover_at_a_place_that_is_not_known) {
  const std::string meet = test::event("Meet", "both", "A", 1);
  EXPECT_EQ(faults_of_polygon(meet + rest_at(2, "31.1,20")), "");
  EXPECT_THAT(
      faults_of_polygon(meet + test::event("Route", "leg", "A", 2, {}, test::point("31.1,20")) +
                        rest_at(3, "31,20")),
      HasSubstr("its Point is 2.8 km from where rover 'A' then is expected"));
}

}  // namespace
}  // namespace lsos
