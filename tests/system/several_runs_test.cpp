// `compare` and `report` of several runs, and of a run and telemetry, their pages in a browser.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "system/browser.h"
#include "system/run_folder.h"
#include "system/source_files.h"

namespace lsos::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

// All tests share three runs of two rovers: A, B in which A's pause is 10 s longer, and C as A.
class SeveralRunsPage : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TempFolder;
    const auto rover = [](const std::string& id, const std::string& place) {
      return Mark{"Rover", {{"RoverId", id}, {"RoverType", "SEV"}}, point(place)};
    };
    const auto make_run = [&](const std::string& name, const std::string& pause_s) {
      const std::string plan = folder_->write(
          name + ".kml", kml({mission(), rover("A", "-27,0"), rover("B", "-27,0.002"),
                              event("Pause", "A", 1, {{"Duration", pause_s}}),
                              event("Route", "A", 2, {}, line("-26.9995,0 -26.999,0.0003")),
                              event("Pause", "B", 1, {{"Duration", "20"}})}));
      const Outcome outcome = run({plan, "-o", *folder_ / name, "--quiet", "--no-report"});
      ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    };
    make_run("first", "20");
    make_run("longer", "30");
    std::filesystem::copy(*folder_ / "first", *folder_ / "same");
  }
  static void TearDownTestSuite() { delete folder_; }
  static Words folders() { return {*folder_ / "first", *folder_ / "longer", *folder_ / "same"}; }
  static Outcome program(Words arguments, const Words& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  static std::string page_of(const Words& runs, const std::string& name) {
    Words arguments{"report"};
    arguments.insert(arguments.end(), runs.begin(), runs.end());
    const Outcome outcome = program(arguments, {"-o", *folder_ / name});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return *folder_ / name;
  }

  static inline TempFolder* folder_ = nullptr;
};

TEST_F(SeveralRunsPage, is_one_small_file_that_loads_nothing) {
  const std::string page = read_text(page_of(folders(), "page.html"));
  EXPECT_THAT(page, StartsWith("<!doctype html>"));
  const std::regex loads(R"re((src|href)\s*=\s*["']?(https?:)?//|url\(\s*["']?http|@import)re");
  EXPECT_FALSE(std::regex_search(page, loads));
  EXPECT_LT(page.size(), 1'500'000u);
}

TEST_F(SeveralRunsPage, has_all_runs_in_its_plots_map_and_tables) {
  if (browser().empty()) GTEST_SKIP() << "no Chromium is installed";
  const json seen = in_browser(*folder_, page_of(folders(), "page.html"), R"js(
    const keys = name => [...document.querySelectorAll(`#plot-${name} .keys > span`)].filter(key => !key.hidden);
    const names = name => keys(name).map(key => key.childNodes[1].textContent);
    const cells = line => [...line.children].map(cell => cell.textContent.trim());
    const energy = plot('energy');
    energy.scrollIntoView();
    await rest();
    await move(energy, 0.5);
    const first = names('energy'), clock = text('#clock-elapsed');
    const legend = document.querySelectorAll('.chip.run');
    await click(legend[1]);
    const hidden = names('energy'), arrow = document.getElementById('rover-B A').getAttribute('visibility');
    const choice = document.getElementById('rover-choice');
    choice.value = '';
    choice.dispatchEvent(new Event('change'));
    await rest();
    return {first, hidden, arrow, clock, all: names('energy'), legend: [...legend].map(chip => chip.textContent),
      bars: document.querySelectorAll('.bar-names span').length,
      arrows: document.querySelectorAll('[id^="rover-"][id$=" A"]').length,
      pressed: [...legend].map(chip => chip.getAttribute('aria-pressed')),
      totals: document.querySelectorAll('#rover-table tbody tr').length,
      differing: [...document.querySelectorAll('#event-table tbody tr')].map(cells),
      findings: text('#findings')};
  )js");
  ASSERT_FALSE(seen.contains("error")) << seen;
  EXPECT_EQ(seen["first"], json({"A A", "B A", "C A"}));
  EXPECT_EQ(seen["hidden"], json({"A A", "C A"}));
  EXPECT_EQ(seen["arrow"], "hidden");
  EXPECT_EQ(seen["all"], json({"A A", "A B", "C A", "C B"}));
  EXPECT_EQ(seen["legend"], json({"Afirst", "Blonger", "Csame"}));
  EXPECT_EQ(seen["pressed"], json({"true", "false", "true"}));
  EXPECT_EQ(seen["bars"], 6);
  EXPECT_EQ(seen["arrows"], 3);
  EXPECT_EQ(seen["totals"], 6);
  ASSERT_GE(seen["differing"].size(), 2u);
  EXPECT_THAT(seen["differing"][0].dump(), HasSubstr("A/1 Pause 1"));
  EXPECT_THAT(seen["differing"][1].dump(), HasSubstr("B longer"));
  EXPECT_THAT(seen["differing"][1].dump(), HasSubstr("+10 s"));
  EXPECT_THAT(seen["findings"].get<std::string>(), HasSubstr("1 came to the same as A"));
}

TEST_F(SeveralRunsPage, of_eleven_runs_stays_small) {
  Words eleven;
  for (int k = 0; k < 11; ++k) eleven.push_back(folders()[static_cast<std::size_t>(k % 3)]);
  EXPECT_LT(read_text(page_of(eleven, "eleven.html")).size(), 2'500'000u);
  eleven.push_back(folders()[0]);
  const Outcome twelve = program({"report", "-o", *folder_ / "twelve.html"}, eleven);
  EXPECT_EQ(twelve.exit_code, 2);
  EXPECT_THAT(twelve.err, HasSubstr("12 runs: at most 11 fit over each other"));
}

TEST_F(SeveralRunsPage, is_of_one_planet) {
  std::string text =
      kml({mission(), sev("A", "-27,0"), event("Pause", "A", 1, {{"Duration", "1"}})});
  text.replace(text.find(">Moon<"), 6, ">Mars<");
  const std::string plan = folder_->write("mars.kml", text);
  ASSERT_EQ(run({plan, "-o", *folder_ / "mars", "--quiet", "--no-report"}).exit_code, 0);
  const Outcome outcome =
      program({"report", "-o", *folder_ / "both.html"}, {*folder_ / "first", *folder_ / "mars"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("mars: is a run on Mars, "));
  EXPECT_THAT(outcome.err, HasSubstr("only runs on one planet fit over each other"));
}

TEST_F(SeveralRunsPage, compare_has_a_table_of_each_event_that_differs) {
  const Outcome text = program({"compare"}, folders());
  EXPECT_EQ(text.exit_code, 1);
  EXPECT_THAT(text.out, HasSubstr("same: completed, equal to A, log and all\n"));
  EXPECT_THAT(text.out, HasSubstr("event A/1 Pause 1\n"));
  const json answer = json::parse(program({"compare", "--json"}, folders()).out);
  EXPECT_EQ(answer["equal"], false);
  EXPECT_EQ(answer["runs"][2]["equal"], true);
  const json& pause = answer["events"][0];
  EXPECT_EQ(pause["label"], "Pause 1");
  EXPECT_EQ(pause["runs"][1]["end_s"].get<double>() - pause["runs"][0]["end_s"].get<double>(), 10);
  EXPECT_EQ(program({"compare", "--exact"}, folders()).exit_code, 1);
  const Words alike{folders()[0], folders()[2], folders()[0]};
  EXPECT_EQ(program({"compare"}, alike).exit_code, 0);
  EXPECT_EQ(program({"compare", "--exact"}, alike).exit_code, 0);
}

// The run's own log, with the rover's speed 0.05 m/s too high in other units, is measured again.
TEST_F(SeveralRunsPage, telemetry_lies_over_a_run_with_its_residuals) {
  const std::string log = *folder_ / "first/log.gpkg";
  const std::string table = folder_->write(
      "measured.csv",
      "time_s;rover_id;Speed (km/h);lon_deg;lat_deg\n" +
          run_command({"sqlite3", "-readonly", log,
                       "SELECT printf('%.1f;%s;%.17g;%.17g;%.17g', time_s, rover_id, "
                       "3.6 * (speed_mps + 0.05), lon_deg, lat_deg) FROM samples "
                       "WHERE rover_id = 'A' ORDER BY fid"})
              .out +
          "1;Z;1;1;1\n");
  const Outcome outcome =
      run({"compare", *folder_ / "first", table, "--json", "-o", *folder_ / "telemetry.html"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("warning: there is no rover 'Z' in the run; it has A, B"));
  const json answer = json::parse(outcome.out);
  const json& speed = answer["residuals"][0];
  EXPECT_EQ(speed["quantity"], "speed_mps");
  EXPECT_NEAR(speed["mean"].get<double>(), 0.05, 1e-9);
  EXPECT_NEAR(speed["rms"].get<double>(), 0.05, 1e-9);
  EXPECT_LT(std::abs(answer["residuals"][3]["greatest"].get<double>()), 1e-6);
  EXPECT_EQ(answer["unusable"].size(), 1u);

  if (browser().empty()) GTEST_SKIP() << "no Chromium is installed";
  const json seen = in_browser(*folder_, *folder_ / "telemetry.html", R"js(
    const measured = plot('speed_mps');
    measured.scrollIntoView();
    await rest();
    await move(measured, 0.5);
    return {values: [...document.querySelectorAll('#plot-speed_mps output')].map(o => Number(o.textContent)),
      plots: [...document.querySelectorAll('.plot')].map(p => p.id), findings: text('#findings'),
      places: document.querySelectorAll('path.measured').length,
      first: [...document.querySelectorAll('#rover-table tbody tr')].map(line => line.textContent)};
  )js");
  ASSERT_FALSE(seen.contains("error")) << seen;
  EXPECT_EQ(seen["plots"],
            json({"plot-speed_mps", "plot-speed_mps-residual", "plot-place_along_m-residual",
                  "plot-place_across_m-residual", "plot-place_distance_m-residual"}));
  EXPECT_NEAR(seen["values"][1].get<double>() - seen["values"][0].get<double>(), 0.05, 0.02);
  EXPECT_EQ(seen["places"], 2);
  EXPECT_THAT(seen["findings"].get<std::string>(), HasSubstr("there is no rover 'Z'"));
  EXPECT_EQ(seen["first"].size(), 4u);
}

TEST_F(SeveralRunsPage, telemetry_of_which_no_row_can_be_used_is_an_error) {
  const std::string table = folder_->write("wrong.csv", "time_s,rover_id,chrage\n1,A,0.5\n");
  const Outcome outcome = run({"compare", *folder_ / "first", table});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("wrong.csv:1: column 'chrage': a run logs no such quantity; "
                                     "did you mean 'charge'?"));
  EXPECT_THAT(outcome.err, HasSubstr("wrong.csv:1: there is no column to compare"));
}

}  // namespace
}  // namespace lsos::test
