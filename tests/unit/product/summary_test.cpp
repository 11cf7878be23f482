// summary.json and the page for people.
#include "product/summary.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "base/files.h"
#include "unit/record/log_fixture.h"

namespace lsos {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

EventRow event_of(const std::string& rover_id, std::int64_t sequence, EventStatus status) {
  EventRow row = test_event();
  row.rover_id = rover_id;
  row.sequence = sequence;
  row.status = status;
  return row;
}

EventRow prevented(const std::string& rover_id, std::int64_t sequence) {
  EventRow row = event_of(rover_id, sequence, EventStatus::not_started);
  row.is_prevented = true;
  return row;
}

struct StatusCase {
  const char* what;
  std::vector<EventRow> events;
  RunStatus expected;
};

TEST(RunStatus, follows_the_events) {
  using enum EventStatus;
  const StatusCase cases[] = {
      {"no events", {}, RunStatus::completed},
      {"all completed", {event_of("A", 1, completed)}, RunStatus::completed},
      {"skipped and disabled count as completed",
       {event_of("A", 1, skipped), event_of("A", 2, disabled)},
       RunStatus::completed},
      {"one failed", {event_of("A", 1, completed), event_of("A", 2, failed)}, RunStatus::failed},
      {"a failure stopped the rover",
       {event_of("A", 1, failed), prevented("A", 2)},
       RunStatus::failed},
      {"not started for another reason than the failure before it",
       {event_of("A", 1, failed), event_of("A", 2, not_started)},
       RunStatus::incomplete},
      {"not started although nothing failed",
       {event_of("A", 1, completed), event_of("A", 2, not_started)},
       RunStatus::incomplete},
      {"not started although only another rover failed",
       {event_of("A", 1, failed), event_of("B", 1, not_started)},
       RunStatus::incomplete},
      {"a failure of one rover ended the mission of all",
       {event_of("A", 1, failed), prevented("B", 1)},
       RunStatus::failed},
      {"incomplete outweighs failed",
       {event_of("A", 1, failed), event_of("B", 1, incomplete)},
       RunStatus::incomplete},
      {"incomplete outweighs an abort",
       {prevented("A", 1), event_of("A", 2, failed), event_of("B", 1, incomplete)},
       RunStatus::incomplete},
      {"still running", {event_of("A", 1, running)}, RunStatus::incomplete},
      {"still waiting", {event_of("A", 1, waiting)}, RunStatus::incomplete},
  };
  for (const StatusCase& one : cases) {
    EXPECT_EQ(run_status(one.events), one.expected) << one.what;
  }
}

RunSummary test_summary() {
  RunSummary summary;
  summary.status = RunStatus::failed;
  summary.plan = "plans/a.kml";
  summary.log_sha256 = "abc";
  summary.start = *parse_utc("2026-07-01T12:00:00Z").value;
  summary.sim_s = 3600;
  summary.wall_s = 10;
  RoverSummary rover;
  rover.distance_m = 12.5;
  rover.duration_s = 3725;
  rover.drive_s = 60.25;
  rover.max_slip = 0.25;
  rover.p95_slip = 0.125;
  summary.rovers["SEV1"] = rover;
  EventRow event = event_of("SEV1", 10, EventStatus::failed);
  event.reason = "stuck";
  event.end = SimTime{90'100'000};
  summary.events = {event};
  summary.warnings = {"w"};
  summary.assumptions = {"no sun"};
  return summary;
}

TEST(Summary, has_the_keys_of_the_contract_in_its_order) {
  EXPECT_EQ(to_json(test_summary()), R"({
  "status": "failed",
  "plan": "plans/a.kml",
  "log_sha256": "abc",
  "sim_s": 3600.0,
  "wall_s": 10.0,
  "real_time_factor": 360.0,
  "rovers": {
    "SEV1": {
      "distance_m": 12.5,
      "duration_s": 3725.0,
      "drive_s": 60.25,
      "energy_start_j": null,
      "energy_end_j": null,
      "energy_used_j": null,
      "solar_j": null,
      "external_j": null,
      "elevation_gain_m": null,
      "max_slope_rad": null,
      "max_slip": 0.25,
      "p95_slip": 0.125,
      "resources": null
    }
  },
  "events": [
    {
      "rover_id": "SEV1",
      "sequence": 10,
      "type": "Route",
      "label": "Route 10",
      "status": "failed",
      "reason": "stuck",
      "ready_s": 0.0,
      "start_s": 0.1,
      "end_s": 90.1,
      "distance_m": null,
      "energy_used_j": null,
      "solar_j": null,
      "utc": "2026-07-01T12:00:00.100Z",
      "end_utc": "2026-07-01T12:01:30.100Z"
    }
  ],
  "warnings": [
    "w"
  ],
  "assumptions": [
    "no sun"
  ],
  "program": "lsos-host"
}
)");
}

TEST(Summary, lists_what_is_left_of_resources) {
  RunSummary summary = test_summary();
  summary.rovers["SEV1"].resources = {{"oxygen", 2.5}};
  EXPECT_THAT(to_json(summary), HasSubstr("\"oxygen\": 2.5"));
}

TEST(Summary, survives_text_that_is_no_utf8) {
  RunSummary summary = test_summary();
  summary.warnings = {"bad \xff byte"};
  EXPECT_THAT(to_json(summary), HasSubstr("bad \xef\xbf\xbd byte"));
}

TEST(Summary, is_known_again) {
  EXPECT_TRUE(is_summary(to_json(test_summary())));
  RunSummary large = test_summary();
  RoverSummary& rover = large.rovers.begin()->second;
  rover.resources = {{"data", 1e13}};
  rover.energy_used_j = 2e13;
  EXPECT_TRUE(is_summary(to_json(large))) << "only times have that limit";
  rover.resources = {{"dose_s", 1e13}};
  EXPECT_TRUE(is_summary(to_json(large))) << "a resource may be called as a time is";
  rover.duration_s = 1e13;
  EXPECT_FALSE(is_summary(to_json(large)));
  EXPECT_FALSE(is_summary(""));
  EXPECT_FALSE(is_summary("[1, 2"));
  EXPECT_FALSE(is_summary(R"({"program": "other", "log_sha256": "abc"})"));
  EXPECT_FALSE(is_summary(R"({"program": "lsos-host", "log_sha256": "abc"})")) << "parts lack";
  EXPECT_FALSE(is_summary(R"({"program": "lsos-host"})"));
}

TEST(Summary, is_written_whole) {
  const TestFolder folder;
  write_summary(folder.path(), test_summary());
  EXPECT_EQ(read_file(folder / "summary.json"), to_json(test_summary()));
  EXPECT_FALSE(read_file(folder / "summary.json.lsos-host.part"));
}

TEST(Summary, says_why_it_cannot_be_written) {
  const TestFolder folder;
  try {
    write_summary(folder / "none", test_summary());
    FAIL() << "a file was written into a folder that does not exist";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("none/summary.json: No such file or directory"));
  }
}

TEST(SummaryText, tells_people_the_main_figures) {
  const std::string text = to_text(test_summary());
  EXPECT_THAT(text, HasSubstr("plans/a.kml: failed\n"));
  EXPECT_THAT(text, HasSubstr("simulated 1 h 00 min in 10.0 s, 360 x real time\n"));
  EXPECT_THAT(text, ::testing::ContainsRegex("SEV1 +12.5 m +1 h 02 min +1 min 00 s\n"));
  EXPECT_THAT(text, ::testing::ContainsRegex("SEV1/10 +Route 10 +failed +1 min 30 s  stuck\n"));
  EXPECT_THAT(text, HasSubstr("0 of 1 events completed\n"));
  EXPECT_THAT(text, HasSubstr("1 warning\n"));
}

TEST(SummaryText, fits_on_a_screen) {
  RunSummary summary = test_summary();
  summary.events.clear();
  for (int i = 0; i < 100; ++i) {
    summary.events.push_back(event_of("SEV1", i, EventStatus::completed));
  }
  EXPECT_THAT(to_text(summary), Not(HasSubstr("SEV1/5 ")));
  EXPECT_THAT(to_text(summary), HasSubstr("100 of 100 events completed\n"));
  for (int i = 0; i < 30; ++i) summary.events[i].status = EventStatus::skipped;
  const std::string text = to_text(summary);
  EXPECT_THAT(text, HasSubstr("SEV1/5 "));
  EXPECT_THAT(text, HasSubstr("70 of 100 events completed; 14 more did not\n"));
  EXPECT_LE(std::ranges::count(text, '\n'), 24);
}

}  // namespace
}  // namespace lsos
