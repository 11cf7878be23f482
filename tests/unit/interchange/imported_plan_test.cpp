#include "interchange/imported_plan.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>

#include "interchange/map_tables.h"
#include "interchange/outline.h"
#include "interchange/place_book.h"
#include "interchange/plan_document.h"
#include "interchange/sheets.h"
#include "plan/kml_reader.h"
#include "unit/plan/plan_fixture.h"

namespace lsos::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string mission =
    "Type,RoverId,RoverType,Planet,StartTime,Terrain,Lon,Lat\n"
    "MissionInfo,,,Moon,2026-07-01 06:00,Flat,,\n"
    "Rover,A,SEV,,,,0,0\n";

struct Imported {
  Plan plan;
  ImportedPlan source;
  std::string faults;
};

Imported import(const std::vector<std::string>& sheets) {
  std::vector<Table> tables;
  for (const std::string& sheet : sheets) {
    for (Table& table : read_csv(sheet, fmt::format("s{}.csv", tables.size() + 1))) {
      tables.push_back(std::move(table));
    }
  }
  Faults faults;
  Imported imported{{}, import_tables(tables, declarations(), faults), ""};
  imported.plan = read_plan("plan.kml", imported.source.source, declarations(), faults);
  imported.faults = faults_text(faults);
  return imported;
}

std::string start_text(const PlanEvent& event) {
  return event.start_time ? format_utc(*event.start_time) : "none";
}

TEST(ImportedPlan, takes_over_rover_and_day_of_the_row_above) {
  const Imported made = import({mission, "name,lon,lat\nRidge,0.01,0.005\nCamp,0.02,0\n",
                                "Type,Rover,Day,Start,Place,Speed (km/h),Duration (min)\n"
                                "route,A,1,08:00,Ridge,3.6,\n"
                                "Pause,,,+30 min,,,90\n"
                                "Route,,2,,Ridge; Camp,7.2,\n"
                                "Pauses,,,,,,1:30\n"});
  ASSERT_EQ(made.faults, "");
  const auto& events = made.plan.events;
  ASSERT_EQ(events.size(), 4u);
  EXPECT_EQ(start_text(events[0]), "2026-07-01T08:00:00.000Z");
  EXPECT_EQ(start_text(events[1]), "2026-07-01T08:30:00.000Z");
  EXPECT_EQ(start_text(events[2]), "2026-07-02T00:00:00.000Z");  // the day begins
  EXPECT_EQ(start_text(events[3]), "none");
  EXPECT_EQ(std::get<double>(events[0].params.at("speed_mps")), 1.0);
  EXPECT_EQ(std::get<double>(events[1].params.at("duration_s")), 5400.0);
  EXPECT_EQ(std::get<double>(events[3].params.at("duration_s")), 5400.0);
  EXPECT_EQ(events[0].geometry.points.size(), 1u);
  EXPECT_EQ(events[2].geometry.points.size(), 2u);
  EXPECT_EQ(events[3].sequence, 40);
  EXPECT_THAT(made.source.source.placemarks.back().folders, ElementsAre("A", "2026-07-02"));
}

TEST(ImportedPlan, joins_a_line_on_a_map_with_the_row_of_its_name) {
  KmlSource map{"map.kml", {}};
  SourcePlacemark line;
  line.name = "Traverse";
  line.geometries.push_back({"LineString", "0,0 0.01,0 0.01,0.01", 7});
  map.placemarks = {line};
  line.name = "Elsewhere";
  map.placemarks.push_back(line);
  std::vector<Table> tables = tables_of(map);
  for (const char* sheet : {mission.c_str(), "Type,name,Rover,Day\nRoute,Traverse,A,3\n"}) {
    tables.push_back(read_csv(sheet, "s.csv").at(0));
  }
  Faults faults;
  const ImportedPlan made = import_tables(tables, declarations(), faults);
  const Plan plan = read_plan("plan.kml", made.source, declarations(), faults);
  ASSERT_EQ(faults_text(faults), "");
  EXPECT_EQ(plan.events.at(0).geometry.points.size(), 3u);
  EXPECT_EQ(start_text(plan.events[0]), "2026-07-03T00:00:00.000Z");
  EXPECT_THAT(made.left_out, ElementsAre("1 place that no row names: Elsewhere"));
}

TEST(ImportedPlan, has_units_that_are_signs_and_rovers_at_places) {
  const Imported made =
      import({"Type,RoverId,RoverType,Planet,StartTime,Terrain,Place,Initial Charge (%)\n"
              "MissionInfo,,,Moon,2026-07-01 06:00,Flat,,\n"
              "Rover,A,SEV,,,,\"0.01, 0\",95\n",
              "Type,Rover,Place\nRoute,A,A\n"});
  ASSERT_EQ(made.faults, "");
  EXPECT_DOUBLE_EQ(made.plan.rovers.at(0).initial_charge, 0.95);
  EXPECT_EQ(made.source.source.placemarks.at(2).geometries.at(0).coordinates, "0.01,0");
}

TEST(ImportedPlan, says_that_clock_times_without_a_day_are_of_the_first) {
  const Imported made =
      import({mission, "Type,Rover,Start,Duration\nPause,A,08:00,1 h\nPause,A,10:00,1 h\n"});
  EXPECT_EQ(start_text(made.plan.events.at(1)), "2026-07-01T10:00:00.000Z");
  EXPECT_THAT(made.faults, HasSubstr("s2.csv:C2: warning: StartTime = 08:00: no Day is said, so "
                                     "clock times of this sheet are of day 1, 2026-07-01"));
  EXPECT_EQ(made.faults.find("C3"), std::string::npos);
}

TEST(ImportedPlan, leaves_columns_of_a_map_alone) {
  KmlSource map{"map.kml", {}};
  SourcePlacemark place;
  place.name = "Ridge";
  place.plain_data = {{"label", "R", 1}, {"kind", "crest", 1}, {"age", "old", 1}};
  place.geometries.push_back({"Point", "0,0", 1});
  map.placemarks = {place};
  Faults faults;
  const ImportedPlan made = import_tables(tables_of(map), declarations(), faults);
  EXPECT_EQ(faults_text(faults), "");
  EXPECT_THAT(made.left_out, ElementsAre("1 place that no row names: Ridge"));
}

TEST(ImportedPlan, tells_faults_by_sheet_and_cell) {
  const Imported made = import({mission,
                                "Type,Rover,Day,Start,Speed (kg),Place,Speed,Colour\n"
                                "Rout,A,,,,,,\n"
                                "Route,A,soon,25:00,5,Nowhere,,red\n"});
  EXPECT_THAT(made.faults,
              HasSubstr("s2.csv:A2: Type = 'Rout': there is no such event; did you mean "
                        "'Route'?"));
  EXPECT_THAT(made.faults, HasSubstr("s2.csv:C3: Day = 'soon' is no day"));
  EXPECT_THAT(made.faults, HasSubstr("s2.csv:D3: StartTime = '25:00': a clock time is"));
  EXPECT_THAT(made.faults, HasSubstr("s2.csv:E1: (kg) is no unit of Speed; there are m/s, km/h"));
  EXPECT_THAT(made.faults, HasSubstr("s2.csv:F3: Place: there is no place 'Nowhere'; there are A"));
  EXPECT_THAT(made.faults, HasSubstr("s2.csv:G1: the column Speed stands twice, here and at E1"));
  EXPECT_THAT(made.faults, HasSubstr("s2.csv:H1: warning: the column 'Colour' is not used"));
}

std::vector<std::int64_t> sequences(const std::string& rows) {
  const Imported made = import({mission, "Type,Rover,Sequence,Duration\n" + rows});
  EXPECT_EQ(made.faults, "");
  std::vector<std::int64_t> numbers;
  for (const PlanEvent& event : made.plan.events) numbers.push_back(event.sequence);
  return numbers;
}

TEST(ImportedPlan, numbers_rows_that_were_inserted_between_those_around_them) {
  EXPECT_THAT(sequences("Pause,A,10,60\nPause,A,,60\nPause,A,20,60\nPause,A,,60\n"),
              ElementsAre(10, 15, 20, 30));
  EXPECT_THAT(sequences("Pause,A,10,60\nPause,A,,60\nPause,A,100,60\n"), ElementsAre(10, 20, 100));
  EXPECT_THAT(sequences("Pause,A,10,60\nPause,A,,60\nPause,A,,60\nPause,A,13,60\n"),
              ElementsAre(10, 11, 12, 13));
  EXPECT_THAT(sequences("Pause,A,,60\nPause,A,5,60\n"), ElementsAre(2, 5));
}

// A planner who names the places to go to means from here.
TEST(ImportedPlan, leads_to_several_places_from_where_the_rover_stands) {
  const std::string places = "name,lon,lat\nRidge,0.01,0.005\nGate,0.02,0\n";
  const Imported made = import({mission, places,
                                "Type,Rover,Place\nRoute,A,Ridge; Gate\nRoute,A,Ridge\n"
                                "Route,A,Ridge; Gate\nRoute,A,\"0.03,0; 0.04,0\"\n"});
  ASSERT_EQ(made.faults, "");
  const auto line = [&](std::size_t event) {
    return made.source.source.placemarks.at(2 + event).geometries.at(0).coordinates;
  };
  EXPECT_EQ(line(0), "0,0 0.01,0.005 0.02,0");
  EXPECT_EQ(line(1), "0.01,0.005");
  EXPECT_EQ(line(2), "0.01,0.005 0.02,0");
  EXPECT_EQ(line(3), "0.02,0 0.03,0 0.04,0");
}

TEST(ImportedPlan, takes_days_in_the_order_of_sequences_where_rows_stand_otherwise) {
  const std::string header = "Type,Rover,Sequence,Day,Start,Duration\n";
  const Imported sorted =
      import({mission, header + "Pause,A,20,2,08:00,60\nPause,A,10,1,09:00,60\n"});
  EXPECT_EQ(sorted.faults, "");
  const Imported back = import({mission, header + "Pause,A,,2,08:00,60\nPause,A,,1,09:00,60\n"});
  EXPECT_THAT(back.faults, HasSubstr("Day = 1, 2026-07-01, is before the Day of a row above of "
                                     "rover 'A', 2026-07-02 at D2"));
}

TEST(ImportedPlan, of_an_outline_has_starts_on_the_days_of_headings) {
  const auto outline = [](const std::string& text) {
    Faults faults;
    std::vector<Table> tables = read_outline(
        "Mission: Planet Moon, StartTime 2026-07-01T06:00, Terrain Flat\nRover A: SEV at (0, 0)\n" +
            text,
        "idea.txt", declarations());
    import_tables(std::move(tables), declarations(), faults);
    return faults_text(faults);
  };
  EXPECT_EQ(outline("Day 1, A: 08:00 Pause, Duration 1 h\n  +20 h Pause, Duration 1 h\n"), "");
  EXPECT_THAT(outline("Day 1, A: 08:00 Pause, Duration 1 h\nDay 2, A: +1 h Pause, Duration 1 h\n"),
              HasSubstr("but Day = Day 2 (2026-07-02) at line 4; one of them is to be changed"));
}

TEST(ImportedPlan, knows_rovers_and_places_in_any_case_and_says_so) {
  const Imported made = import({mission, "name,lon,lat\nRidge,0.01,0.005\n",
                                "Type,Rover,Place\nRoute,a,RIDGE\nRoute,,ridge\n"});
  ASSERT_EQ(made.faults, "");
  EXPECT_EQ(made.plan.events.at(0).rover_id, "A");
  EXPECT_THAT(made.source.notes, ElementsAre("'a' is taken for 'A'", "'RIDGE' is taken for 'Ridge'",
                                             "'ridge' is taken for 'Ridge'"));
}

TEST(ImportedPlan, finds_its_header_below_a_title_and_leaves_comments_out) {
  const Imported made = import({mission,
                                "Plan of the week,,\n,,\nType,Rover,Duration in min\n"
                                "# to be discussed,,\nPause,A,90\n"});
  ASSERT_EQ(made.faults, "");
  EXPECT_EQ(std::get<double>(made.plan.events.at(0).params.at("duration_s")), 5400);
  EXPECT_THAT(made.source.notes,
              ElementsAre("s2.csv: the header is row 3; the rows above it are left out"));
}

TEST(ImportedPlan, says_once_for_a_column_what_numbers_without_a_unit_are) {
  const Imported made = import({mission,
                                "Type,Rover,Place,Speed,Duration\nRoute,A,\"0.1,0\",2,\n"
                                "Route,A,\"0,0\",3,\nPause,A,,,60\nPause,A,,,2 h\n"});
  EXPECT_THAT(made.source.notes,
              ElementsAre("s2.csv:D1: column Speed: numbers without a unit are m/s",
                          "s2.csv:E1: column Duration: numbers without a unit are s"));
}

TEST(ImportedPlan, says_where_its_days_are_not_those_of_reports) {
  const auto notes = [](const std::string& clock) {
    return import({mission, "Type,Rover,Day,Start,Duration\nPause,A,1,07:00,1 h\nPause,A,2," +
                                clock + ",1 h\n"})
        .source.notes;
  };
  EXPECT_THAT(notes("06:00"), IsEmpty());
  EXPECT_THAT(notes("05:59"),
              ElementsAre("days are UTC dates here; reports, check and edit count them from 06:00 "
                          "on, when the mission starts, so that a time before 06:00 is of the day "
                          "before there"));
}

// The plan's map shows them, and export names them again.
TEST(ImportedPlan, keeps_places_that_rows_name) {
  const Imported made = import({mission, "name,lon,lat\nRim,0.010,0.005\nGate,0.02,0\n",
                                "Type,Rover,Place\nRoute,A,Rim\nRoute,A,A\n"});
  ASSERT_EQ(made.source.places.size(), 1u);
  EXPECT_EQ(made.source.places[0].name, "Rim");
  DocumentLook look;
  look.places = made.source.places;
  const KmlSource read = parse_kml(kml_of(made.source.source, look), "plan.kml");
  const std::vector<Landmark> marks = landmarks(read, declarations());
  ASSERT_EQ(marks.size(), 1u);
  EXPECT_EQ(marks[0].name, "Rim");
  EXPECT_EQ(marks[0].coordinates, "0.010,0.005");
  Faults faults;
  EXPECT_EQ(read_plan("plan.kml", read, declarations(), faults).hash(), made.plan.hash());
  EXPECT_EQ(faults_text(faults), "");
}

TEST(ImportedPlan, takes_a_collection_of_one_line_for_the_line) {
  const Imported made =
      import({mission, "Type,Rover,WKT\nRoute,A,\"MULTILINESTRING ((0 0, 0.01 0))\"\n"});
  ASSERT_EQ(made.faults, "");
  EXPECT_EQ(made.plan.events.at(0).geometry.points.size(), 2u);
}

}  // namespace
}  // namespace lsos::test
