// Sound plans that are close to what check warns of, and must cause no warning.
#include <gmock/gmock.h>

#include <filesystem>

#include "system/run_folder.h"
#include "system/source_files.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

void expect_sound(const std::vector<Mark>& plan) {
  const TempFolder folder;
  const Outcome outcome = run({"check", folder.write("plan.kml", kml(plan))});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
  EXPECT_THAT(outcome.out, HasSubstr("nothing is wrong with it"));
}

TEST(SoundPlan, may_have_bare_numbers_that_are_meant) {
  expect_sound(
      {mission(),
       Mark{"Rover", {{"RoverId", "A"}, {"RoverType", "SEV"}, {"Heading", "5.5"}}, point("31,12")},
       event("EVA", "A", 1, {{"ActivityDuration", "350"}, {"ExitDuration", "44"}}),
       event("PathPlanRoute", "A", 2, {{"MaxSlope", "5.5"}}, point("31.002,12"))});
}

TEST(SoundPlan, may_ask_for_more_than_a_quantity_can_be) {
  expect_sound({mission(), sev("A", "31,12"),
                event("Pause", "A", 1,
                      {{"Duration", "10"},
                       {"StopWhen",
                        "heading_rad &gt; -0.1 and heading_rad &lt; 0.1 and slope_rad &lt; 1.6 and "
                        "pitch_rad &gt; -1.5708 and lon_deg &lt; 180.5 and energy_j &lt;= 1"}})});
}

// The pause is ended by StopWhen.
TEST(SoundPlan, may_pause_longer_than_a_mission_lasts_until_a_condition_ends_it) {
  expect_sound({mission(), sev("A", "31,12"),
                event("Pause", "A", 1, {{"Duration", "400 d"}, {"StopWhen", "charge &lt; 0.9"}})});
}

TEST(SoundPlan, may_drive_there_and_back_and_in_a_loop) {
  expect_sound({mission(), sev("A", "31,12"), event("Route", "A", 1, {}, line("31,12 31.01,12")),
                event("Route", "A", 2, {}, line("31.01,12 31,12")),
                event("Route", "A", 3, {}, line("31,12 31.005,12 31.005,12.005 31,12"))});
}

TEST(SoundPlan, may_have_a_rover_with_other_numbers) {
  const auto max_duration = [](const Fields& more) {
    Fields fields{{"RoverId", "A"}, {"RoverType", "SEV"}};
    fields.insert(fields.end(), more.begin(), more.end());
    const TempFolder folder;
    const std::string plan = folder.write(
        "plan.kml", kml({mission(), Mark{"Rover", fields, point("31,12")},
                         event("Route", "A", 1, {{"Speed", "0.01"}}, line("31,12 31.1,12"))}));
    const std::string text = run({"check", plan, "--json"}).out;
    const std::size_t at = text.find("MaxDuration = ");
    return text.substr(at, text.find('"', at) - at);
  };
  EXPECT_EQ(max_duration({}), max_duration({{"Variant", "battery.capacity_j = 41 kWh"}}));
  EXPECT_THAT(max_duration({}), HasSubstr(" h"));
}

TEST(SoundRaster, may_lie_in_a_county_or_on_a_slope) {
  for (const char* name : {"county_dem", "north_slope_dem", "Mount_Terror", "height_slope_rock"}) {
    const TempFolder folder;
    for (const char* ending : {".asc", ".prj"}) {
      fs::copy(repository() / "tests/messages/mission" / (std::string("high") + ending),
               folder / (std::string(name) + ending));
    }
    const Outcome outcome =
        run({"terrain", folder / (std::string(name) + ".asc"), "--at", "0,0"}, {folder.path()});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "") << name;
  }
}

}  // namespace
}  // namespace lsos::test
