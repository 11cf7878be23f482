// What breaks of a rover, through the whole program: plan, checks, log, figure.
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "system/energy_balance.h"
#include "system/plan_run.h"

namespace lsos::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

Mark rover() {
  return {"Rover",
          {{"RoverId", "R"}, {"RoverType", "SEV"}, {"InitialCharge", "0.9"}},
          point("30,10")};  // in sunshine
}

// Each kind of fault, on the way and at rest, and its repair.
std::vector<Mark> all_that_breaks() {
  const auto fault = [](int sequence, Fields fields) {
    return event("Fault", "R", sequence, fields);
  };
  return {mission({{"LogInterval", "1"}, {"ParkedLogInterval", "10"}}),
          rover(),
          event("DeployCA", "R", 1),
          event("Route", "R", 2, {}, point("30.002,10")),
          event("Pause", "R", 3, {{"Duration", "200"}}),
          fault(10, {{"What", "wheel"}, {"Part", "front_left_wheel_1"}, {"At", "50"}}),
          fault(11, {{"What", "wheel"},
                     {"Mode", "free"},
                     {"Part", "rear_left_wheel_1"},
                     {"At", "2026-01-01T00:00:51Z"}}),
          fault(12, {{"What", "steering"}, {"Part", "front_right_steering"}, {"At", "52"}}),
          fault(13, {{"What", "antenna"}, {"At", "53"}}),
          fault(14, {{"What", "battery"}, {"Share", "0.4"}, {"At", "54.03"}}),
          fault(15, {{"What", "panel"}, {"Share", "50 %"}, {"At", "55"}}),
          fault(16, {{"What", "panel"}, {"Mode", "stuck"}, {"At", "PT56S"}}),
          fault(20, {{"What", "wheel"}, {"Repair", "true"}, {"At", "70"}}),
          fault(21, {{"What", "steering"}, {"Repair", "true"}, {"At", "71"}}),
          fault(22, {{"What", "antenna"}, {"Repair", "true"}, {"At", "4 min"}}),
          fault(23, {{"What", "battery"}, {"Repair", "true"}, {"At", "4 min"}}),
          fault(24, {{"What", "panel"}, {"Repair", "true"}, {"At", "4 min"}})};
}

TEST(Faults, are_logged_and_warned_of_and_the_rover_goes_on) {
  const PlanRun run(all_that_breaks());
  EXPECT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
  expect_closed(run.samples());
  const json summary = run.summary();
  for (const json& event : summary["events"]) EXPECT_EQ(event["status"], "completed") << event;
  const auto event = [&](int sequence) {
    return *std::ranges::find_if(summary["events"],
                                 [&](const json& each) { return each["sequence"] == sequence; });
  };
  EXPECT_EQ(event(14)["start_s"], 54.1);
  EXPECT_EQ(event(14)["end_s"], 54.1);
  std::vector<std::string> notes;
  for (const NoteRow& note : run.log().notes()) {
    if (note.name == "fault") notes.push_back(note.fields_json);
  }
  ASSERT_EQ(notes.size(), 12u);
  EXPECT_EQ(notes[0], R"({"mode":"locked","part":"front_left_wheel_1","repair":false,"share":null,)"
                      R"("what":"wheel"})");
  EXPECT_EQ(notes[4], R"({"mode":null,"part":null,"repair":false,"share":0.4,"what":"battery"})");
  EXPECT_EQ(notes[11], R"({"mode":null,"part":null,"repair":true,"share":null,"what":"panel"})");
  const std::string warnings = summary["warnings"].dump();
  EXPECT_THAT(warnings, HasSubstr("R: wheel 'front_left_wheel_1': locked, from 50 s on"));
  EXPECT_THAT(warnings, HasSubstr("R: battery: 40 % of its capacity lost, from 54.1 s on"));
  EXPECT_THAT(warnings, HasSubstr("R: all antennas: dead, from 53 s on"));
}

TEST(Faults, repeat_and_survive_being_saved) {
  const std::string digest = digest_of(TempFolder(), all_that_breaks());
  EXPECT_EQ(digest_of(TempFolder(), all_that_breaks(), {"--threads", "2"}), digest);
  EXPECT_EQ(digest_of(TempFolder(), all_that_breaks(), {"--save-every-exchange"}), digest);
  std::vector<Mark> backwards = all_that_breaks();
  std::ranges::reverse(backwards);
  EXPECT_EQ(digest_of(TempFolder(), backwards), digest);
}

TEST(Faults, of_limbs_repeat_and_survive_being_saved) {
  const Fields limb{{"What", "limb"}, {"Part", "limb_2"}, {"At", "30"}};
  const std::vector<Mark> plan{
      mission(),
      {"Rover", {{"RoverId", "R"}, {"RoverType", "ATHLETE"}}, point("30,10")},
      event("SetPosture", "R", 1, {{"Stance", "Tall"}}),
      event("Route", "R", 2, {}, point("30.0008,10")),
      event("Fault", "R", 3, limb),
      event("Fault", "R", 4, {{"What", "steering"}, {"At", "34"}}),
      event("Fault", "R", 5, {{"What", "limb"}, {"Repair", "1"}, {"At", "36"}})};
  const std::string digest = digest_of(TempFolder(), plan);
  EXPECT_EQ(digest_of(TempFolder(), plan, {"--save-every-exchange"}), digest);
}

TEST(Faults, are_described_by_list) {
  EXPECT_THAT(run({"list", "events", "Fault"}).out,
              HasSubstr("  At               moment - UTC, or "));
}

TEST(Faults, are_listed_by_check_and_drawn_by_fsm) {
  const TempFolder folder;
  const std::string plan = folder.write("plan.kml", kml(all_that_breaks()));
  EXPECT_THAT(run({"check", plan}).out,
              HasSubstr("at a time: R 'Fault 14' at 2026-01-01T00:00:54.030Z, 54.03 s after the "
                        "start, whatever it does then"));
  const json checked = json::parse(run({"check", plan, "--json"}).out);
  ASSERT_EQ(checked["timed_events"].size(), 12u);
  EXPECT_EQ(checked["timed_events"][0]["at_s"], 50);
  const std::string dot = run({"fsm", plan}).out;
  EXPECT_THAT(dot, HasSubstr("initialise -> \"R/1\" -> \"R/2\" -> \"R/3\" -> terminate"));
  EXPECT_THAT(dot, HasSubstr("initialise -> \"R/14\" [style=dotted, label=\"at 54.03 s\"]"));
}

// The mission does not wait for what would break later, and says so.
TEST(Faults, after_the_last_event_have_not_started) {
  const PlanRun run({mission(), rover(), event("Pause", "R", 1, {{"Duration", "60"}}),
                     event("Fault", "R", 2, {{"What", "antenna"}, {"At", "2 h"}})});
  EXPECT_EQ(run.outcome.exit_code, 1);
  const json event = run.summary()["events"][1];
  EXPECT_EQ(event["status"], "not_started");
  EXPECT_EQ(event["reason"], "the mission was over at 60 s, before 7200 s");
}

}  // namespace
}  // namespace lsos::test
