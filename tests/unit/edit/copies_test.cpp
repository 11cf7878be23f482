// Days again, and another rover's events.
#include "edit/coordinates.h"
#include "edit/mirror.h"
#include "edit/repeat.h"
#include "edit_fixture.h"

#include "planet/body.h"

namespace lsos::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// A day: out, work, home; B waits for the work.
std::string a_day() {
  return mission() + rover("A", {{"OnFailure", "goto Home"}}) + rover("B") +
         event("Route", "out", "A", 10, {{"StartTime", "2026-07-01T08:00"}}, point("31.01,20")) +
         event("Pause", "work", "A", 20, {{"Duration", "60"}}, point("31.01,20")) +
         event("Route", "Home", "A", 30, {}, point("31,20")) +
         pause("wait", "B", 10, {{"StartAfter", "work"}, {"OnFailure", "goto end"}}) +
         pause("end", "B", 20);
}

Repetition all_of(const TestPlan& plan, int times) {
  Repetition repetition;
  for (const PlanEvent& event : plan.plan.events) repetition.events.push_back(&event);
  repetition.times = times;
  repetition.begins = plan.begins();
  return repetition;
}

TEST(Repeat, copies_a_day_with_its_references) {
  TestPlan plan(a_day());
  const Repeated repeated = repeat(plan.document, all_of(plan, 2), plan.days());
  EXPECT_EQ(repeated.count, 10);
  EXPECT_THAT(repeated.warnings, ElementsAre());
  const Plan edited = plan.edited();
  EXPECT_THAT(
      listed_events(edited),
      ElementsAre("A/10 Route 'out'", "A/20 Pause 'work'", "A/30 Route 'Home'",
                  "A/40 Route 'out (day 2)'", "A/50 Pause 'work (day 2)'", "A/60 Route 'Home'",
                  "A/70 Route 'out (day 3)'", "A/80 Pause 'work (day 3)'", "A/90 Route 'Home'",
                  "B/10 Pause 'wait'", "B/20 Pause 'end'", "B/30 Pause 'wait (day 2)'",
                  "B/40 Pause 'end (day 2)'", "B/50 Pause 'wait (day 3)'",
                  "B/60 Pause 'end (day 3)'"));
  EXPECT_EQ(format_utc(*edited.events[6].start_time), "2026-07-03T08:00:00.000Z");
  EXPECT_EQ(edited.events[6].go_to_sequence, 90) << "home on the same day";
  EXPECT_THAT(edited.events[13].start_after, ElementsAre(PlanEvent::Reference{"A", 80}));
  EXPECT_EQ(format_utc(*edited.events[13].start_time), "2026-07-03T00:00:00.000Z")
      << "days do not run into each other";
  EXPECT_EQ(edited.events[13].go_to_sequence, 60);
}

TEST(Repeat, leaves_what_it_does_not_copy_as_it_was) {
  TestPlan plan(a_day());
  repeat(plan.document, all_of(plan, 1), plan.days());
  const std::string text = plan.document.text();
  // All lines of the plan are there, in their order.
  std::istringstream lines(plan.text);
  std::size_t at = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t found = text.find(line, at);
    ASSERT_NE(found, std::string::npos) << line;
    at = found + line.size();
  }
}

TEST(Repeat, goes_to_other_places_in_their_order) {
  TestPlan plan(a_day());
  Repetition repetition = all_of(plan, 2);
  repetition.places = {"31.02,20.01", "31.03,20.02", "1,1"};
  repetition.places_file = "stops.kml";
  const Repeated repeated = repeat(plan.document, repetition, plan.days());
  EXPECT_THAT(repeated.warnings, ElementsAre("stops.kml: the last 1 of its 3 Points are not used"));
  const Plan edited = plan.edited();
  const auto lon = [&](std::size_t i) { return lon_deg(edited.events[i].geometry.points.front()); };
  EXPECT_NEAR(lon(3), 31.02, 1e-9);
  EXPECT_NEAR(lon(4), 31.02, 1e-9) << "the work is where the drive goes";
  EXPECT_NEAR(lon(5), 31, 1e-9) << "home stays";
  EXPECT_NEAR(lon(6), 31.03, 1e-9);
  TestPlan poor(a_day());
  Repetition wants_more = all_of(poor, 4);
  wants_more.places = repetition.places;
  wants_more.places_file = "stops.kml";
  try {
    repeat(poor.document, wants_more, poor.days());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("stops.kml: has 3 Points; 4 are wanted, for 1 different "
                                        "Points of the day, 4 times"));
  }
}

TEST(Repeat, of_a_part_says_what_is_left_out) {
  TestPlan plan(a_day() + pause("later", "A", 40, {{"StartTime", "2026-07-03"}}));
  Repetition repetition;
  repetition.events = {&plan.event("B", 10)};
  repetition.begins = plan.begins();
  EXPECT_THAT(
      repeat(plan.document, repetition, plan.days()).warnings,
      ElementsAre("B/30, a copy of 'wait': OnFailure = goto end is left out, as that is not "
                  "copied with it"));
  const Plan edited = plan.edited();
  EXPECT_THAT(edited.events.back().start_after, ElementsAre(PlanEvent::Reference{"A", 20}));
  TestPlan again(a_day() + pause("later", "A", 40, {{"StartTime", "2026-07-03"}}));
  repetition.events = {&again.event("A", 10)};
  EXPECT_THAT(repeat(again.document, repetition, again.days()).warnings,
              ElementsAre("rover 'A' has 1 events after day 1; the copies come behind them"));
}

TEST(Mirror, copies_events_for_another_rover) {
  TestPlan plan(a_day() + event("Follow", "f", "A", 40, {{"Leader", "B"}}));
  const Mirrored mirrored = mirror(plan.document, {"A", "B", {100, -50}});
  EXPECT_EQ(mirrored.count, 4);
  const Plan edited = plan.edited();
  EXPECT_THAT(
      listed_events(edited),
      ElementsAre("A/10 Route 'out'", "A/20 Pause 'work'", "A/30 Route 'Home'", "A/40 Follow 'f'",
                  "B/10 Pause 'wait'", "B/20 Pause 'end'", "B/30 Route 'out'", "B/40 Pause 'work'",
                  "B/50 Route 'Home'", "B/60 Follow 'f'"));
  EXPECT_EQ(std::get<std::string>(edited.events.back().params.at("leader")), "A");
  // What waited for A's work still does.
  EXPECT_THAT(edited.events[4].start_after, ElementsAre(PlanEvent::Reference{"A", 20}));
  const Geodetic& from = edited.events[0].geometry.points.front();
  const Geodetic& to = edited.events[6].geometry.points.front();
  EXPECT_NEAR(surface_distance_m(*plan.plan.mission.planet, from, to), std::hypot(100, 50), 0.01);
  EXPECT_GT(lon_deg(to), lon_deg(from));
  EXPECT_LT(lat_deg(to), lat_deg(from));
}

TEST(Mirror, renames_labels_that_have_the_rover_as_a_word) {
  TestPlan plan(mission() + rover("SEV1") + rover("SEV2") + pause("SEV1 rests, SEV1", "SEV1", 10) +
                pause("SEV10 and SEV1's rest", "SEV1", 20) + pause("XSEV1", "SEV1", 30));
  mirror(plan.document, {"SEV1", "SEV2"});
  EXPECT_THAT(
      listed_events(plan.edited()),
      ElementsAre("SEV1/10 Pause 'SEV1 rests, SEV1'", "SEV1/20 Pause 'SEV10 and SEV1's rest'",
                  "SEV1/30 Pause 'XSEV1'", "SEV2/10 Pause 'SEV2 rests, SEV2'",
                  "SEV2/20 Pause 'SEV10 and SEV2's rest'", "SEV2/30 Pause 'XSEV1'"));
}

TEST(Mirror, swaps_both_rovers_in_labels) {
  TestPlan plan(mission() + rover("SEV1") + rover("SEV2") + rover("SEV1-B") +
                pause("SEV1 meets SEV2", "SEV1", 10) + pause("SEV1-B calls SEV2", "SEV1", 20) +
                pause("SEV1-C, SEV1\u2019s \u2013SEV1\u2013", "SEV1", 30));
  mirror(plan.document, {"SEV1", "SEV2"});
  const Plan edited = plan.edited();
  ASSERT_EQ(edited.events.size(), 6);
  EXPECT_EQ(edited.events[3].label, "SEV2 meets SEV1");
  EXPECT_EQ(edited.events[4].label, "SEV1-B calls SEV1");
  EXPECT_EQ(edited.events[5].label, "SEV2-C, SEV2\u2019s \u2013SEV2\u2013");
}

TEST(Mirror, takes_letters_of_any_script_for_parts_of_words) {
  TestPlan plan(mission() + rover("Mar") + rover("SEV2") + pause("Mar\u00e9e haute", "Mar", 10) +
                pause("\u00e9Mar, Mar", "Mar", 20));
  mirror(plan.document, {"Mar", "SEV2"});
  EXPECT_THAT(listed_events(plan.edited()),
              ElementsAre("Mar/10 Pause 'Mar\u00e9e haute'", "Mar/20 Pause '\u00e9Mar, Mar'",
                          "SEV2/10 Pause 'Mar\u00e9e haute'", "SEV2/20 Pause '\u00e9Mar, SEV2'"));
}

TEST(Mirror, leaves_labels_where_an_id_is_one_letter) {
  TestPlan plan(mission() + rover("SEV1") + rover("B") + pause("SEV1 tries plan B", "SEV1", 10) +
                pause("B", "B", 10));
  mirror(plan.document, {"SEV1", "B"});
  EXPECT_EQ(plan.edited().events.back().label, "SEV1 tries plan B");
}

TEST(Coordinates, move_with_their_altitudes_and_blanks) {
  const Body& moon = *find_body("Moon");
  EXPECT_EQ(moved_coordinates("31.0,20 \n 31.5 , 20.5,7", moon, {0, 0}),
            "31.000000000,20.000000000 \n 31.500000000,20.500000000,7");
  const std::string moved = moved_coordinates("0,0,3 0,0", moon, {1000, 0});
  EXPECT_THAT(moved, HasSubstr("0.032"));
  EXPECT_EQ(moved.find(",3 "), moved.find(' ') - 2);
}

TEST(Repeat, leads_the_ends_of_lines_to_other_places) {
  const auto drawn = [](const std::string& name, std::int64_t sequence, const std::string& places) {
    return event("Route", name, "A", static_cast<int>(sequence), {}, line(places));
  };
  TestPlan plan(mission() + rover("A") + drawn("out", 10, "31,20 31.01,20") +
                event("Pause", "work", "A", 20, {{"Duration", "60"}}, point("31.01,20")) +
                drawn("home", 30, "31.01,20 31.005,20.001 31,20") +
                drawn("round", 40, "31,20 31,20.001 31.0001,20"));
  Repetition repetition = all_of(plan, 1);
  repetition.places = {"31.02,20.01"};
  repetition.places_file = "stops.kml";
  const Repeated repeated = repeat(plan.document, repetition, plan.days());
  EXPECT_THAT(repeated.warnings,
              ElementsAre("Route 'home': the ends of its copies' lines follow the places, what is "
                          "drawn between them stays",
                          "Route 'round': its copies stay where it is drawn, as its line does not "
                          "begin or end at one of the day's Points"));
  const Plan edited = plan.edited();
  const auto lons = [&](std::size_t i) {
    std::vector<double> all;
    for (const Geodetic& at : edited.events[i].geometry.points) {
      all.push_back(std::round(lon_deg(at) * 1e6) / 1e6);
    }
    return all;
  };
  EXPECT_THAT(lons(4), ElementsAre(31, 31.02));
  EXPECT_THAT(lons(5), ElementsAre(31.02));
  EXPECT_THAT(lons(6), ElementsAre(31.02, 31.005, 31));
  EXPECT_THAT(lons(7), ElementsAre(31, 31, 31.0001));
}

TEST(Repeat, puts_days_in_their_order) {
  TestPlan plan(a_day());
  repeat(plan.document, all_of(plan, 2), plan.days());
  const std::string text = plan.document.text();
  EXPECT_LT(text.find("work (day 2)"), text.find("work (day 3)"));
}

}  // namespace
}  // namespace lsos::test
