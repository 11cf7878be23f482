// Several runs against the first of them.
#include "product/comparison/several_runs.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <set>

#include "product/comparison/several_runs_text.h"
#include "unit/record/log_fixture.h"

namespace lsos {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

EventRow ended_event(std::int64_t sequence, double end_s) {
  EventRow row = test_event();
  row.sequence = sequence;
  row.label = "Event " + std::to_string(sequence);
  row.status = EventStatus::completed;
  row.end = from_seconds(end_s);
  row.distance_m = 100;
  return row;
}

// A run with two events.
struct MadeUpRun {
  std::vector<EventRow> events{ended_event(10, 60), ended_event(20, 120)};
  double distance_m = 100;
  std::string sha256 = "1";
};

SeveralRuns several(const std::vector<MadeUpRun>& runs) {
  std::vector<RunOutcome> outcomes;
  std::vector<ComparedRun> compared;
  for (const MadeUpRun& run : runs) {
    RunSummary summary;
    summary.plan = "plan.kml";
    summary.log_sha256 = run.sha256;
    summary.rovers["SEV1"].distance_m = run.distance_m;
    summary.events = run.events;
    compared.push_back({to_json(summary), {{"seed", "0"}}, run.sha256});
    outcomes.push_back({"out/" + run_name(outcomes.size()), run.events, to_json(summary)});
  }
  return compare_several(outcomes, compared);
}

TEST(SeveralRuns, that_are_equal_have_no_event_that_differs) {
  const SeveralRuns found = several({{}, {}, {}});
  EXPECT_TRUE(found.are_equal());
  EXPECT_THAT(found.events, IsEmpty());
  EXPECT_THAT(to_text(found), HasSubstr("C out/C: completed, equal to A, log and all"));
  EXPECT_THAT(to_text(found), HasSubstr("no event differs"));
  EXPECT_EQ(json::parse(to_json(found))["equal"], true);
}

TEST(SeveralRuns, have_those_events_that_differ_from_the_first) {
  MadeUpRun later, failing;
  later.events[1].end = from_seconds(150.5);
  failing.events[1].status = EventStatus::failed;
  failing.events[1].distance_m = 50;
  const SeveralRuns found = several({{}, later, {}, failing});
  EXPECT_FALSE(found.are_equal());
  ASSERT_THAT(found.events, SizeIs(1));
  EXPECT_EQ(found.events[0].sequence, 20);
  EXPECT_TRUE(found.events[0].differs(1));
  EXPECT_FALSE(found.events[0].differs(2));
  EXPECT_TRUE(found.events[0].differs(3));
  const std::string text = to_text(found);
  EXPECT_THAT(text, HasSubstr("event SEV1/20 Event 20\n"
                              "        status      start        end  distance  energy used\n"
                              "  A  completed  0:00:00.1    0:02:00     100 m            -\n"
                              "  B          =          =  0:02:30.5         =            =\n"
                              "  D     failed          =          =      50 m            =\n"));
  EXPECT_THAT(text, Not(HasSubstr("Event 10")));
  const json answer = json::parse(to_json(found));
  EXPECT_EQ(answer["events"][0]["runs"][1]["end_s"], 150.5);
  EXPECT_EQ(answer["events"][0]["runs"][3]["status"], "failed");
  EXPECT_EQ(answer["events"][0]["runs"][2]["differs"], false);
  EXPECT_EQ(answer["runs"][2]["equal"], true);
  EXPECT_EQ(answer["runs"][1]["equal"], false);
}

TEST(SeveralRuns, tell_events_that_some_of_them_lack) {
  MadeUpRun shorter, longer;
  shorter.events.pop_back();
  longer.events.push_back(ended_event(30, 200));
  const SeveralRuns found = several({{}, shorter, longer});
  ASSERT_THAT(found.events, SizeIs(2));
  EXPECT_THAT(to_text(found), HasSubstr("B  no such event"));
  EXPECT_THAT(to_text(found), HasSubstr("A  no such event"));
  EXPECT_TRUE(json::parse(to_json(found))["events"][0]["runs"][1].is_null());
}

TEST(SeveralRuns, may_differ_in_other_values_alone) {
  MadeUpRun other;
  other.distance_m = 101;
  other.sha256 = "2";
  const SeveralRuns found = several({{}, other, {}});
  EXPECT_FALSE(found.are_equal());
  EXPECT_THAT(found.events, IsEmpty());
  EXPECT_THAT(to_text(found), HasSubstr("B out/B: completed, differs from A in other values"));
  EXPECT_THAT(to_text(found), HasSubstr("101 m"));
}

TEST(SeveralRuns, tell_of_a_log_that_is_not_the_one_of_its_summary) {
  SeveralRuns found = several({{}, {}, {}});
  found.with_first[1].logs[1].of_log = "2";
  EXPECT_FALSE(found.are_equal());
  EXPECT_THAT(
      to_text(found),
      HasSubstr("C out/C: completed\n  log.gpkg is not the log that summary.json was written"));
}

TEST(SeveralRuns, have_a_name_and_a_colour_each) {
  std::set<std::string> names, colours;
  for (std::size_t k = 0; k < runs_max; ++k) {
    names.insert(run_name(k));
    colours.insert(run_colour(k));
  }
  EXPECT_THAT(names, SizeIs(runs_max));
  EXPECT_THAT(colours, SizeIs(runs_max));
  EXPECT_EQ(*names.rbegin(), "K");
}

TEST(SeveralRuns, are_compared_exactly_with_the_first_each) {
  const TestFolder folder;
  const auto log = [&](const std::string& name, double charge) {
    LogWriter writer(folder / name, moon_crs, test_start());
    SampleRow row = test_sample(0);
    row.charge = charge;
    writer.write(row);
    writer.finish();
  };
  log("a", 0.5);
  log("b", 0.5);
  log("c", 0.6);
  const LogReader a(folder / "a"), b(folder / "b"), c(folder / "c");
  const ExactAgainstFirst exact{{"a", "b", "c"}, {compare_exactly(a, b), compare_exactly(a, c)}};
  EXPECT_FALSE(exact.are_equal());
  EXPECT_THAT(to_text(exact), HasSubstr("b: equal: log_sha256"));
  EXPECT_THAT(to_text(exact), HasSubstr("charge: 0.5 in A, 0.6 in B"));
  const json answer = json::parse(to_json(exact));
  EXPECT_EQ(answer["runs"][0]["equal"], true);
  EXPECT_EQ(answer["runs"][1]["difference"]["column"], "charge");
}

}  // namespace
}  // namespace lsos
