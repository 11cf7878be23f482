#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <numbers>
#include <random>

#include "plan_fixture.h"

namespace lsos {
namespace {

using test::document;
using test::event;
using test::line;
using test::mission;
using test::pause;
using test::placemark;
using test::point;
using test::rover;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double rad_per_deg = std::numbers::pi / 180;

struct Read {
  Plan plan;
  Faults faults;
};

Read read(const std::string& placemarks, const Declarations& known = test::declarations()) {
  Read result;
  result.plan = read_plan(test::write_file(document(placemarks)), known, result.faults);
  return result;
}

Plan good(const std::string& placemarks) {
  Read result = read(placemarks);
  EXPECT_EQ(test::faults_text(result.faults), "");
  return result.plan;
}

std::string faults_of(const std::string& plan) { return test::faults_text(read(plan).faults); }

TEST(PlanReader, reads_a_mission_in_si) {
  const Plan plan = good(mission({{"Seed", "7"},
                                  {"LogInterval", "500 ms"},
                                  {"ParkedLogInterval", "PT1M"},
                                  {"MaxDuration", "2 d"}}) +
                         rover());
  EXPECT_EQ(plan.mission.planet, find_body("Moon"));
  EXPECT_EQ(plan.mission.start_time, *parse_utc("2026-07-01T00:00:00Z").value);
  EXPECT_EQ(plan.mission.terrain.name, "Flat");
  EXPECT_FALSE(plan.mission.terrain.is_raster);
  EXPECT_EQ(plan.mission.seed, 7u);
  EXPECT_EQ(plan.mission.log_interval, from_seconds(0.5));
  EXPECT_EQ(plan.mission.parked_log_interval, from_seconds(60));
  EXPECT_EQ(plan.mission.max_duration, from_seconds(2 * 86400));
  EXPECT_TRUE(plan.defaults.empty() || !plan.defaults[0].starts_with("MissionInfo"));
}

TEST(PlanReader, fills_in_the_defaults_of_a_mission) {
  const Plan plan = good(mission({{"LogInterval", "4"}}) + rover());
  EXPECT_EQ(plan.mission.seed, 0u);
  EXPECT_EQ(plan.mission.parked_log_interval, from_seconds(60));
  EXPECT_FALSE(plan.mission.has_max_duration);
  EXPECT_THAT(plan.defaults,
              ElementsAre("MissionInfo: Seed = 0", "MissionInfo: ParkedLogInterval = 60 s",
                          "Rover 'A': InitialCharge = 1",
                          "Rover 'A': Heading = toward its first waypoint"));
}

TEST(PlanReader, a_parked_rover_is_logged_no_more_often_than_a_moving_one) {
  const Plan plan = good(mission({{"LogInterval", "2 min"}}) + rover());
  EXPECT_EQ(plan.mission.parked_log_interval, from_seconds(120));
}

TEST(PlanReader, a_raster_is_found_beside_the_plan) {
  const std::string raster = test::write_file("", "dem.tif");
  const std::string name = std::filesystem::path(raster).filename().string();
  std::string text = mission() + rover();
  text.replace(text.find("Flat"), 4, name);
  const Plan plan = good(text);
  EXPECT_TRUE(plan.mission.terrain.is_raster);
  EXPECT_TRUE(std::filesystem::equivalent(plan.mission.terrain.name, raster));
  EXPECT_EQ(plan.mission.terrain.as_written, name);
}

TEST(PlanReader, what_lies_beyond_a_raster_counts_in_the_hash) {
  const std::string raster = test::write_file("", "dem.tif");
  const std::string name = std::filesystem::path(raster).filename().string();
  const Plan plan = good(mission({{"TerrainBeyond", name}}) + rover());
  EXPECT_TRUE(plan.mission.terrain_beyond.is_raster);
  EXPECT_EQ(plan.mission.terrain_beyond.as_written, name);
  const Plan over_flat = good(mission({{"TerrainBeyond", "Flat"}}) + rover());
  EXPECT_FALSE(over_flat.mission.terrain_beyond.is_raster);
  EXPECT_NE(plan.hash(), good(mission() + rover()).hash());
  EXPECT_NE(plan.hash(), over_flat.hash());
}

TEST(PlanReader, a_raster_inside_an_archive_is_left_to_gdal) {
  std::string text = mission() + rover();
  text.replace(text.find("Flat"), 4, "/vsizip//maps/rim.zip/rim.tif");
  const Plan plan = good(text);
  EXPECT_TRUE(plan.mission.terrain.is_raster);
  EXPECT_EQ(plan.mission.terrain.name, "/vsizip//maps/rim.zip/rim.tif");
}

TEST(PlanReader, reads_rovers_in_byte_order_of_their_ids) {
  const Plan plan =
      good(mission() + rover("b") + rover("B") +
           rover("a", {{"Heading", "90"}, {"InitialCharge", "80 %"}, {"RoverConfig", "low"}}));
  ASSERT_EQ(plan.rovers.size(), 3u);
  EXPECT_EQ(plan.rovers[0].id, "B");
  EXPECT_EQ(plan.rovers[1].id, "a");
  EXPECT_EQ(plan.rovers[2].id, "b");
  EXPECT_DOUBLE_EQ(plan.rovers[1].heading_rad.value(), std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(plan.rovers[1].initial_charge, 0.8);
  EXPECT_EQ(plan.rovers[1].configuration, "low");
  EXPECT_FALSE(plan.rovers[0].heading_rad.has_value());
  EXPECT_DOUBLE_EQ(plan.rovers[0].start.lon_rad, 31 * rad_per_deg);
  EXPECT_DOUBLE_EQ(plan.rovers[0].start.lat_rad, 20 * rad_per_deg);
}

TEST(PlanReader, reads_an_event_with_all_its_fields) {
  const Plan plan = good(mission() + rover() + pause("rest", "A", 5) +
                         event("Route", "leg 2", "A", 3,
                               {{"Speed", "3.6 km/h"},
                                {"Enabled", "0"},
                                {"StartTime", "2026-07-01T02:00:00+01:00"},
                                {"Timeout", "2 h"},
                                {"OnFailure", "goto rest"}},
                               line("31,20,5 31.001,20.002,5")));
  ASSERT_EQ(plan.events.size(), 2u);
  const PlanEvent& leg = plan.events[0];
  EXPECT_EQ(leg.type, "Route");
  EXPECT_EQ(leg.label, "leg 2");
  EXPECT_EQ(leg.sequence, 3);
  EXPECT_DOUBLE_EQ(std::get<double>(leg.params.at("speed_mps")), 1);
  EXPECT_DOUBLE_EQ(std::get<double>(leg.params.at("arrival_radius_m")), 0.5);
  EXPECT_FALSE(leg.is_enabled);
  EXPECT_EQ(leg.start_time, parse_utc("2026-07-01T01:00:00Z").value);
  EXPECT_EQ(leg.timeout, from_seconds(7200));
  EXPECT_EQ(leg.on_failure, OnFailure::go_to);
  EXPECT_EQ(leg.go_to_sequence, 5);
  EXPECT_EQ(leg.geometry.kind, GeometryKind::line);
  ASSERT_EQ(leg.geometry.points.size(), 2u);
  EXPECT_DOUBLE_EQ(leg.geometry.points[1].lat_rad, 20.002 * rad_per_deg);
  EXPECT_EQ(leg.geometry.points[1].height_m, 0);
  EXPECT_THAT(plan.defaults, ::testing::Contains("Route 'leg 2': ArrivalRadius = 0.5 m"));
  EXPECT_THAT(plan.defaults, ::testing::Contains("OnFailure = stop (1 of 2 events)"));
}

TEST(PlanReader, an_event_without_a_name_is_called_by_type_and_sequence) {
  const Plan plan = good(mission() + rover() + pause("", "A", 7) +
                         pause("b", "A", 9, {{"StartAfter", "Pause 7"}}));
  EXPECT_EQ(plan.events.at(0).label, "Pause 7");
  EXPECT_THAT(plan.events.at(1).start_after, ElementsAre(PlanEvent::Reference{"A", 7}));
}

TEST(PlanReader, an_empty_field_counts_as_absent) {
  const Plan plan =
      good(mission() + rover() + event("Route", "a", "A", 1, {{"Speed", " "}}, line()));
  EXPECT_DOUBLE_EQ(std::get<double>(plan.events.at(0).params.at("speed_mps")), 1);
}

TEST(PlanReader, a_value_above_its_only_bound_is_refused) {
  Declarations known = test::declarations();
  FieldDeclaration& speed = known.events["Route"].fields[0];
  speed.min_si.reset();
  speed.max_si = 5;
  const Read result = read(
      mission() + rover() + event("Route", "a", "A", 1, {{"Speed", "36 km/h"}}, line()), known);
  EXPECT_THAT(test::faults_text(result.faults),
              HasSubstr("Route 'a': Speed = '36 km/h': must be at most 18 km/h"));
}

TEST(PlanReader, longitudes_are_brought_into_half_a_turn) {
  const Plan plan =
      good(mission() + placemark("", "#Rover", {{"RoverId", "A"}, {"RoverType", "SEV"}},
                                 point("+359.5, -20.0 ,100")));
  EXPECT_NEAR(plan.rovers.at(0).start.lon_rad, -0.5 * rad_per_deg, 1e-12);
  EXPECT_DOUBLE_EQ(plan.rovers.at(0).start.lat_rad, -20 * rad_per_deg);
}

TEST(PlanReader, decoration_is_counted_and_left_alone) {
  const Plan plan = good(mission() + rover() + placemark("", "#hills", {{"Height", "3"}}) +
                         "<Placemark><Polygon/></Placemark>" +
                         placemark("", "tracks", {{"Speed", "fast"}}, point("999,999")));
  EXPECT_EQ(plan.decoration_count, 3);
}

TEST(PlanReader, a_name_two_letters_off_is_a_fault_and_three_letters_off_is_not) {
  EXPECT_THAT(faults_of(mission() + rover() + placemark("", "#Rvr", {})), HasSubstr("'Rover'"));
  EXPECT_EQ(faults_of(mission() + rover() + placemark("", "#Rvrrr", {})), "");
}

TEST(PlanReader, a_layer_name_stamped_beside_ours_is_left_alone) {
  std::string both = rover();
  both.replace(both.find("<ExtendedData>"), 14,
               "<ExtendedData><SchemaData schemaUrl=\"#Roverx\"><SimpleData name=\"fid\">1"
               "</SimpleData></SchemaData>");
  const Plan plan = good(mission() + both);
  EXPECT_EQ(plan.rovers.size(), 1u);
  EXPECT_EQ(plan.decoration_count, 0);
}

TEST(PlanReader, references_are_split_at_commas_that_are_not_escaped) {
  const Plan plan =
      good(mission() + rover("A") + rover("B/x") + pause("one, two", "A", 1) +
           pause("3", "B/x", 4) + pause("end", "A", 9, {{"StartAfter", "one\\, two , B/x/4,A/1"}}));
  EXPECT_THAT(plan.events.at(1).start_after,
              ElementsAre(PlanEvent::Reference{"A", 1}, PlanEvent::Reference{"B/x", 4}));
}

TEST(PlanReader, goto_finds_the_later_of_two_events_with_one_label) {
  const Plan plan =
      good(mission() + rover() + pause("home, sweet", "A", 1) +
           pause("a", "A", 2, {{"OnFailure", "goto home, sweet"}}) + pause("home, sweet", "A", 3));
  EXPECT_EQ(plan.events.at(1).go_to_sequence, 3);
}

TEST(PlanReader, a_disabled_event_makes_no_circle) {
  EXPECT_EQ(faults_of(mission() + rover() + pause("a", "A", 1, {{"StartAfter", "b"}}) +
                      pause("b", "A", 2, {{"Enabled", "false"}})),
            "lsos_PlanReader_a_disabled_event_makes_no_circle_plan.kml:14: warning: Pause 'a': "
            "StartAfter = 'b': is disabled, and counts as ended from the beginning\n");
  EXPECT_THAT(faults_of(mission() + rover() + pause("a", "A", 1, {{"StartAfter", "b"}}) +
                        pause("b", "A", 2)),
              HasSubstr("goes in a circle: Pause 'a' (A/1) waits for Pause 'b' (A/2), which comes "
                        "after Pause 'a' (A/1)"));
}

TEST(PlanReader, rovers_that_wait_for_each_other_in_turn_make_no_circle) {
  EXPECT_EQ(faults_of(mission() + rover("A") + rover("B") + pause("a1", "A", 1) +
                      pause("b1", "B", 1, {{"StartAfter", "a1"}}) +
                      pause("a2", "A", 2, {{"StartAfter", "b1"}}) +
                      pause("b2", "B", 2, {{"StartAfter", "a2"}})),
            "");
}

TEST(PlanReader, two_separate_circles_are_both_reported) {
  const std::string a = pause("a", "A", 1, {{"StartAfter", "a"}});
  const std::string b = pause("b", "B", 1, {{"StartAfter", "b"}});
  const std::string text = faults_of(mission() + rover("A") + rover("B") + a + b);
  EXPECT_THAT(text, HasSubstr("Pause 'a' (A/1) waits for Pause 'a' (A/1)"));
  EXPECT_THAT(text, HasSubstr("Pause 'b' (B/1) waits for Pause 'b' (B/1)"));
}

TEST(PlanReader, a_stationary_point_is_compared_with_the_end_of_the_drive_before) {
  const auto stop = [](const char* place) {
    return event("Pause", "rest", "A", 2, {{"Duration", "1"}}, point(place));
  };
  const std::string start = mission() + rover() + event("Route", "a", "A", 1, {}, line());
  EXPECT_EQ(faults_of(start + stop("31.001,20.0019")), "");
  // 0.002 degrees of latitude are 60.65 m on the Moon (radius 1737.4 km).
  EXPECT_THAT(faults_of(start + stop("31.001,20.0")),
              HasSubstr("warning: Pause 'rest': its Point is 61 m from where rover 'A' then is "
                        "expected"));
}

TEST(PlanReader, assets_are_read_where_there_are_types_of_them) {
  Declarations known = test::declarations();
  known.rover_types["Habitat"].is_asset = true;
  const auto asset = [](const char* id, const char* type) {
    return placemark("", "#Asset", {{"AssetId", id}, {"AssetType", type}, {"Height", "300 cm"}},
                     point());
  };
  const Read fine = read(mission() + rover() + asset("Base", "Habitat"), known);
  EXPECT_EQ(test::faults_text(fine.faults), "");
  ASSERT_EQ(fine.plan.assets.size(), 1u);
  EXPECT_EQ(fine.plan.assets[0].id, "Base");
  EXPECT_DOUBLE_EQ(fine.plan.assets[0].antenna_height_m.value(), 3);
  const Read wrong = read(mission() + rover() + asset("A", "SEV") + rover("B", {}), known);
  EXPECT_THAT(test::faults_text(wrong.faults), HasSubstr("Asset 'A': AssetId = 'A': is taken"));
  EXPECT_THAT(test::faults_text(wrong.faults),
              HasSubstr("AssetType = 'SEV': is no asset; there are Habitat"));
  const Read swapped = read(
      mission() + placemark("", "#Rover", {{"RoverId", "A"}, {"RoverType", "Habitat"}}, point()),
      known);
  EXPECT_THAT(test::faults_text(swapped.faults),
              HasSubstr("RoverType = 'Habitat': is no rover; there are SEV"));
}

TEST(PlanReader, an_unreadable_plan_is_one_fault) {
  Faults faults;
  const Plan plan =
      read_plan(::testing::TempDir() + "lsos_no_such.kml", test::declarations(), faults);
  EXPECT_EQ(test::faults_text(faults),
            "lsos_no_such.kml: cannot be opened: No such file or directory\n");
  EXPECT_TRUE(plan.events.empty());
}

std::vector<std::string> pieces() {
  return {mission(),
          rover("A"),
          rover("B", {{"Heading", "10"}}),
          event("Route", "a", "A", 1, {{"Speed", "0.5"}}, line()),
          pause("b", "A", 2, {{"StartAfter", "c, B/7"}}),
          pause("c", "B", -3),
          event("Wait", "", "B", 7, {{"Until", "2026-07-02"}})};
}

std::string hash_of(const std::vector<std::string>& placemarks) {
  std::string text;
  for (const std::string& each : placemarks) text += each;
  return good(text).hash();
}

TEST(PlanHash, does_not_depend_on_order_lines_or_spelling) {
  const std::string hash = hash_of(pieces());
  std::mt19937 random(1);
  for (int round = 0; round < 20; ++round) {
    std::vector<std::string> shuffled = pieces();
    std::ranges::shuffle(shuffled, random);
    EXPECT_EQ(hash_of(shuffled), hash);
  }
  std::vector<std::string> spelt = pieces();
  spelt[3] =
      "\n\n<Folder>" + event("Route", "a", "A", 1, {{"Speed", "50 cm/s"}}, line()) + "</Folder>";
  spelt.push_back(placemark("hill", "#hills", {}));
  EXPECT_EQ(hash_of(spelt), hash);
}

TEST(PlanHash, depends_on_every_value) {
  const std::vector<std::string> changed[] = {
      {mission({{"Seed", "1"}})},
      {mission({{"LogInterval", "1"}})},
      {mission({{"ParkedLogInterval", "10"}})},
      {mission({{"MaxDuration", "1 d"}})},
      {mission(), rover("C", {{"Heading", "11"}})},
      {mission(), rover("C", {{"Heading", "12"}})},
      {mission(), rover("C", {{"InitialCharge", "0.5"}})},
      {mission(), rover("C", {{"RoverConfig", "low"}})},
      {mission(), event("Route", "d", "A", 9, {}, line())},
      {mission(), event("Route", "e", "A", 9, {}, line())},
      {mission(), event("Route", "d", "A", 8, {}, line())},
      {mission(), event("Route", "d", "B", 9, {}, line())},
      {mission(), event("Route", "d", "A", 9, {}, line("31,20 31.001,20.001"))},
      {mission(), event("Route", "d", "A", 9, {{"Speed", "1.5"}}, line())},
      {mission(), event("Route", "d", "A", 9, {{"Enabled", "false"}}, line())},
      {mission(), event("Route", "d", "A", 9, {{"Timeout", "60"}}, line())},
      {mission(), event("Route", "d", "A", 9, {{"StartTime", "2026-07-01"}}, line())},
      {mission(), event("Route", "d", "A", 9, {{"StartAfter", "a"}}, line())},
      {mission(), event("Route", "d", "A", 9, {{"OnFailure", "abort"}}, line())},
  };
  std::vector<std::string> hashes{hash_of(pieces())};
  for (const std::vector<std::string>& change : changed) {
    std::vector<std::string> plan = pieces();
    plan[0] = change[0];
    plan.insert(plan.end(), change.begin() + 1, change.end());
    hashes.push_back(hash_of(plan));
  }
  std::ranges::sort(hashes);
  EXPECT_EQ(std::ranges::adjacent_find(hashes), hashes.end());
}

// Processor time of reading a plan, s; wall time also depends on other processes.
double reading_s(const std::string& placemarks, std::size_t fault_count) {
  const std::string file = test::write_file(document(placemarks));
  Faults faults;
  const std::clock_t before = std::clock();
  read_plan(file, test::declarations(), faults);
  const std::clock_t after = std::clock();
  EXPECT_EQ(faults.sorted().size(), fault_count);
  return static_cast<double>(after - before) / CLOCKS_PER_SEC;
}

// Greatest ratio of reading times for ten times the events (linear: 10, quadratic: 100).
constexpr double growth = 30;

TEST(PlanReader, reading_time_grows_with_the_number_of_events_and_not_with_its_square) {
  const auto plan = [](int count) {
    std::string text = mission();
    for (int r = 0; r < 10; ++r) text += rover("R" + std::to_string(r));
    for (int i = count - 1; i >= 0; --i) {
      test::Fields after;
      if (i >= 10) after = {{"StartAfter", "leg " + std::to_string(i - 7)}};
      text += event("Route", "leg " + std::to_string(i), "R" + std::to_string(i % 10), i, after,
                    line());
    }
    return text;
  };
  EXPECT_LT(reading_s(plan(10000), 0), growth * reading_s(plan(1000), 0));
}

TEST(PlanReader, a_plan_with_thousands_of_faults_is_not_slow) {
  const auto plan = [](int count) {
    std::string text = mission() + rover();
    for (int i = 0; i < count; ++i) {
      const std::string n = std::to_string(i);
      text += event("Route", "leg " + n, "A" + n, i, {{"StartAfter", "lge " + n}}, line());
    }
    return text;
  };
  EXPECT_LT(reading_s(plan(10000), 20000), growth * reading_s(plan(1000), 2000));
}

}  // namespace
}  // namespace lsos
