// `lsos-host import --onto`: sheets of a plan brought back into the KML that was drawn.

#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "system/kml_file.h"
#include "system/process.h"
#include "system/source_files.h"
#include "system/temp_folder.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class ImportOnto : public ::testing::Test {
 protected:
  std::string exported(const std::string& plan_file, const std::string& ending) const {
    const std::string sheet = folder_ / ("sheet" + ending);
    const Outcome outcome = run({"export", plan_file, "-o", sheet, "--force"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return sheet;
  }
  Outcome onto(const std::string& sheet, const std::string& plan_file,
               const Words& more = {}) const {
    Words words{"import", sheet, "--onto", plan_file, "-o", new_plan_, "--force"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
  // What two files differ in, line by line, without positions.
  std::string differences(const std::string& before, const std::string& after) const {
    return run_command({"diff", "--unchanged-line-format=", "--old-line-format=-%L",
                        "--new-line-format=+%L", before, after})
        .out;
  }
  // A plan's sheet, changed by a script that has its rows: `row(rover, sequence)` finds one, and
  // `put(row, column, text)` writes a cell. Columns are known by their letters, without units.
  std::string edited(const std::string& plan_file, const std::string& script) const {
    const std::string sheet = exported(plan_file, ".csv"), changed = folder_ / "edited.csv";
    const Outcome outcome = run_command(
        {"python3", "-c",
         "import csv, sys\n"
         "rows = list(csv.reader(open(sys.argv[1])))\n"
         "heads = [h.split('(')[0].replace(' ', '').lower() for h in rows[0]]\n"
         "def put(row, column, text): row[heads.index(column)] = text\n"
         "def row(rover, sequence):\n"
         "  last = ''\n"
         "  for each in rows[1:]:\n"
         "    last = each[heads.index('rover' if 'rover' in heads else 'roverid')] or last\n"
         "    if (last, each[heads.index('sequence')]) == (rover, sequence): return each\n" +
             script + "\ncsv.writer(open(sys.argv[2], 'w')).writerows(rows)\n",
         sheet, changed});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return changed;
  }

  TempFolder folder_;
  std::string new_plan_ = folder_ / "new.kml";
};

TEST_F(ImportOnto, every_shipped_plan_stays_as_it_was) {
  for (const auto& entry : fs::directory_iterator(repository() / "plans")) {
    if (entry.path().extension() != ".kml") continue;
    const std::string file = entry.path();
    for (const char* ending : {".csv", ".xlsx"}) {
      const Outcome outcome = onto(exported(file, ending), file);
      ASSERT_EQ(outcome.exit_code, 0) << file << ending << "\n" << outcome.err;
      EXPECT_THAT(outcome.out, HasSubstr("0 changed, 0 added, ")) << file << ending;
      EXPECT_THAT(outcome.out, HasSubstr(", 0 without a row kept, 0 removed; wrote"));
      EXPECT_EQ(canonical(new_plan_), canonical(file)) << file << ending;
    }
  }
}

TEST_F(ImportOnto, a_cell_that_changes_changes_one_field) {
  const std::string file = plan("drats_day");
  const std::string sheet = edited(file, "put(row('A', '60'), 'arrivalradius', '7 m')");
  const Outcome outcome = onto(sheet, file);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out.substr(outcome.out.find("  changed")),
            "  changed: A/60 PathPlanRoute 'To A1 stop 2': ArrivalRadius = 7 m, was 5 m\n"
            "1 changed, 0 added, 25 as they were, 0 without a row kept, 0 removed; wrote " +
                new_plan_ + "\n");
  EXPECT_EQ(differences(file, new_plan_),
            "-          <SimpleData name=\"ArrivalRadius\">5 m</SimpleData>\n"
            "+          <SimpleData name=\"ArrivalRadius\">7 m</SimpleData>\n");
}

TEST_F(ImportOnto, a_row_without_a_sequence_is_no_guess_at_an_event) {
  const Outcome outcome = onto(
      folder_.write("part.csv", "Rover,Sequence,Type,Name,Activity Duration\nA,,EVA,New,1:00\n"),
      plan("drats_day"));
  EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
  EXPECT_THAT(outcome.err, HasSubstr("part.csv:B2: Sequence is empty: with --onto it says which "
                                     "event of the plan the row is"));
  EXPECT_FALSE(fs::exists(new_plan_));
}

TEST_F(ImportOnto, a_day_without_times_leaves_those_of_the_plan) {
  const std::string file = plan("drats_day");
  const Outcome outcome = onto(
      folder_.write("part.csv", "Rover,Sequence,Day,Type,Duration\nA,110,2,Recharge,11 h\n"), file);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(differences(file, new_plan_),
            "-          <SimpleData name=\"Duration\">12 h</SimpleData>\n"
            "+          <SimpleData name=\"Duration\">11 h</SimpleData>\n");
}

TEST_F(ImportOnto, another_type_is_told_to_keep_its_place) {
  const Outcome outcome =
      onto(folder_.write("part.csv", "Rover,Sequence,Type,Activity Duration\nA,10,EVA,1:00\n"),
           plan("drats_day"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("Type = EVA, was PathPlanRoute"));
  EXPECT_THAT(outcome.out, HasSubstr("its place stays"));
}

TEST_F(ImportOnto, a_new_row_comes_beside_its_kin_with_their_style) {
  const std::string file = plan("drats_day");
  const std::string sheet = edited(file,
                                   "new = list(row('A', '60'))\n"
                                   "put(new, 'sequence', '65')\n"
                                   "put(new, 'name', 'Back & on')\n"
                                   "put(new, 'arrivalradius', '5 m')\n"
                                   "rows.insert(rows.index(row('A', '60')) + 1, new)");
  const Outcome outcome = onto(sheet, file);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("added: A/65 PathPlanRoute 'Back & on'"));
  EXPECT_EQ(differences(file, new_plan_),
            "+        <name>Back &amp; on</name>\n"
            "+        <styleUrl>#driveA</styleUrl>\n"
            "+        <ExtendedData><SchemaData schemaUrl=\"#PathPlanRoute\">\n"
            "+          <SimpleData name=\"Type\">PathPlanRoute</SimpleData>\n"
            "+          <SimpleData name=\"RoverId\">A</SimpleData>\n"
            "+          <SimpleData name=\"Sequence\">65</SimpleData>\n"
            "+          <SimpleData name=\"ArrivalRadius\">5 m</SimpleData>\n"
            "+          <SimpleData name=\"OnFailure\">skip</SimpleData>\n"
            "+        </SchemaData></ExtendedData>\n"
            "+        <Point><coordinates>-111.453045,35.709875</coordinates></Point>\n"
            "+      </Placemark>\n"
            "+      <Placemark>\n");
}

TEST_F(ImportOnto, what_has_no_row_is_kept_unless_it_is_to_go) {
  const std::string file = plan("drats_day");
  const std::string sheet = edited(file, "rows.remove(row('A', '90'))");
  const Outcome kept = onto(sheet, file);
  ASSERT_EQ(kept.exit_code, 0) << kept.err;
  EXPECT_THAT(kept.out, HasSubstr("kept without a row (--remove-missing removes it): A/90\n"));
  EXPECT_EQ(canonical(new_plan_), canonical(file));
  const Outcome removed = onto(sheet, file, {"--remove-missing"});
  ASSERT_EQ(removed.exit_code, 0) << removed.err;
  EXPECT_THAT(removed.out, HasSubstr("  removed: A/90\n"));
  EXPECT_EQ(differences(file, new_plan_),
            "-        <name>Mast up, A1 camp</name>\n"
            "-        <ExtendedData><SchemaData schemaUrl=\"#DeployCA\">\n"
            "-          <SimpleData name=\"Type\">DeployCA</SimpleData>\n"
            "-          <SimpleData name=\"RoverId\">A</SimpleData>\n"
            "-          <SimpleData name=\"Sequence\">90</SimpleData>\n"
            "-        </SchemaData></ExtendedData>\n"
            "-      </Placemark>\n"
            "-      <Placemark>\n");
}

TEST_F(ImportOnto, a_sheet_of_events_alone_is_enough) {
  // Days are counted from the start of the plan's mission, and its assets are places.
  const std::string sheet =
      folder_.write("some.csv",
                    "Rover,Type,Sequence,Day,Start,Duration,Place,Notes,Power,Colour\n"
                    "A,Pause,1000,2,08:00,1 h,Base,take the <bag>,,red\n"
                    ",Consume,1010,,,30 min,,,200,\n");
  const Outcome outcome = onto(sheet, plan("drats_day"), {"--remove-missing", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("some.csv:J1: warning: the column 'Colour' is not used"));
  const auto answer = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(answer["added"], nlohmann::json({"A/1000", "A/1010"}));
  EXPECT_EQ(answer["removed"].size(), 22u) << "events; the sheet says nothing of rovers";
  EXPECT_EQ(answer["kept"], nlohmann::json({"Rover A", "Rover B", "Asset Base"}));
  const std::string text = read_text(new_plan_);
  EXPECT_THAT(text, HasSubstr("<SimpleData name=\"StartTime\">2010-09-01T08:00:00Z<"));
  EXPECT_THAT(text, HasSubstr("<description>take the &lt;bag&gt;</description>"));
  EXPECT_THAT(text, HasSubstr("<Schema name=\"Consume\" id=\"Consume\">"));
}

// A plan whose line of places does not name where its rover stands, as people write it.
class ImportOntoLine : public ImportOnto {
 protected:
  void SetUp() override {
    const std::string sheet = folder_.write(
        "tasks.csv",
        "Type,RoverId,RoverType,Name,Place,Lon,Lat,Planet,StartTime,Terrain,Duration\n"
        "MissionInfo,,,,,,,Moon,2026-07-01 06:00,Flat,\n"
        "Rover,SEV A,SEV,,,0,0,,,,\n"
        "Rover,SEV B,SEV,,,0.03,0,,,,\n"
        "Place,,,Rim,,0.020,0.004,,,,\nPlace,,,Ridge,,0.012,-0.006,,,,\n"
        "Place,,,Gate,,0.001,0,,,,\n"
        "PathPlanRoute,SEV A,,To the rim,Rim,,,,,,\n"
        "Pause,SEV A,,Ridge,,,,,,,1 h\n"
        "PathPlanRoute,SEV A,,Home,Ridge; Gate,,,,,,\n");
    const Outcome outcome = run({"import", sheet, "-o", plan_});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    ASSERT_THAT(read_text(plan_), HasSubstr("0.02,0.004 0.012,-0.006 0.001,0<")) << outcome.out;
  }

  std::string plan_ = folder_ / "plan.kml";
};

TEST_F(ImportOntoLine, stays_as_it_was) {
  for (const char* ending : {".csv", ".xlsx", ".ods"}) {
    const Outcome outcome = onto(exported(plan_, ending), plan_);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("0 changed, 0 added, ")) << ending;
    EXPECT_EQ(outcome.err, "") << ending;
    EXPECT_EQ(read_text(new_plan_), read_text(plan_)) << ending;
  }
}

TEST_F(ImportOntoLine, has_coordinates_as_numbers_in_workbooks) {
  // Cells of XLSX with a text have t="s"; those of ODS a value type.
  const Outcome xlsx =
      run_command({"python3", "-c",
                   "import re, sys, zipfile\n"
                   "z = zipfile.ZipFile(sys.argv[1])\n"
                   "sheet = [z.read(n).decode() for n in z.namelist() if 'sheet' in n and b'0.012' "
                   "in z.read(n)]\n"
                   "print(re.findall(r'<c [^>]*>\\s*<v>(?:0.02|0.012|-0.006)</v>', sheet[0]))",
                   exported(plan_, ".xlsx")});
  EXPECT_THAT(xlsx.out, HasSubstr("<v>0.02</v>")) << xlsx.err;
  EXPECT_THAT(xlsx.out, ::testing::Not(HasSubstr("t=")));
  const Outcome ods =
      run_command({"python3", "-c",
                   "import sys, zipfile\n"
                   "print(zipfile.ZipFile(sys.argv[1]).read('content.xml').decode())",
                   exported(plan_, ".ods")});
  EXPECT_THAT(ods.out, HasSubstr("office:value-type=\"float\" office:value=\"0.02"));
  EXPECT_THAT(ods.out, ::testing::Not(HasSubstr("<text:p>0.020</text:p>")));
}

TEST_F(ImportOntoLine, new_lines_begin_where_the_rover_stands_and_know_the_places_of_the_plan) {
  const std::string sheet = folder_.write("more.csv",
                                          "Rover,Sequence,Type,Name,Place\n"
                                          "SEV A,40,PathPlanRoute,Loop,Rim; Ridge\n"
                                          "SEV B,10,PathPlanRoute,Over,ridge; Gate\n");
  const Outcome outcome = onto(sheet, plan_);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("  note: 'ridge' is taken for 'Ridge'\n"));
  const std::string text = read_text(new_plan_);
  EXPECT_THAT(text, HasSubstr("0.001,0 0.020,0.004 0.012,-0.006<"));
  EXPECT_THAT(text, HasSubstr("0.03,0 0.012,-0.006 0.001,0<"));
}

TEST_F(ImportOntoLine, a_sheet_without_places_moves_nothing_that_is_called_as_one) {
  const std::string sheet = folder_.write("names.csv",
                                          "Rover,Sequence,Type,Name,Speed (km/h)\n"
                                          "SEV A,30,PathPlanRoute,Rim,3\n");
  const std::string places = folder_.write("places.csv", "Name,Lon,Lat\nRim,0.020,0.004\n");
  const Outcome outcome =
      run({"import", sheet, places, "--onto", plan_, "-o", new_plan_, "--force"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("  changed: SEV A/30 PathPlanRoute 'Home': name = Rim, was "
                                     "Home; Speed = 3 km/h\n"));
  EXPECT_THAT(read_text(new_plan_), HasSubstr("0.02,0.004 0.012,-0.006 0.001,0<"));
}

TEST_F(ImportOntoLine, a_place_that_moves_takes_its_placemark_with_it) {
  const std::string sheet = folder_.write("moved.csv",
                                          "Type,Rover,Sequence,Name,Place,Lon,Lat,Notes,Duration\n"
                                          "Place,,,Ridge,,0.0125,-0.006,,\n"
                                          "Place,,,Edge,,0.020,0.004,,\n"
                                          "Pause,SEV A,5,First,,,,,1 h\n"
                                          "PathPlanRoute,SEV A,10,To the rim,Edge,,,slowly,\n"
                                          "PathPlanRoute,SEV A,30,Home,Ridge; Gate,,,,\n");
  const Outcome outcome = onto(sheet, plan_);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              HasSubstr("  note: the place 'Edge' is where the plan has 'Rim', which keeps its "
                        "name\n"));
  EXPECT_THAT(outcome.out, HasSubstr("  moved: the place 'Ridge' to 0.0125,-0.006, was "
                                     "0.012,-0.006\n"));
  EXPECT_THAT(
      outcome.out,
      HasSubstr("  changed: SEV A/10 PathPlanRoute 'To the rim': description = 'slowly'\n"));
  EXPECT_THAT(outcome.out, HasSubstr("SEV A/30 PathPlanRoute 'Home': place = 0.02,0.004 > "
                                     "0.0125,-0.006 > 0.001,0, was 0.02,0.004 > 0.012,-0.006 > "
                                     "0.001,0\n"));
  const std::string text = read_text(new_plan_);
  EXPECT_THAT(text, HasSubstr("<coordinates>0.0125,-0.006<"));
  EXPECT_THAT(text, ::testing::Not(HasSubstr("0.012,-0.006")));
}

TEST_F(ImportOntoLine, a_sheet_of_another_plan_moves_no_place) {
  const std::string sheet = folder_.write("other.csv",
                                          "Type,Rover,Sequence,Name,Lon,Lat,Duration\n"
                                          "Place,,,Ridge,0.1,0.1,\nPause,Other,10,,,,1 h\n");
  const Outcome outcome = onto(sheet, plan_);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("is it the sheet of another plan?"));
  const Outcome places =
      onto(folder_.write("places.csv", "Name,Lon,Lat\nRidge,0.0125,-0.006\n"), plan_);
  EXPECT_THAT(places.out, HasSubstr("  moved: the place 'Ridge' to 0.0125,-0.006")) << places.err;
}

TEST_F(ImportOntoLine, a_row_without_a_sequence_is_told_once) {
  const Outcome cell =
      onto(folder_.write("cell.csv", "Rover,Sequence,Type,Duration\nSEV A,,Pause,1 h\n"), plan_);
  EXPECT_EQ(cell.exit_code, 2);
  EXPECT_EQ(std::ranges::count(cell.err, '\n'), 1) << cell.err;
  const Outcome column =
      onto(folder_.write("column.csv", "Rover,Type,Duration\nSEV A,Pause,1 h\nSEV A,Pause,1 h\n"),
           plan_);
  EXPECT_EQ(column.exit_code, 2);
  EXPECT_EQ(std::ranges::count(column.err, '\n'), 1) << column.err;
}

TEST_F(ImportOnto, a_sheet_of_its_header_alone_removes_the_last_asset) {
  const std::string file = plan("drats_day");
  const std::string sheet = folder_.write("x-Assets.csv", "Asset Id,Asset Type,Lon,Lat\n");
  const std::string events =
      folder_.write("x-Events.csv", "Rover,Sequence,Type,Duration\nA,110,Recharge,12 h\n");
  const Outcome outcome = run({"import", sheet, events, "--onto", file, "-o", new_plan_});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("removes 22 of them")) << "21 events and the asset";
  EXPECT_THAT(onto(events, file).out, HasSubstr("removes 21 of them"));
}

TEST_F(ImportOnto, tells_what_does_not_fit) {
  const Outcome other = onto(exported(plan("two_rovers"), ".csv"), plan("drats_day"));
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_THAT(other.err, HasSubstr("sheet.csv: none of its 10 rows is of a rover, an asset or an "
                                   "event of"));
  EXPECT_THAT(other.err, HasSubstr("whose rovers are A, B; is it the sheet of another plan?"));
  const std::string sheet = folder_.write("rover.csv",
                                          "Rover,Type,Sequence,Duration\nA,Pause,11,1 h\n"
                                          "C,Pause,10,1 h\n");
  const Outcome unknown = onto(sheet, plan("drats_day"));
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("rover.csv:A3: Pause 10: RoverId = 'C': there is no such "
                                     "rover"));
  EXPECT_FALSE(fs::exists(new_plan_));
}

}  // namespace
}  // namespace lsos::test
