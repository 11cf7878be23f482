// Polygons as outlines and holes.
#include <gmock/gmock.h>

#include "plan_fixture.h"

namespace lsos {
namespace {

using ::testing::HasSubstr;

// Those of the fixture, and Survey, which drives within a polygon.
Declarations declarations() {
  Declarations known = test::declarations();
  EventDeclaration survey;
  survey.name = "Survey";
  survey.geometries = {GeometryKind::polygon};
  survey.drives = true;
  known.events[survey.name] = survey;
  return known;
}

// What is said of a plan with one rover at 31,20 and these events.
std::string said_of(const std::string& events) {
  const std::string file =
      test::write_file(test::document(test::mission() + test::rover() + events));
  Faults faults;
  read_plan(file, declarations(), faults);
  return test::said(faults);
}

std::string survey(int sequence, const std::string& outline, const std::string& hole = "") {
  const auto ring = [](const std::string& coordinates) {
    return "<LinearRing><coordinates>" + coordinates + "</coordinates></LinearRing>";
  };
  std::string polygon = "<Polygon><outerBoundaryIs>" + ring(outline) + "</outerBoundaryIs>";
  if (!hole.empty()) polygon += "<innerBoundaryIs>" + ring(hole) + "</innerBoundaryIs>";
  return test::event("Survey", "area", "A", sequence, {}, polygon + "</Polygon>");
}

// 300 m a side.
constexpr const char* area = "31,20 31.0105,20 31.0105,20.01 31,20.01 31,20";

TEST(Polygon, that_crosses_or_touches_itself_is_refused) {
  EXPECT_EQ(said_of(survey(1, area)), "");
  EXPECT_THAT(said_of(survey(1, "31,20 31.01,20.01 31.01,20 31,20.01 31,20")),
              HasSubstr("Survey 'area': the outline of the Polygon crosses itself"));
  EXPECT_THAT(said_of(survey(1, "31,20 31.01,20 31.005,20.005 31.01,20.01 31,20.01 31.005,20.005")),
              HasSubstr("Survey 'area': the outline of the Polygon touches itself"));
  EXPECT_THAT(said_of(survey(1, area, "31.002,20.002 31.005,20.005 31.005,20.002 31.002,20.005")),
              HasSubstr("Survey 'area': hole 1 of the Polygon crosses itself"));
}

TEST(Polygon, may_have_corners_that_are_written_twice) {
  EXPECT_EQ(
      said_of(survey(1, "31,20 31.0105,20 31.0105,20 31.0105,20.01 31,20.01 31,20 31,20",
                     "31.002,20.002 31.005,20.002 31.005,20.002 31.005,20.005 31.002,20.005")),
      "");
  EXPECT_THAT(said_of(survey(1, "31,20 31,20 31.01,20 31.01,20 31,20")),
              HasSubstr("Polygon has 2 corners; three or more are wanted"));
}

}  // namespace
}  // namespace lsos
