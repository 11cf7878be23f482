// Differences between two runs.
#include "product/compare.h"

#include <gmock/gmock.h>

#include <numbers>
#include <regex>

#include "unit/record/log_fixture.h"

namespace lsos {
namespace {

using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

RunSummary compared_summary() {
  RunSummary summary;
  summary.plan = "plan.kml";
  summary.log_sha256 = "1";
  summary.rovers["SEV1"].distance_m = 100;
  summary.events = {test_event()};
  return summary;
}

Comparison comparison(const RunSummary& a, const RunSummary& b) {
  return compare({to_json(a), {{"seed", "0"}}, a.log_sha256},
                 {to_json(b), {{"seed", "0"}}, b.log_sha256});
}

TEST(Compare, finds_nothing_in_equal_runs) {
  RunSummary other = compared_summary();
  other.wall_s = 99;
  other.plan = "elsewhere/plan.kml";
  const Comparison found = comparison(compared_summary(), other);
  EXPECT_TRUE(found.is_equal());
  EXPECT_TRUE(found.has_equal_logs());
  EXPECT_THAT(found.made_of, IsEmpty());
}

// The runs have the same number of warnings, but different ones.
TEST(Compare, tells_warnings_that_one_run_has_alone_in_full) {
  RunSummary one = compared_summary(), other = compared_summary();
  const std::string begin = "the way of SEV1 to its first waypoint is longer than ";
  one.warnings = {"the same in both", begin + "2986 m"};
  other.warnings = {begin + "5973 m", "the same in both"};
  const Comparison found = comparison(one, other);
  EXPECT_FALSE(found.is_equal());
  ASSERT_THAT(found.differences, ElementsAre(Field(&Difference::quantity, "warnings")));
  EXPECT_THAT(to_text(found, {"a", "b"}), HasSubstr("2986 m"));
  EXPECT_THAT(to_text(found, {"a", "b"}), HasSubstr("5973 m"));
}

// Warnings name a plan as it was typed, and its lines may have moved.
TEST(Compare, takes_warnings_of_other_places_for_the_same) {
  RunSummary one = compared_summary(), other = compared_summary();
  one.warnings = {"plan.kml:12: Pause 10 is far away"};
  other.warnings = {"../plans/plan.kml:13: Pause 10 is far away"};
  EXPECT_TRUE(comparison(one, other).is_equal());
  other.warnings = {"../plans/plan.kml:13: Pause 20 is far away"};
  EXPECT_FALSE(comparison(one, other).is_equal());
  other.warnings = {std::string(1000000, 'x')};
  EXPECT_FALSE(comparison(one, other).is_equal());
}

TEST(Compare, counts_warnings_that_come_more_than_once) {
  RunSummary one = compared_summary(), other = compared_summary();
  one.warnings = {"B is near", "B is near", "B is near"};
  other.warnings = {"B is near"};
  EXPECT_EQ(comparison(one, other).differences.size(), 2u);
  EXPECT_EQ(comparison(other, one).differences.size(), 2u);
}

TEST(Compare, tells_values_of_both_and_how_much_they_changed) {
  RunSummary other = compared_summary();
  other.log_sha256 = "2";
  other.rovers["SEV1"].distance_m = 125;
  other.events[0].status = EventStatus::failed;
  const Comparison found = comparison(compared_summary(), other);
  EXPECT_FALSE(found.has_equal_logs());
  ASSERT_THAT(found.differences, ElementsAre(Field(&Difference::quantity, "distance_m"),
                                             Field(&Difference::quantity, "status")));
  EXPECT_EQ(found.differences[0].of, "rover SEV1");
  EXPECT_EQ(found.differences[0].change, 25);
  EXPECT_EQ(found.differences[1].of, "event SEV1/10 Route 10");
  EXPECT_EQ(found.differences[1].b, "\"failed\"");
  EXPECT_THAT(to_text(found, {"x", "y"}), HasSubstr("rover SEV1"));
}

TEST(Compare, tells_people_quantities_in_the_units_of_the_report) {
  RunSummary one = compared_summary(), other = compared_summary();
  RoverSummary& rover = one.rovers["SEV1"];
  rover.distance_m = 3450;
  rover.duration_s = 5400;
  rover.energy_used_j = 7.2e6;
  rover.max_slope_rad = std::numbers::pi / 6;
  rover.max_slip = 0.25;
  RoverSummary& changed = other.rovers["SEV1"];
  changed.distance_m = 3445;
  changed.duration_s = 5436;
  changed.energy_used_j = 7.2036e6;
  const std::string text = to_text(comparison(one, other), {"x", "y"});
  const auto has = [&](const std::string& pattern) {
    EXPECT_TRUE(std::regex_search(text, std::regex(pattern))) << pattern << "\n" << text;
  };
  has("\\n  distance +3.45 km +3.445 km +-5 m\\n");
  has("\\n  duration +1.5 h +1.51 h +\\+36 s\\n");
  has("\\n  energy used +2 kWh +2.001 kWh +\\+1 Wh\\n");
  has("\\n  max slope +30\u00b0 +-\\n");
  has("\\n  max slip +25 % +-\\n");
}

TEST(Compare, tells_rovers_and_events_that_only_one_run_has) {
  RunSummary other = compared_summary();
  other.rovers["SEV2"] = {};
  other.events[0].sequence = 20;
  const Comparison found = comparison(compared_summary(), other);
  ASSERT_EQ(found.differences.size(), 3u);
  EXPECT_EQ(found.differences[0].of, "rover SEV2");
  EXPECT_EQ(found.differences[0].a, "false");
  EXPECT_EQ(found.differences[1].of, "event SEV1/10 Route 10");
  EXPECT_EQ(found.differences[1].b, "false");
}

TEST(Compare, tells_what_runs_were_made_of_apart_from_what_they_came_to) {
  const Comparison found =
      compare({to_json(compared_summary()), {{"seed", "0"}}, compared_summary().log_sha256},
              {to_json(compared_summary()), {{"seed", "1"}}, compared_summary().log_sha256});
  EXPECT_TRUE(found.is_equal());
  ASSERT_THAT(found.made_of, ElementsAre(Field(&Difference::quantity, "seed")));
}

// Such a summary belongs to a log that no longer exists.
TEST(Compare, believes_no_summary_whose_log_has_changed) {
  const ComparedRun run{to_json(compared_summary()), {}, "1"};
  const ComparedRun changed{to_json(compared_summary()), {}, "2"};
  const Comparison found = compare(run, changed);
  EXPECT_FALSE(found.is_equal());
  EXPECT_FALSE(found.has_equal_logs());
  EXPECT_THAT(found.differences, IsEmpty());
  EXPECT_THAT(to_text(found, {"a", "b"}),
              HasSubstr("B: log.gpkg is not the log that summary.json was written of"));
  EXPECT_FALSE(compare(changed, changed).is_equal());
}

class ExactCompare : public ::testing::Test {
 protected:
  // A log of `count` samples; number `changed` has a different slip.
  std::string log(const std::string& name, int changed, int count = 10) const {
    LogWriter writer(folder / name, moon_crs, test_start());
    for (int i = 0; i < count; ++i) {
      SampleRow row = test_sample(i);
      if (i == changed) row.slip += 1e-16;
      writer.write(row);
    }
    writer.write(test_event());
    writer.finish();
    return folder / name;
  }
  ExactComparison compared(const std::string& a, const std::string& b) const {
    return compare_exactly(LogReader(a), LogReader(b));
  }

  TestFolder folder;
};

TEST_F(ExactCompare, finds_equal_logs_equal) {
  const ExactComparison found = compared(log("a.gpkg", -1), log("b.gpkg", -1));
  EXPECT_FALSE(found.difference);
  EXPECT_EQ(found.sha256[0], found.sha256[1]);
}

TEST_F(ExactCompare, names_the_first_value_that_differs) {
  const ExactComparison found = compared(log("a.gpkg", -1), log("b.gpkg", 6));
  ASSERT_TRUE(found.difference);
  EXPECT_EQ(found.difference->layer, "samples");
  EXPECT_EQ(found.difference->row, 7);
  EXPECT_EQ(found.difference->column, "slip");
  EXPECT_EQ(found.difference->where, "time_s 12, rover_id SEV1, phase drive");
  EXPECT_THAT(to_text(found, {"x", "y"}),
              HasSubstr("first difference: layer samples, row 7 (time_s 12, rover_id SEV1, "
                        "phase drive), slip: "
                        "0.05 in A"));
}

TEST_F(ExactCompare, names_a_row_that_one_log_lacks) {
  const ExactComparison found = compared(log("a.gpkg", -1), log("b.gpkg", -1, 9));
  ASSERT_TRUE(found.difference);
  EXPECT_EQ(found.difference->row, 10);
  EXPECT_EQ(found.difference->column, "");
  EXPECT_THAT(to_text(found, {"x", "y"}), HasSubstr("only A has this row"));
}

}  // namespace
}  // namespace lsos
