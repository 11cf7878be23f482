// Missions that wait and areas with holes, run through the whole program.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "system/run_folder.h"

namespace lsos::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

std::vector<Mark> plan_of(const std::vector<Mark>& events, const Fields& mission_fields = {}) {
  std::vector<Mark> plan{mission(mission_fields), sev("A", "31,12")};
  plan.insert(plan.end(), events.begin(), events.end());
  return plan;
}

std::string max_duration_of(const std::vector<Mark>& plan) {
  const TempFolder folder;
  const Outcome outcome = run({"check", folder.write("plan.kml", kml(plan)), "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
  const json answer = json::parse(outcome.out);
  for (const json& line : answer["defaults"]) {
    const auto text = line.get<std::string>();
    if (text.find("MaxDuration") != std::string::npos) return text;
  }
  return "";
}

TEST(MaxDuration, follows_from_the_plan_and_is_said_among_the_defaults) {
  EXPECT_EQ(max_duration_of(plan_of({event("Pause", "A", 1, {{"Duration", "90 min"}})})),
            "MissionInfo: MaxDuration = 26 h");
  EXPECT_EQ(max_duration_of(plan_of({event("Recharge", "A", 1, {{"UntilCharge", "0.9"}})})),
            "MissionInfo: MaxDuration = 366 d");
  EXPECT_EQ(max_duration_of(plan_of(
                {event("Recharge", "A", 1, {{"UntilCharge", "0.9"}, {"Duration", "1 h"}})})),
            "MissionInfo: MaxDuration = 25 h");
  EXPECT_EQ(max_duration_of(plan_of({event("SteerSP", "A", 1)})),
            "MissionInfo: MaxDuration = 24 h");
}

TEST(WaitsForEver, ends_with_the_condition_and_its_values_and_few_rows) {
  const TempFolder folder;
  const std::string plan = folder.write(
      "plan.kml", kml(plan_of({event("Pause", "A", 1,
                                     {{"Duration", "10"}, {"StartWhen", "distance_m &gt; 9"}})},
                              // An empty field counts as absent and takes its default.
                              {{"MaxDuration", "1 h"}, {"ParkedLogInterval", ""}})));
  const Outcome outcome = run({"run", plan, "-o", folder / "run", "--quiet", "--no-report"});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  const json event = summary(folder / "run")["events"][0];
  EXPECT_EQ(event["status"], "not_started");
  EXPECT_THAT(
      event["reason"].get<std::string>(),
      HasSubstr("it waited for StartWhen: distance_m > 9, which did not hold; distance_m was 0"));
  EXPECT_EQ(query(folder / "run" / "log.gpkg", "select count(*) from samples"), "61");
}

std::string ring(const char* name, const std::string& coordinates) {
  return std::string("<") + name + "><LinearRing><coordinates>" + coordinates +
         "</coordinates></LinearRing></" + name + ">";
}

// A square of 80 m by 80 m around a hole of 40 m by 40 m.
TEST(Survey, of_a_polygon_with_a_hole_keeps_out_of_it) {
  const TempFolder folder;
  const std::string polygon =
      "<MultiGeometry><Polygon>" +
      ring("outerBoundaryIs", "31,12 31.0026972,12 31.0026972,12.0026382 31,12.0026382 31,12") +
      ring("innerBoundaryIs",
           "31.0006743,12.0006596 31.0020229,12.0006596 31.0020229,12.0019787 "
           "31.0006743,12.0019787 31.0006743,12.0006596") +
      "</Polygon></MultiGeometry>";
  const std::string plan = folder.write(
      "plan.kml", kml(plan_of({event("Survey", "A", 1, {{"SampleDuration", "5 s"}}, polygon)})));
  const Outcome outcome = run({"run", plan, "-o", folder / "run", "--quiet", "--no-report"});
  EXPECT_EQ(outcome.exit_code, 0) << summary(folder / "run").dump(1);
  const std::string within =
      " where lon_deg > 31.0006743 and lon_deg < 31.0020229 and lat_deg > 12.0006596 and "
      "lat_deg < 12.0019787";
  const std::string log = folder / "run" / "log.gpkg";
  EXPECT_EQ(query(log, "select count(*) from samples" + within), "0");
  EXPECT_GT(std::stoi(query(log, "select count(*) from notes where name = 'sample'")), 10);
}

}  // namespace
}  // namespace lsos::test
