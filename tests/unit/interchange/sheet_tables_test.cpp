// Plans as planners read them: sheets and outlines.
#include "interchange/sheet_tables.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "interchange/imported_plan.h"
#include "interchange/outline.h"
#include "interchange/plan_tables.h"
#include "unit/plan/plan_fixture.h"

namespace lsos::test {
namespace {

using ::testing::ElementsAre;

Declarations known() {
  Declarations known = declarations();
  known.rover_types["Habitat"].is_asset = true;
  return known;
}

SourcePlacemark thing(const std::string& type, const Fields& fields, const std::string& name = "",
                      const std::string& coordinates = "") {
  SourcePlacemark made;
  made.name = name;
  made.data.push_back({"", type, {}, 1});
  for (const auto& [field, text] : fields) made.data.front().fields.push_back({field, text, 1});
  if (coordinates.empty()) return made;
  const bool is_line = coordinates.find(' ') != std::string::npos;
  made.geometries.push_back({is_line ? "LineString" : "Point", coordinates, 1});
  return made;
}

// A day with a drive to a named place, one of two places and one that is drawn.
KmlSource plan() {
  KmlSource plan{"plan.kml", {}};
  plan.placemarks = {
      thing("MissionInfo",
            {{"Planet", "Moon"}, {"StartTime", "2026-07-01T06:00:00Z"}, {"Terrain", "Flat"}}),
      thing("Rover", {{"RoverId", "A"}, {"RoverType", "SEV"}}, "", "0.000,0"),
      thing("Asset", {{"AssetId", "Camp"}, {"AssetType", "Habitat"}}, "", "0.03,0"),
      thing("Route",
            {{"RoverId", "A"},
             {"Sequence", "10"},
             {"StartTime", "2026-07-01T08:00:30Z"},
             {"Speed", "5 km/h"}},
            "To the ridge", "0.010,0.005"),
      thing("Pause", {{"RoverId", "A"}, {"Sequence", "20"}, {"Duration", "5400"}}, "Look"),
      thing("Route", {{"RoverId", "A"}, {"Sequence", "25"}, {"Speed", "2"}}, "Home",
            "0.010,0.005 0.03,0 0,0"),
      thing("Wait",
            {{"RoverId", "A"}, {"Sequence", "35"}, {"Until", "2026-07-02T06:00:00.000001Z"}}, "",
            "0,0"),
      thing("Route", {{"RoverId", "A"}, {"Sequence", "40"}, {"StartTime", "2026-07-03T07:30:00Z"}},
            "", "0,0 0.001,0 0.002,0 0.003,0 0.004,0 0.03,0")};
  return plan;
}

TEST(SheetTables, say_days_clocks_places_and_units) {
  const std::vector<Table> tables = sheet_tables(plan(), known(), {}, false);
  ASSERT_EQ(tables.size(), 5u);
  EXPECT_THAT(tables[1].header, ElementsAre("Rover", "Rover Type", "Place"));
  EXPECT_THAT(tables[1].rows[0].cells, ElementsAre("A", "SEV", "Home"));
  const Table& places = tables[3];
  EXPECT_EQ(places.name, "Places");
  ASSERT_EQ(places.rows.size(), 2u);
  EXPECT_THAT(places.rows[0].cells, ElementsAre("Ridge", "0.010", "0.005"));
  EXPECT_THAT(places.rows[1].cells, ElementsAre("Home", "0", "0"));
  const Table& events = tables[4];
  EXPECT_THAT(events.header,
              ElementsAre("Type", "Rover", "Sequence", "Name", "Day", "Start", "Place",
                          "Speed (km/h)", "Duration (min)", "Until", "WKT"));
  ASSERT_EQ(events.rows.size(), 5u);
  EXPECT_THAT(events.rows[0].cells, ElementsAre("Route", "A", "10", "To the ridge", "1", "08:00:30",
                                                "Ridge", "5", "", "", ""));
  EXPECT_THAT(events.rows[1].cells,
              ElementsAre("Pause", "A", "20", "Look", "1", "", "", "", "90", "", ""));
  EXPECT_EQ(events.rows[2].cells[6], "Camp; Home");
  // No clock says a microsecond, and a line of many points stays as it is drawn.
  EXPECT_EQ(events.rows[3].cells[9], "2026-07-02T06:00:00.000001Z");
  EXPECT_THAT(events.rows[4].cells,
              ElementsAre("Route", "A", "40", "", "3", "07:30", "", "", "", "",
                          "LINESTRING (0 0, 0.001 0, 0.002 0, 0.003 0, 0.004 0, 0.03 0)"));
}

TEST(SheetTables, know_which_columns_are_numbers) {
  const std::vector<Table> tables = sheet_tables(plan(), known(), {}, false);
  EXPECT_THAT(tables[3].numbers, ElementsAre(1, 2));
  EXPECT_THAT(tables[4].numbers, ElementsAre(2, 7, 8)) << "Sequence, Speed, Duration";
}

TEST(SheetTables, say_many_seconds_in_minutes_or_hours) {
  KmlSource long_pause = plan();
  long_pause.placemarks[4].data.front().fields[2].text = "7200 s";
  const Table events = sheet_tables(long_pause, known(), {}, false)[4];
  EXPECT_EQ(events.header[8], "Duration (h)");
  EXPECT_EQ(events.rows[1].cells[8], "2");
}

// A row does not say a day on which its start is not, nor one before those above.
TEST(SheetTables, say_starts_that_go_back_whole) {
  KmlSource back = plan();
  back.placemarks.push_back(thing("Pause", {{"RoverId", "A"},
                                            {"Sequence", "50"},
                                            {"StartTime", "2026-07-02T06:00:00Z"},
                                            {"Duration", "60"}}));
  back.placemarks.push_back(
      thing("Pause", {{"RoverId", "A"}, {"Sequence", "60"}, {"Duration", "60"}}));
  const Table events = sheet_tables(back, known(), {}, false)[4];
  EXPECT_THAT(std::vector(events.rows[5].cells.begin() + 4, events.rows[5].cells.begin() + 6),
              ElementsAre("", "2026-07-02T06:00:00Z"));
  EXPECT_EQ(events.rows[6].cells[4], "3");
  Faults faults;
  const std::string hash = read_plan("plan.kml", back, known(), faults).hash();
  std::vector<Table> tables = sheet_tables(back, known(), {}, false);
  for (Table& table : tables) table.has_letters = true;
  Faults told;
  const ImportedPlan again = import_tables(tables, known(), told);
  EXPECT_FALSE(told.has_errors()) << faults_text(told);
  EXPECT_EQ(read_plan("plan.kml", again.source, known(), faults).hash(), hash);
}

TEST(SheetTables, have_places_as_rows_of_one_table) {
  const std::vector<Table> tables = sheet_tables(plan(), known(), {}, true);
  ASSERT_EQ(tables.size(), 1u);
  EXPECT_EQ(cell(tables[0].rows[3], 0), "Place");
  EXPECT_EQ(cell(tables[0].rows[3], 3), "Ridge");
}

TEST(SheetTables, take_names_of_places_from_the_map) {
  const std::vector<Landmark> marks{{"Lookout", "0.01,0.0050"}};
  const std::vector<Table> tables = sheet_tables(plan(), known(), marks, false);
  EXPECT_EQ(cell(tables[4].rows[0], 6), "Lookout");
}

TEST(SheetTables, are_read_back_equal) {
  const KmlSource before = plan();
  Faults faults;
  const std::string hash = read_plan("plan.kml", before, known(), faults).hash();
  ASSERT_EQ(faults_text(faults), "");
  for (const bool is_one : {true, false}) {
    std::vector<Table> tables = sheet_tables(before, known(), {}, is_one);
    for (Table& table : tables) table.has_letters = true;
    const ImportedPlan again = import_tables(tables, known(), faults);
    EXPECT_EQ(read_plan("plan.kml", again.source, known(), faults).hash(), hash);
  }
  EXPECT_EQ(faults_text(faults), "");
}

TEST(Outline, is_written_in_words) {
  EXPECT_EQ(outline_of(plan(), known()),
            R"(Mission: Planet Moon, StartTime 2026-07-01T06:00:00Z, Terrain Flat
Place Ridge: (0.010, 0.005)
Place Home: (0, 0)
Rover A: SEV at Home
Asset Camp: Habitat at (0.03, 0)

Day 1, A:
  08:00:30 drive straight to Ridge at 5 km/h, as To the ridge
  pause 90 min, as Look
  drive straight to Camp > Home at 2 m/s, Sequence 25, as Home
  wait until 2026-07-02T06:00:00.000001Z at Home

Day 3, A:
  07:30 drive along LINESTRING (0 0, 0.001 0, 0.002 0, 0.003 0, 0.004 0, 0.03 0), Sequence 40
)");
}

}  // namespace
}  // namespace lsos::test
