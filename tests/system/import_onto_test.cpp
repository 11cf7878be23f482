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
  EXPECT_EQ(outcome.out,
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
