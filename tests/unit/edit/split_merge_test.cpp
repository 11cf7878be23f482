// A plan taken apart by days, and plans put together.
#include "edit/merge.h"
#include "edit/split.h"
#include "edit_fixture.h"

namespace lsos::test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

std::string three_days() {
  return mission() + rover("A", {{"Heading", "90"}, {"OnFailure", "goto home"}}) + rover("B") +
         event("Route", "out", "A", 10, {}, line("31,20 31.01,20.01")) +
         pause("home", "A", 20, {{"StartTime", "2026-07-01T20:00"}}) +
         pause("day 2", "A", 30,
               {{"StartTime", "2026-07-02T08:00"}, {"StartAfter", "wait, B/20"}}) +
         pause("home", "A", 40, {{"StartTime", "2026-07-02T20:00"}}) +
         event("Fault", "broken", "A", 50, {{"At", "30 h"}}) + pause("wait", "B", 10) +
         pause("", "B", 20, {{"StartTime", "2026-07-02T06:00"}}) +
         pause("later", "B", 30, {{"StartTime", "2026-07-03T06:00"}});
}

SplitDays day_2(const TestPlan& plan) {
  return {2,
          {&plan.event("A", 30), &plan.event("A", 40), &plan.event("A", 50), &plan.event("B", 20)},
          {{"B", 0.6}}};
}

TEST(Split, keeps_a_day_and_begins_with_it) {
  TestPlan plan(three_days());
  const Split split = lsos::split(plan.document, day_2(plan), plan.days());
  EXPECT_EQ(split.left_out, 4);
  const Plan edited = plan.edited();
  EXPECT_THAT(listed_events(edited), ElementsAre("A/30 Pause 'day 2'", "A/40 Pause 'home'",
                                                 "A/50 Fault 'broken'", "B/20 Pause 'Pause 20'"));
  EXPECT_EQ(format_utc(edited.mission.start_time), "2026-07-02T00:00:00.000Z");
  EXPECT_EQ(format_utc(*edited.events[0].start_time), "2026-07-02T08:00:00.000Z");
  EXPECT_EQ(seconds(*edited.events[2].at), 6 * 3600) << "30 h from the start of the whole";
  EXPECT_NEAR(lon_deg(edited.rovers[0].start), 31.01, 1e-9) << "where the first day leads";
  EXPECT_FALSE(edited.rovers[0].heading_rad) << "it was that of the first day";
  EXPECT_EQ(edited.rovers[1].initial_charge, 0.6);
  EXPECT_THAT(edited.events[0].start_after, ElementsAre(PlanEvent::Reference{"B", 20}));
  EXPECT_THAT(split.warnings,
              ElementsAre("Pause 'day 2': StartAfter = wait is left out, with the event that it "
                          "names",
                          HasSubstr("Rover 'A': begins with the plan's InitialCharge of 1; "
                                    "--charge A=0.8 gives it another"),
                          HasSubstr("'run --from' begins with it")));
}

TEST(Split, rovers_begin_as_they_are_expected_to) {
  TestPlan plan(three_days());
  SplitDays days = day_2(plan);
  days.begins["A"] = {geodetic_from_degrees(31.02, 20.001),
                      -0.5,
                      0.73456789,
                      "broken",
                      {"panel 'Roof' is stowed", "resource 'oxygen' is at 3"}};
  const Geodetic home = plan.plan.rovers[1].start;
  days.begins["B"] = {home, 1, 0.9, "", {}};
  const Split split = lsos::split(plan.document, days, plan.days());
  const Plan edited = plan.edited();
  EXPECT_NEAR(lon_deg(edited.rovers[0].start), 31.02, 1e-9);
  EXPECT_NEAR(lat_deg(edited.rovers[0].start), 20.001, 1e-9);
  EXPECT_NEAR(*edited.rovers[0].heading_rad, 2 * std::numbers::pi - 0.5, 1e-4);
  EXPECT_NEAR(edited.rovers[0].initial_charge, 0.734568, 1e-9);
  EXPECT_EQ(edited.rovers[1].initial_charge, 0.6) << "as --charge has it";
  EXPECT_EQ(edited.rovers[1].start.lon_rad, home.lon_rad);
  EXPECT_THAT(split.warnings,
              ElementsAre(HasSubstr("StartAfter = wait is left out"),
                          "Rover 'A': 'broken' goes on when day 2 begins; the rover begins as that "
                          "ends",
                          "Rover 'A': panel 'Roof' is stowed, resource 'oxygen' is at 3 then, "
                          "which a plan cannot say; events at its beginning can make it so, or "
                          "'run --from' after a run of the days before"));
}

TEST(Split, warns_of_conditions_that_count_from_the_start) {
  TestPlan plan(mission() + rover("A") +
                pause("a", "A", 10,
                      {{"StartTime", "2026-07-02"}, {"StopWhen", "time_s > 9 or distance_m > 1"}}));
  const SplitDays days{2, {&plan.event("A", 10)}, {{"A", 1}}};
  EXPECT_THAT(lsos::split(plan.document, days, plan.days()).warnings,
              Contains("Pause 'a': its conditions name time_s, distance_m, which counts from the "
                       "mission's start, and that is later now"));
}

TEST(Split, of_the_first_day_changes_no_rover) {
  TestPlan plan(three_days());
  const SplitDays days{1, {&plan.event("A", 10), &plan.event("A", 20), &plan.event("B", 10)}, {}};
  EXPECT_THAT(lsos::split(plan.document, days, plan.days()).warnings, ElementsAre());
  const Plan edited = plan.edited();
  EXPECT_EQ(edited.rovers[0].heading_rad, plan.plan.rovers[0].heading_rad);
  EXPECT_EQ(edited.mission.start_time, plan.plan.mission.start_time);
}

TEST(Split, leaves_out_a_goto_of_a_rover_that_leads_nowhere) {
  TestPlan plan(three_days());
  const SplitDays days{2, {&plan.event("A", 30)}, {{"A", 1}, {"B", 1}}};
  EXPECT_THAT(lsos::split(plan.document, days, plan.days()).warnings,
              Contains("Rover 'A': OnFailure = goto home is left out, with the events that it "
                       "names"));
  plan.edited();
}

std::string asset(const std::string& id, const std::string& coordinates) {
  return placemark("", "#Asset", {{"AssetId", id}, {"AssetType", "Habitat"}}, point(coordinates));
}

class Merging : public ::testing::Test {
 protected:
  static TestPlan made(const std::string& placemarks, const std::string& head = "") {
    return TestPlan(placemarks, head);
  }
  static Merged merged(TestPlan& plan, TestPlan& other) {
    other.plan.file = "other.kml";
    return Merger(plan.document, {&other.document}).run();
  }
  static std::string refusal(TestPlan& plan, TestPlan& other) {
    try {
      merged(plan, other);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(Merging, takes_up_rovers_and_events_in_a_folder) {
  TestPlan plan(mission() + rover("A") + pause("work", "A", 10) +
                pause("rest", "A", 20, {{"StartAfter", "work"}}));
  TestPlan other(mission({{"LogInterval", "5"}, {"OnFailure", "skip"}}) + rover("B") +
                 pause("work", "B", 10) + pause("", "B", 20, {{"StartAfter", "work"}}) +
                 placemark("hill", "#hills", {}));
  const Merged merged = Merging::merged(plan, other);
  EXPECT_EQ(merged.rovers, 1);
  EXPECT_EQ(merged.events, 2);
  EXPECT_THAT(merged.warnings, ElementsAre("other.kml: LogInterval = 5 of its MissionInfo is not "
                                           "taken over; plan.kml has none"));
  const Plan edited = plan.edited();
  EXPECT_THAT(listed_events(edited), ElementsAre("A/10 Pause 'work'", "A/20 Pause 'rest'",
                                                 "B/10 Pause 'work'", "B/20 Pause 'Pause 20'"));
  EXPECT_THAT(edited.events[1].start_after, ElementsAre(PlanEvent::Reference{"A", 10}));
  EXPECT_THAT(edited.events[3].start_after, ElementsAre(PlanEvent::Reference{"B", 10}));
  EXPECT_EQ(edited.events[2].on_failure, OnFailure::skip) << "as its own MissionInfo said";
  EXPECT_EQ(edited.events[0].on_failure, OnFailure::stop);
  EXPECT_EQ(edited.decoration_count, 1);
  EXPECT_THAT(plan.document.text(), HasSubstr("<name>other</name>"));
}

TEST_F(Merging, takes_equal_styles_and_schemas_once) {
  const auto style = [](const std::string& id, const std::string& color) {
    return "<Style id=\"" + id + "\"><LineStyle><color>" + color + "</color></LineStyle></Style>\n";
  };
  const std::string schema =
      "<Schema id=\"Pause\" name=\"Pause\"><SimpleField type=\"string\" name=\"Duration\"/>";
  TestPlan plan(mission() + rover("A") + pause("a", "A", 10),
                style("s", "ff0000ff") + style("t", "ff0000ff") + schema + "</Schema>\n");
  const std::string placed = "<Placemark><name>way</name><styleUrl>#t</styleUrl></Placemark>\n";
  TestPlan other(mission() + rover("B") + pause("b", "B", 10) + placed,
                 style("s", "ff0000ff") + style("t", "ffff0000") + schema +
                     "<SimpleField type=\"string\" name=\"Timeout\"/></Schema>\n");
  merged(plan, other);
  plan.edited();
  const std::string text = plan.document.text();
  const auto count = [&](const std::string& part) {
    int found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
      ++found;
    }
    return found;
  };
  EXPECT_EQ(count("id=\"s\""), 1);
  EXPECT_EQ(count("id=\"t\""), 1);
  EXPECT_EQ(count("id=\"t-other\""), 1);
  EXPECT_EQ(count("<styleUrl>#t-other</styleUrl>"), 1);
  EXPECT_EQ(count("<Schema "), 1);
  EXPECT_EQ(count("name=\"Timeout\"/>"), 1);
  EXPECT_LT(text.find("t-other"), text.find("<Schema ")) << "where KML wants styles";
}

TEST_F(Merging, refuses_what_does_not_fit_and_says_what_to_do) {
  TestPlan plan(mission() + rover("A"));
  TestPlan same_rover(mission() + rover("A"));
  EXPECT_THAT(refusal(plan, same_rover),
              HasSubstr("rover 'A' is in plan.kml too; give it another RoverId"));
  TestPlan later(
      placemark("", "#MissionInfo",
                {{"Planet", "Moon"}, {"StartTime", "2026-07-02"}, {"Terrain", "Slope"}}) +
      rover("B"));
  const std::string text = refusal(plan, later);
  EXPECT_THAT(text, HasSubstr("StartTime is 2026-07-02T00:00:00.000Z, and "
                              "2026-07-01T00:00:00.000Z in plan.kml; 'edit shift' with "
                              "--by='-86400 s' moves the plan"));
  EXPECT_THAT(text, HasSubstr("Terrain is Slope, and Flat in plan.kml"));
}

TEST_F(Merging, takes_an_asset_of_both_once) {
  TestPlan plan(mission() + rover("A") + asset("Base", "31,20"));
  TestPlan other(mission() + rover("B") + asset("Base", "31.0,20") + asset("Far", "31,21"));
  merged(plan, other);
  EXPECT_EQ(plan.edited().assets.size(), 2u);
  TestPlan elsewhere(mission() + rover("B") + asset("Base", "31,20.1"));
  EXPECT_THAT(refusal(plan, elsewhere),
              HasSubstr("asset 'Base' is in plan.kml too, and is another there; give it another "
                        "AssetId in one of the plans, or make both equal"));
}

}  // namespace
}  // namespace lsos::test
