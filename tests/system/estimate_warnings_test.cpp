// What `check` warns of by its estimate: stops in the dark, antennas that reach nobody, WarnWhen
// that holds, events that never start. One warning a stretch, and none where nothing is wrong.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "system/plan_run.h"
#include "system/source_files.h"

namespace lsos::test {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ContainsRegex;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

// Earth is never seen from the far side, and always from the near one.
constexpr const char *far_side = "180,12", *near_side = "31,12";
// There the Sun is down from the start on for days.
constexpr const char* night = "-149,12";
constexpr const char* no_earth = "not sees('Earth')";

std::vector<std::string> warnings(const std::vector<Mark>& plan) {
  const TempFolder folder;
  const Outcome outcome =
      run({"check", folder.write("checked.kml", kml(plan)), "--json", "--quiet"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  std::vector<std::string> all;
  const json answer = json::parse(outcome.out);
  for (const json& fault : answer.at("faults")) all.push_back(fault.at("what"));
  return all;
}

Mark pause(int sequence, const std::string& duration, const Fields& more = {}) {
  Fields fields{{"Duration", duration}};
  fields.insert(fields.end(), more.begin(), more.end());
  return event("Pause", "A", sequence, fields);
}

TEST(EstimateWarnings, tell_of_a_night_in_which_the_charge_falls_below_the_reserve_once) {
  EXPECT_THAT(warnings({mission(), sev("A", night), pause(1, "20 h"), pause(2, "22 h")}),
              ElementsAre(AllOf(
                  HasSubstr("Pause 'Pause 1': by the estimate no Sun reaches the panels of A from "
                            "2026-01-01T00:00:00"),
                  HasSubstr("its charge falls from 100 % to"), HasSubstr("below its reserve of 10"),
                  HasSubstr("a place or time in the Sun, a Recharge or less load helps"))));
}

TEST(EstimateWarnings, tell_of_panels_that_are_stowed) {
  EXPECT_THAT(warnings({mission(), sev("A", near_side), event("StowSP", "A", 1), pause(2, "40 h")}),
              ElementsAre(HasSubstr("all its panels are stowed: a DeploySP before")));
}

TEST(EstimateWarnings, tell_nothing_of_darkness_that_the_battery_bears) {
  EXPECT_THAT(warnings({mission(), sev("A", near_side), event("StowSP", "A", 1), pause(2, "6 h"),
                        event("DeploySP", "A", 3), pause(4, "10 h")}),
              IsEmpty());
}

TEST(EstimateWarnings, tell_of_an_antenna_that_reaches_nobody) {
  EXPECT_THAT(warnings({mission(), sev("A", far_side), event("DeployCA", "A", 1), pause(2, "2 h"),
                        event("StowCA", "A", 3), event("DeployCA", "A", 4), pause(5, "1 h")}),
              ElementsAre(AllOf(HasSubstr("DeployCA 'DeployCA 1': by the estimate antenna"),
                                HasSubstr("sees neither Earth nor another end that it reaches"),
                                HasSubstr("so it is once more until 2026-01-01T03:"))));
}

TEST(EstimateWarnings, look_at_an_antenna_for_as_long_as_the_mission_lasts) {
  // A mast that the last event raises is there for what others do then; without them it has no use.
  const std::vector<Mark> one{mission(), sev("A", far_side), pause(1, "1 h"),
                              event("DeployCA", "A", 2)};
  EXPECT_THAT(warnings(one), IsEmpty());
  std::vector<Mark> two = one;
  two.push_back(sev("B", "-179,12"));  // 30 km away, beyond the horizon
  two.push_back(event("Pause", "B", 1, {{"Duration", "3 h"}}));
  EXPECT_THAT(warnings(two),
              ElementsAre(AllOf(HasSubstr("DeployCA 'DeployCA 2': by the estimate antenna"),
                                HasSubstr(" to 2026-01-01T03:00:00.000Z and sees neither Earth"))));
}

TEST(EstimateWarnings, tell_nothing_of_an_antenna_that_sees_earth_or_an_asset) {
  EXPECT_THAT(
      warnings({mission(), sev("A", near_side), event("DeployCA", "A", 1), pause(2, "2 h")}),
      IsEmpty());
  const Mark base{"Asset", {{"AssetId", "Base"}, {"AssetType", "Habitat"}}, point("180.003,12")};
  EXPECT_THAT(
      warnings({mission(), sev("A", far_side), base, event("DeployCA", "A", 1), pause(2, "2 h")}),
      IsEmpty());
}

TEST(EstimateWarnings, tell_of_warn_when_once_a_stretch_though_several_events_have_it) {
  EXPECT_THAT(warnings({mission(), sev("A", far_side), pause(1, "2 h", {{"WarnWhen", no_earth}}),
                        pause(2, "2 h", {{"WarnWhen", no_earth}})}),
              ElementsAre(HasSubstr("Pause 'Pause 1': by the estimate WarnWhen holds from "
                                    "2026-01-01T00:00:00.000Z on for 4.0 h: not sees('Earth'); "
                                    "another place or time, a DeployCA or an asset that relays "
                                    "helps")));
  EXPECT_THAT(warnings({mission(), sev("A", near_side), pause(1, "2 h", {{"WarnWhen", no_earth}})}),
              IsEmpty());
}

TEST(EstimateWarnings, tell_of_no_sight_to_an_asset_where_it_is_asked_for) {
  const auto with_base_at = [](const std::string& place) {
    return std::vector<Mark>{
        mission(), sev("A", near_side),
        Mark{"Asset", {{"AssetId", "Base"}, {"AssetType", "Habitat"}}, point(place)},
        pause(1, "2 h", {{"WarnWhen", "not sees('Base')"}})};
  };
  EXPECT_THAT(warnings(with_base_at("31.5,12")),  // 15 km away, beyond the horizon
              ElementsAre(HasSubstr("WarnWhen holds from 2026-01-01T00:00:00.000Z on for")));
  EXPECT_THAT(warnings(with_base_at("31.005,12")), IsEmpty());
}

TEST(EstimateWarnings, tell_of_an_event_that_never_starts) {
  EXPECT_THAT(warnings({mission({{"MaxDuration", "3 d"}}), sev("A", near_side), pause(1, "1 h"),
                        pause(2, "1 h", {{"StartWhen", "not sees('Earth')"}})}),
              ElementsAre(AllOf(HasSubstr("Pause 'Pause 2': by the estimate its turn comes at "
                                          "2026-01-01T01:00:00"),
                                HasSubstr("and it never starts: MaxDuration is over; it waited "
                                          "for StartWhen: not sees('Earth')"))));
}

// Those that tell of a rover's panels, antenna or battery, and of it alone.
std::vector<std::string> lacks_of(const std::string& rover, const std::vector<std::string>& all) {
  std::vector<std::string> lacks;
  for (const std::string& each : all) {
    if (each.find(" of " + rover + " is") != std::string::npos ||
        each.find("panels of " + rover + " from") != std::string::npos) {
      lacks.push_back(each);
    }
  }
  return lacks;
}

TEST(EstimateWarnings, tell_of_rovers_that_wait_in_vain_what_for_and_once_of_a_low_charge) {
  const auto until_near = [](const char* rover, const char* other, int sequence) {
    return event(
        "Pause", rover, sequence,
        {{"Duration", "60"}, {"StartWhen", std::string("distance_to('") + other + "') &lt; 10"}});
  };
  // The antenna of A reaches nobody either, which it need not hear while it waits.
  const std::vector<std::string> all =
      warnings({mission({{"MaxDuration", "60 d"}}), sev("A", night), sev("B", "-149,12.002"),
                sev("C", "-149,12.5"), event("DeployCA", "A", 1), until_near("A", "B", 2),
                until_near("B", "A", 1), event("Pause", "C", 1, {{"Duration", "50 d"}})});
  const auto never = HasSubstr("and it never starts: MaxDuration is over; it waited for StartWhen");
  EXPECT_THAT(all, Contains(AllOf(HasSubstr("Pause 'Pause 2'"), never,
                                  HasSubstr("distance_to('B') < 10"))));
  EXPECT_THAT(all, Contains(AllOf(HasSubstr("Pause 'Pause 1'"), never,
                                  HasSubstr("distance_to('A') < 10"))));
  for (const char* rover : {"A", "B"}) {
    EXPECT_THAT(lacks_of(rover, all),
                ElementsAre(AllOf(HasSubstr("below its reserve"), Not(HasSubstr("; so it is"))),
                            AllOf(HasSubstr("the battery of "), Not(HasSubstr("; so it is")))));
  }
  EXPECT_THAT(lacks_of("C", all), ElementsAre(HasSubstr("; so it is"), HasSubstr("; so it is")))
      << "C has two nights";
}

TEST(EstimateWarnings, tell_of_a_low_charge_that_is_why_a_rover_waits_in_vain) {
  const Mark a{
      "Rover", {{"RoverId", "A"}, {"RoverType", "SEV"}, {"InitialCharge", "0.9"}}, point(night)};
  const auto check = [&](const char* field, const char* value) {
    return warnings({mission({{"MaxDuration", "5 d"}}), a, sev("C", "-149,12.1"), pause(1, "60"),
                     pause(2, "60", {{field, value}}),
                     event("Pause", "C", 1, {{"Duration", "4 d"}})});
  };
  const auto low = ElementsAre(HasSubstr("below its reserve"), HasSubstr("the battery of A is"));
  const std::vector<std::string> charge = check("StartWhen", "charge &gt; 0.95");
  EXPECT_THAT(charge, Contains(HasSubstr("it waited for StartWhen: charge > 0.95")));
  EXPECT_THAT(lacks_of("A", charge), low);
  // The plan's own faults tell that this time never comes.
  const std::vector<std::string> time = check("StartTime", "2026-01-10T00:00:00Z");
  EXPECT_THAT(time, Contains(HasSubstr("it never comes")));
  EXPECT_THAT(lacks_of("A", time), low);
}

TEST(EstimateWarnings, leave_nothing_out_of_an_estimate_that_is_cut_short) {
  // The time that A waits for comes in a run, 115 days after all else.
  const std::vector<std::string> all =
      warnings({mission(), sev("A", night), sev("C", "-149,12.1"), pause(1, "60"),
                pause(2, "60", {{"StartTime", "2026-05-01T00:00:00Z"}}),
                event("Pause", "C", 1, {{"Duration", "5 d"}})});
  EXPECT_THAT(all, Contains(HasSubstr("the estimate ends before the mission does")));
  EXPECT_THAT(lacks_of("A", all),
              ElementsAre(AllOf(HasSubstr("below its reserve"), HasSubstr("; so it is")),
                          AllOf(HasSubstr("is empty at 2026-01-02T"), HasSubstr("; so it is"))));
}

TEST(EstimateWarnings, tell_of_a_rover_that_stands_where_another_goes) {
  const auto plan_to = [](const std::string& place_of_b) {
    return std::vector<Mark>{mission(),
                             sev("A", "31,12"),
                             sev("B", "31.002,12"),
                             event("Route", "A", 1, {}, point("31.001,12")),
                             event("Pause", "B", 1, {{"Duration", "10 min"}}),
                             event("Route", "B", 2, {}, point(place_of_b))};
  };
  EXPECT_THAT(warnings(plan_to("31.001,12")),
              ElementsAre(AllOf(HasSubstr("Route 'Route 2': by the estimate A stands where it ends "
                                          "at 2026-01-01T00:"),
                                HasSubstr("give each a place of its own"))));
  EXPECT_THAT(warnings(plan_to("31.0015,12")), IsEmpty());
}

TEST(EstimateWarnings, tell_of_half_of_the_charge_lost_though_the_reserve_is_left) {
  EXPECT_THAT(warnings({mission(), sev("A", night), pause(1, "30 h")}),
              ElementsAre(AllOf(HasSubstr("its charge falls from 100 % to 34 %; a place or time"),
                                Not(HasSubstr("below its reserve")))));
}

// An LRV has no panels, and its loads go on while it waits.
Mark lrv(const std::string& charge) {
  return Mark{"Rover",
              {{"RoverId", "L"}, {"RoverType", "LRV"}, {"InitialCharge", charge}},
              point("31.01,12")};
}

TEST(EstimateWarnings, tell_of_a_battery_that_is_empty_between_events_or_after_the_last) {
  const auto pause_of_l = [](int sequence, const Fields& more) {
    Fields fields{{"Duration", "1 min"}};
    fields.insert(fields.end(), more.begin(), more.end());
    return event("Pause", "L", sequence, fields);
  };
  EXPECT_THAT(
      warnings({mission(), lrv("0.3"), pause_of_l(1, {}),
                pause_of_l(2, {{"StartTime", "2026-01-20T00:00:00Z"}})}),
      ElementsAre(
          AllOf(HasSubstr("Pause 'Pause 1': by the estimate the battery of L is empty at 2026-01-"),
                HasSubstr(", before 'Pause 2' begins; a Recharge before"))));
  EXPECT_THAT(warnings({mission(), sev("A", near_side), lrv("0.3"), pause_of_l(1, {}),
                        pause(1, "100 h"), pause(2, "100 h")}),
              Contains(AllOf(HasSubstr("the battery of L is empty at 2026-01-"),
                             HasSubstr(", after its last event;"))));
}

TEST(EstimateWarnings, tell_of_an_event_that_fails_before_it_begins) {
  EXPECT_THAT(warnings({mission(), lrv("0.05"), event("Pause", "L", 1, {{"Duration", "6 h"}}),
                        event("Route", "L", 2, {}, point("31.011,12")),
                        event("Pause", "L", 3, {{"Duration", "1 min"}})}),
              Contains(AllOf(HasSubstr("Route 'Route 2': by the estimate it fails at 2026-01-01T"),
                             HasSubstr(", before it begins: "),
                             HasSubstr("; 'Pause 3' then does not take place"))));
}

TEST(EstimateWarnings, tell_of_a_timeout_and_of_what_does_not_take_place_then) {
  EXPECT_THAT(
      warnings({mission(), sev("A", near_side), pause(1, "2 h", {{"Timeout", "1 h"}}),
                pause(2, "1 h"), pause(3, "1 h")}),
      Contains(HasSubstr(
          "Pause 'Pause 1': by the estimate it fails at 2026-01-01T01:00:00.000Z: "
          "timed out after 3600 s; 3600 s of it were left; 'Pause 2' and 1 more then do not "
          "take place")));
}

TEST(EstimateWarnings, tell_of_stop_when_only_where_it_is_not_meant) {
  const auto stopped = [](const char* rule) {
    return warnings({mission(), sev("A", near_side),
                     pause(1, "2 h", {{"StopWhen", "time_s &gt; 600"}, {"OnFailure", rule}}),
                     pause(2, "1 h")});
  };
  EXPECT_THAT(stopped("stop"),
              ElementsAre(AllOf(HasSubstr("StopWhen: time_s > 600; "),
                                HasSubstr("; 'Pause 2' then does not take place"))));
  EXPECT_THAT(stopped("skip"), IsEmpty());
}

TEST(EstimateWarnings, tell_of_what_max_duration_cuts_off) {
  EXPECT_THAT(warnings({mission({{"MaxDuration", "90 min"}}), sev("A", near_side), pause(1, "1 h"),
                        pause(2, "1 h"), pause(3, "1 h")}),
              Contains(AllOf(HasSubstr("Pause 'Pause 2': by the estimate it is cut off at "
                                       "2026-01-01T01:30:00.000Z: MaxDuration is over"),
                             HasSubstr("; 'Pause 3' then does not take place"))));
}

TEST(EstimateWarnings, name_the_event_in_which_the_reserve_is_crossed) {
  EXPECT_THAT(
      warnings({mission(), sev("A", night), pause(1, "20 h"), pause(2, "22 h")}),
      ElementsAre(ContainsRegex("below its reserve of 10 % at 2026-01-02T[0-9:.]+Z, with or "
                                "after 'Pause 2'")));
}

TEST(EstimateWarnings, are_none_of_a_plan_with_errors_which_are_told_in_one_go_and_say_so) {
  const TempFolder folder;
  // A waits for B, which waits for A; its way leads where no slope is allowed; time goes back.
  const Mark at_pole{
      "MissionInfo",
      {{"Planet", "Moon"}, {"StartTime", "2026-01-01T00:00:00Z"}, {"Terrain", "LunarSouthPole"}},
      ""};
  const std::string plan = folder.write(
      "plan.kml",
      kml({at_pole, sev("A", "46.332,-89.8434"), sev("B", "46.35,-89.8434"),
           event("PathPlanRoute", "A", 1, {{"MaxSlope", "1"}}, point("46.30,-89.8439")),
           event("Pause", "A", 2, {{"Duration", "1"}, {"StartTime", "2026-01-02T00:00:00Z"}}),
           event("Pause", "A", 3, {{"Duration", "1"}, {"StartTime", "2026-01-01T10:00:00Z"}}),
           event("Pause", "A", 4, {{"Duration", "1"}, {"StartAfter", "B/1"}}),
           event("Pause", "B", 1, {{"Duration", "1"}, {"StartAfter", "A/4"}})}));
  const Outcome outcome = run({"check", plan, "--quiet"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.out, HasSubstr("Rover 'B': is placed where 'A' stands"));
  EXPECT_THAT(outcome.out, HasSubstr("the goal is on a slope of 10 degrees, 1 are allowed"));
  EXPECT_THAT(outcome.out, HasSubstr("'Pause 2' comes first by its Sequence, and starts at"));
  EXPECT_THAT(outcome.out, HasSubstr("StartAfter goes in a circle"));
  EXPECT_THAT(outcome.out,
              HasSubstr("the plan has errors: it is not estimated what its events take"));
}

TEST(EstimateWarnings, leave_out_routes_that_other_faults_leave_open) {
  const TempFolder folder;
  const Mark at_pole{
      "MissionInfo",
      {{"Planet", "Moon"}, {"StartTime", "2026-01-01T00:00:00Z"}, {"Terrain", "LunarSouthPole"}},
      ""};
  const auto route = [&](const char* rover, int sequence, const char* speed) {
    return event("PathPlanRoute", rover, sequence, {{"MaxSlope", "1"}, {"Speed", speed}},
                 point("46.30,-89.8439"));
  };
  const auto check = [&](const char* rover, const char* speed) {
    const std::string plan = folder.write(
        "plan.kml", kml({at_pole, sev("A", "46.332,-89.8434"), sev("B", "46.35,-89.8434"),
                         event("Pause", "A", 1, {{"Duration", "-1"}}), route("A", 2, "2 km/h"),
                         route(rover, 1, speed), route("B", 2, "3 km/h")}));
    return run({"check", plan, "--quiet"}).out;
  };
  const std::string of_a =
      "'PathPlanRoute 2': the leg to waypoint 1: the goal is on a slope of 10 degrees";
  const std::string out = check("B", "fast");
  EXPECT_THAT(out, HasSubstr("Duration = -1"));
  EXPECT_THAT(out, HasSubstr("Speed = 'fast'"));
  EXPECT_THAT(out, HasSubstr(of_a));
  // B's second leg begins where its first ends, whose Speed is not known.
  EXPECT_EQ(out.find(of_a), out.rfind(of_a)) << out;
  EXPECT_THAT(out, Not(HasSubstr("'PathPlanRoute 1': the leg")));
  EXPECT_THAT(check("B", "2 km/h"), HasSubstr("'PathPlanRoute 1': the leg"));
  // Whose leg the other one is cannot be told.
  EXPECT_THAT(check("C", "2 km/h"), Not(HasSubstr("on a slope")));
}

TEST(EstimateWarnings, are_told_in_one_go_with_other_warnings) {
  EXPECT_THAT(warnings({mission(), sev("A", near_side), event("DeploySP", "A", 1),
                        event("StowSP", "A", 2), pause(3, "40 h")}),
              ElementsAre(HasSubstr("nothing is done"), HasSubstr("all its panels are stowed")));
}

}  // namespace
}  // namespace lsos::test
