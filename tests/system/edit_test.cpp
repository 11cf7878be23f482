// `lsos-host edit` as a planner uses it, on shipped plans.

#include <gmock/gmock.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "base/replaced.h"
#include "system/kml_file.h"
#include "system/plan_text.h"
#include "system/process.h"
#include "system/source_files.h"
#include "system/temp_folder.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

class Edit : public ::testing::Test {
 protected:
  Outcome edit(const std::string& plan, const Words& words) const {
    Words all{"edit", plan};
    all.insert(all.end(), words.begin(), words.end());
    all.insert(all.end(), {"-o", new_plan_, "--force"});
    return run(all);
  }
  // The new plan, which `check` must find good.
  std::string edited(const std::string& plan, const Words& words, const std::string& result) const {
    const Outcome outcome = edit(plan, words);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, result + "; wrote " + new_plan_ + "\n");
    return canonical(new_plan_);
  }

  TempFolder folder_;
  std::string new_plan_ = folder_ / "new.kml";
};

TEST_F(Edit, renumber_changes_sequences_alone) {
  const std::string before = canonical(plan("drats_day"));
  const std::string after =
      edited(plan("drats_day"), {"renumber", "--step", "5"}, "22 events renumbered");
  const std::regex sequence(R"(name="Sequence">[0-9]+<)");
  EXPECT_EQ(std::regex_replace(after, sequence, "name=\"Sequence\">N<"),
            std::regex_replace(before, sequence, "name=\"Sequence\">N<"));
  // In steps of ten again it is the plan that it was.
  const std::string twice = folder_.write("twice.kml", read_text(new_plan_));
  EXPECT_EQ(edited(twice, {"renumber"}, "22 events renumbered"), before);
}

TEST_F(Edit, shift_there_and_back_changes_nothing) {
  edited(plan("drats_day"), {"shift", "--by", "+1 d"}, "3 times moved by +1 d");
  const std::string there = folder_.write("there.kml", read_text(new_plan_));
  EXPECT_THAT(read_text(there), HasSubstr("2010-09-01T15:00:00Z"));
  EXPECT_EQ(edited(there, {"shift", "--by", "-24h"}, "3 times moved by -24h"),
            canonical(plan("drats_day")));
}

TEST_F(Edit, enable_takes_back_what_disable_did) {
  const std::string disabled =
      edited(plan("drats_day"), {"disable", "--type", "EVA", "--rover", "A"}, "2 events disabled");
  const std::string enabled = "<SimpleData name=\"Enabled\">true</SimpleData>";
  const std::string off = folder_.write("off.kml", read_text(new_plan_));
  EXPECT_EQ(edited(off, {"enable", "A/10..1000"}, "2 events enabled, 9 were so already"),
            replaced(disabled, "<SimpleData name=\"Enabled\">false</SimpleData>", enabled));
}

TEST_F(Edit, an_event_is_of_the_day_on_which_it_is_expected) {
  const std::string long_day = folder_.write(
      "long.kml",
      kml({mission(), sev("A", "0,0"), sev("B", "0,0.001"),
           event("Pause", "A", 10, {{"Duration", "30 h"}}),
           event("Pause", "A", 20, {{"Duration", "60"}}),
           event("Pause", "B", 10, {{"Duration", "60"}, {"StartAfter", "A/20"}}),
           event("Pause", "B", 20, {{"Duration", "60"}, {"StartTime", "2026-01-03"}})}));
  edited(long_day, {"disable", "--day", "2"}, "2 events disabled");
  edited(long_day, {"disable", "--day", "3"}, "1 event disabled");
  // What the new plan is warned of, and the old one was not.
  EXPECT_THAT(edit(long_day, {"disable", "A/20"}).err,
              HasSubstr("new.kml:32: warning: Pause 10: StartAfter = 'A/20': is disabled, and "
                        "counts as ended from the beginning"));
}

TEST_F(Edit, enable_finds_the_days_that_disable_meant) {
  const std::string days = folder_.write(
      "days.kml", kml({mission(), sev("A", "0,0"), event("Pause", "A", 10, {{"Duration", "20 h"}}),
                       event("Pause", "A", 20, {{"Duration", "20 h"}}),
                       event("Pause", "A", 30, {{"Duration", "20 h"}}),
                       event("Pause", "A", 40, {{"Duration", "20 h"}})}));
  edited(days, {"disable", "--day", "1..2"}, "3 events disabled");
  const std::string off = folder_.write("off.kml", read_text(new_plan_));
  edited(off, {"enable", "--day", "1..2"}, "3 events enabled");
}

TEST_F(Edit, leaves_out_the_estimate_of_the_old_plan) {
  const std::string noted = folder_ / "noted.kml";
  ASSERT_EQ(run({"check", plan("two_rovers"), "--kml", noted, "--quiet"}).exit_code, 0);
  const Outcome outcome = edit(noted, {"renumber"});
  EXPECT_THAT(outcome.err, HasSubstr("warning: the estimate in " + noted + " is left out"));
  EXPECT_EQ(read_text(new_plan_).find("=\"lsos-"), std::string::npos);
  EXPECT_EQ(read_text(new_plan_).find("lsos-estimate"), std::string::npos);
}

TEST_F(Edit, shift_wants_a_unit_and_tells_of_events_without_a_time) {
  EXPECT_THAT(edit(plan("drats_day"), {"shift", "--by", "1"}).err,
              HasSubstr("--by 1: its unit is wanted, as in '1 d', '1 h' or '1 min'"));
  const std::string pauses = folder_.write(
      "pauses.kml",
      kml({mission(), sev("A", "0,0"), event("Pause", "A", 10, {{"Duration", "60"}}),
           event("Pause", "A", 20, {{"Duration", "60"}, {"StartTime", "2026-01-02T00:00:00Z"}})}));
  EXPECT_THAT(edit(pauses, {"shift", "--by", "1 d", "--from", "A/10"}).err,
              HasSubstr("A/10: Pause 'Pause 10' says no time of its own"));
}

TEST_F(Edit, a_repeated_day_can_be_split_off_again) {
  edited(plan("drats_day"), {"repeat", "--day", "1", "--times", "1"},
         "22 events of day 1 repeated 1 time, 22 events added");
  const std::string days = folder_.write("days.kml", read_text(new_plan_));
  const Outcome outcome =
      edit(days, {"split", "--day", "2", "--charge", "A=0.8", "--charge", "B=0.7"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("22 events of day 2 kept, 22 left out"));
  EXPECT_THAT(read_text(new_plan_), HasSubstr("2010-09-01T15:00:00Z"));
  EXPECT_THAT(read_text(new_plan_), HasSubstr("name=\"InitialCharge\">0.8<"));
}

// Estimates of the plan's events of one rover, by sequence and column; numbers without ranges.
std::map<int, std::map<std::string, double>> estimates(const std::string& plan) {
  const TempFolder folder;
  const Outcome outcome = run({"check", plan, "--csv", folder / "events.csv", "--quiet"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  std::istringstream table(read_text(folder / "events.csv"));
  const auto cells = [](const std::string& line) {
    std::istringstream row(line);
    std::vector<std::string> all;
    for (std::string cell; std::getline(row, cell, ',');) all.push_back(cell);
    return all;
  };
  std::string line;
  std::getline(table, line);
  const std::vector<std::string> header = cells(line);
  std::map<int, std::map<std::string, double>> of;
  while (std::getline(table, line)) {
    const std::vector<std::string> row = cells(line);
    auto& event = of[std::stoi(row.at(1))];
    for (std::size_t i = 4; i < row.size(); ++i) event[header.at(i)] = std::atof(row[i].c_str());
  }
  return of;
}

// Two days in the dark, so that all that is used is seen in the charge. `rest`: how long the last
// event of the first day takes.
std::string two_days(const std::string& rest) {
  return kml({mission(), sev("A", "-149,12"),
              event("PathPlanRoute", "A", 10, {}, point("-148.96,12.02")),
              event("Consume", "A", 20, {{"Power", "500 W"}, {"Duration", "4 h"}}),
              event("Pause", "A", 30, {{"Duration", rest}}),
              event("Route", "A", 40, {{"StartTime", "2026-01-02T06:00:00Z"}},
                    line("-148.96,12.02 -148.96,12.05 -148.94,12.05")),
              event("Pause", "A", 50, {{"Duration", "3 h"}})});
}

TEST_F(Edit, a_day_that_is_split_off_goes_as_in_the_whole_plan) {
  const std::string whole = folder_.write("whole.kml", two_days("12 h"));
  const Outcome outcome = edit(whole, {"split", "--day", "2"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(
      outcome.out,
      ::testing::ContainsRegex(
          "2 events of day 2 kept, 3 left out; A at -148[.]9[56][0-9]+,12[.][0-9]+, heading "
          "[0-9]+, with [0-9.]+ %, by the estimate of the days before; wrote"));
  EXPECT_EQ(outcome.err, "");
  const auto in_whole = estimates(whole), alone = estimates(new_plan_);
  ASSERT_EQ(alone.size(), 2u);
  for (const auto& [sequence, event] : alone) {
    const auto &as_before = in_whole.at(sequence), &now = event;
    const auto difference = [&](const char* name) { return now.at(name) - as_before.at(name); };
    EXPECT_NEAR(difference("start_s"), -86400, 0.1) << sequence;
    EXPECT_NEAR(difference("end_s"), -86400, 0.2) << sequence;
    EXPECT_NEAR(difference("distance_m"), 0, 0.05) << sequence;
    EXPECT_NEAR(difference("energy_used_j"), 0, 500) << sequence;
    EXPECT_NEAR(difference("charge_end"), 0, 1e-5) << sequence;
  }
  EXPECT_LT(in_whole.at(40).at("charge_end"), 0.9) << "it is not that of a new rover";
}

TEST_F(Edit, a_rover_whose_event_goes_on_begins_as_it_ends) {
  const std::string whole = folder_.write("whole.kml", two_days("21 h"));
  const Outcome outcome = edit(whole, {"split", "--day", "2"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err,
            "warning: Rover 'A': 'Pause 30' goes on when day 2 begins; the rover begins as that "
            "ends\n");
}

TEST_F(Edit, a_day_that_is_split_off_may_be_given_its_charge) {
  const std::string days = folder_.write(
      "days.kml",
      kml({mission(), sev("A", "0,0"), event("Pause", "A", 10, {{"Duration", "2 h"}}),
           event("Pause", "A", 20, {{"Duration", "60"}, {"StartTime", "2026-01-02T06:00:00Z"}})}));
  const Outcome outcome = edit(days, {"split", "--day", "2", "--charge", "A=0.4"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr(", with 40.0 % (--charge), by the estimate of"));
  EXPECT_THAT(read_text(new_plan_), HasSubstr("name=\"InitialCharge\">0.4<"));
}

TEST_F(Edit, merges_a_plan_and_its_mirrored_rover) {
  const auto one = [](const std::string& rover, const std::string& at) {
    return kml({mission(), sev(rover, at), event("Pause", rover, 10, {{"Duration", "60"}})});
  };
  const std::string first = folder_.write("first.kml", one("A", "0,0"));
  const std::string second = folder_.write("second.kml", one("B", "0,0.001"));
  edited(first, {"merge", second}, "1 rover and 1 event of 1 plan merged");
  const std::string both = folder_.write("both.kml", read_text(new_plan_));
  edited(both, {"mirror", "--from", "A", "--to", "B"}, "1 event of A copied for B");
  EXPECT_EQ(run({new_plan_, "-o", folder_ / "run", "--quiet", "--no-report"}).exit_code, 0);
}

TEST_F(Edit, writes_nothing_where_the_new_plan_would_be_wrong) {
  const std::string both = folder_.write(
      "both.kml",
      kml({mission(), sev("A", "0,0"), sev("B", "0,0.001"),
           event("Rendezvous", "A", 10, {{"With", "B"}}),
           event("Pause", "A", 20, {{"Duration", "60"}, {"StopWhen", "distance_to('B') &lt; 10"}}),
           event("Pause", "B", 10, {{"Duration", "60"}})}));
  const Outcome outcome = edit(both, {"mirror", "--from", "A", "--to", "B"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("new.kml: is not written, as the edited plan would have "
                                     "faults (lines are its own, but of copies those of what was "
                                     "copied)"));
  const std::string text = read_text(both);
  const std::string before = text.substr(0, text.find("StopWhen"));
  const auto line = 1 + std::ranges::count(before.substr(0, before.rfind("<Placemark")), '\n');
  EXPECT_THAT(outcome.err,
              HasSubstr("both.kml:" + std::to_string(line) + ": its copy B/30: Pause "));
  EXPECT_THAT(outcome.err, HasSubstr(": StopWhen = distance_to('B') < 10"));
  EXPECT_FALSE(fs::exists(new_plan_));
}

// In a document without line breaks the copy and what was copied begin on the same line.
TEST_F(Edit, tells_faults_of_copies_at_what_was_copied_in_a_document_of_one_line) {
  std::string text = kml(
      {mission(), sev("A", "0,0"), sev("B", "0,0.001"),
       event("Pause", "A", 10, {{"Duration", "60"}, {"StopWhen", "distance_to('B') &lt; 10"}})});
  std::ranges::replace(text, '\n', ' ');
  const std::string one = folder_.write("one.kml", text);
  const Outcome outcome = edit(one, {"mirror", "--from", "A", "--to", "B"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("one.kml:1: its copy B/10: Pause "));
  EXPECT_THAT(outcome.err, Not(HasSubstr("new.kml:1")));
}

TEST_F(Edit, tells_the_faults_of_a_wrong_plan) {
  const std::string wrong = folder_.write(
      "wrong.kml",
      kml({mission(), sev("A", "0,0"), event("Pause", "A", 10, {{"Duratoin", "60"}})}));
  const Outcome outcome = edit(wrong, {"renumber"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("did you mean 'Duration'?"));
  EXPECT_FALSE(fs::exists(new_plan_));
}

TEST_F(Edit, replaces_a_file_only_by_force) {
  const std::string file = folder_.write("plan.kml", read_text(plan("two_rovers")));
  const Outcome refused = run({"edit", file, "renumber", "--step", "7", "-o", file});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_EQ(read_text(file), read_text(plan("two_rovers")));
  EXPECT_EQ(run({"edit", file, "renumber", "--step", "7", "-o", file, "--force"}).exit_code, 0);
  EXPECT_THAT(read_text(file), HasSubstr(">7<"));
}

// Edits a KMZ of a document and a picture, as map tools make them.
TEST_F(Edit, keeps_the_other_files_of_a_kmz) {
  const std::string kmz = folder_ / "plan.kmz", new_kmz = folder_ / "new.kmz";
  const auto python = [&](const std::string& script, const Words& words) {
    Words all{"python3", "-c", "import sys, zipfile\n" + script};
    all.insert(all.end(), words.begin(), words.end());
    const Outcome outcome = run_command(all);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.out;
  };
  python(
      "z = zipfile.ZipFile(sys.argv[1], 'w')\nz.writestr('files/a.png', 'a picture')\n"
      "z.write(sys.argv[2], 'mine.kml')\nz.close()",
      {kmz, plan("two_rovers")});
  const Outcome refused = run({"edit", kmz, "renumber", "-o", new_plan_});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("new.kml: the name must end in .kmz, as the plan is that"));
  const Outcome outcome = run({"edit", kmz, "renumber", "--step", "7", "-o", new_kmz});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(python("z = zipfile.ZipFile(sys.argv[1])\nprint(z.namelist(), z.read('files/a.png'), "
                   "b'>7<' in z.read('mine.kml'))",
                   {new_kmz}),
            "['files/a.png', 'mine.kml'] b'a picture' True\n");
}

TEST_F(Edit, says_what_to_do_with_a_geopackage) {
  const std::string layers = folder_ / "plan.gpkg";
  ASSERT_EQ(run_command({"ogr2ogr", "-f", "GPKG", layers, plan("two_rovers")}).exit_code, 0);
  const Outcome outcome = edit(layers, {"renumber"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("is a GeoPackage, and KML or KMZ is edited: save it as KML"));
}

}  // namespace
}  // namespace lsos::test
