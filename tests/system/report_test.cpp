// report.html in a browser, its figure, and `lsos-host compare`.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "record/log.h"
#include "system/browser.h"
#include "system/run_folder.h"
#include "system/source_files.h"

namespace lsos::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

// The data embedded in a page.
json data_of(const std::string& page) {
  const std::string key = "<script type=\"application/json\" id=\"data\">";
  const std::size_t begin = page.find(key) + key.size();
  return json::parse(page.substr(begin, page.find("</script>", begin) - begin), nullptr, false);
}

// Parses a number as the page writes it, with a Unicode minus sign.
double number(std::string text) {
  const std::size_t minus = text.find("\u2212");
  if (minus != std::string::npos) text.replace(minus, std::string("\u2212").size(), "-");
  return std::stod(text);
}

// Seconds of a time such as "00:01:05".
double clock_s(const std::string& text) {
  return 3600 * std::stod(text.substr(0, 2)) + 60 * std::stod(text.substr(3, 2)) +
         std::stod(text.substr(6, 2));
}

// All tests share one run of two rovers, in which one label has text that would end a <script>.
class Report : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TempFolder;
    const auto rover = [](const std::string& id, const std::string& place) {
      return Mark{
          "Rover", {{"RoverId", id}, {"RoverType", "SEV"}, {"InitialCharge", "0.5"}}, point(place)};
    };
    std::string text = kml({mission(), rover("A", "-27,0"), rover("B", "-27,0.002"),
                            event("Route", "A", 1, {}, line("-26.9995,0 -26.999,0.0003")),
                            event("Pause", "A", 2, {{"Duration", "20"}}),
                            event("Drill", "B", 1, {{"Duration", "30 min"}, {"Depth", "2"}}),
                            event("Pause", "B", 2, {{"Duration", "20"}})});
    const std::string mark = "<Placemark>";
    text.insert(text.rfind(mark) + mark.size(),
                "<name>&lt;/script&gt;&lt;b&gt;'&quot;&amp;</name>");
    const std::string plan = folder_->write("plan.kml", text);
    const Outcome outcome = run({plan, "-o", *folder_ / "run", "--quiet"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    page_ = new std::string(read_text(*folder_ / "run/report.html"));
  }
  static void TearDownTestSuite() {
    delete folder_;
    delete page_;
  }
  static std::string log() { return *folder_ / "run/log.gpkg"; }
  // Logged value of a rover at the sample nearest to a time.
  static double logged(const std::string& column, const std::string& rover, double time_s) {
    return std::stod(query(log(), "SELECT " + column + " FROM samples WHERE rover_id = '" + rover +
                                      "' ORDER BY abs(time_s - " + std::to_string(time_s) +
                                      ") LIMIT 1"));
  }
  static json in_page(const std::string& steps) {
    return in_browser(*folder_, *folder_ / "run/report.html", steps);
  }

  static inline TempFolder* folder_ = nullptr;
  static inline std::string* page_ = nullptr;
};

TEST_F(Report, is_left_by_a_run_and_loads_nothing) {
  EXPECT_THAT(*page_, StartsWith("<!doctype html>"));
  EXPECT_THAT(*page_, HasSubstr("default-src 'none'; img-src data:;"));
  const std::regex loads(R"re((src|href)\s*=\s*["']?(https?:)?//|url\(\s*["']?http|@import)re");
  EXPECT_FALSE(std::regex_search(*page_, loads));
  EXPECT_LT(page_->size(), 3'000'000u);
}

TEST_F(Report, holds_the_run) {
  const json data = data_of(*page_);
  ASSERT_TRUE(data.is_object());
  EXPECT_EQ(data["summary"]["status"], "completed");
  EXPECT_EQ(data["rovers"].size(), 2u);
  EXPECT_EQ(std::to_string(data["rovers"][0]["samples"].get<int>()),
            query(log(), "SELECT count(*) FROM samples WHERE rover_id = 'A'"));
  EXPECT_EQ(data["events"][3]["label"], "</script><b>'\"&");
  EXPECT_FALSE(data["map"].is_null());
  EXPECT_FALSE(data["sight"].empty());
  EXPECT_EQ(data["distances"].size(), 1u);
  EXPECT_GE(data["pictures"].size(), 2u) << data["left_out"];
}

TEST_F(Report, shows_values_of_the_log_under_the_cursor) {
  if (browser().empty()) GTEST_SKIP() << "no Chromium is installed";
  const json seen = in_page(R"js(
    const energy = plot('energy');
    energy.scrollIntoView();
    await rest();
    await move(energy, 0);
    const before = document.querySelector('#rover-A').getAttribute('transform');
    await move(energy, 0.1);
    const outputs = key => [...document.querySelectorAll(`#plot-${key} output`)].map(o => o.textContent);
    const early = {energy: outputs('energy'), clock: text('#clock-elapsed'),
                   arrow: document.querySelector('#rover-A').getAttribute('transform')};
    plot('position').scrollIntoView();
    await rest();
    return {before, early, position: outputs('position'), unit: text('#plot-energy h3'),
            events: document.querySelectorAll('#event-table tbody tr').length,
            label: text('#event-table tbody tr:nth-child(4) td:nth-child(3)'),
            bold: document.querySelectorAll('#event-table b').length};
  )js");
  ASSERT_FALSE(seen.contains("error")) << seen;
  EXPECT_EQ(seen["events"], 4);
  EXPECT_EQ(seen["label"], "</script><b>'\"&");
  EXPECT_EQ(seen["bold"], 0);
  const double time_s = 0.1 * std::stod(query(log(), "SELECT max(time_s) FROM samples"));
  EXPECT_THAT(seen["unit"].get<std::string>(), HasSubstr("kWh"));
  EXPECT_NEAR(number(seen["early"]["energy"][0]), logged("energy_j", "A", time_s) / 3.6e6, 6e-4);
  EXPECT_NEAR(number(seen["early"]["energy"][1]), logged("energy_j", "B", time_s) / 3.6e6, 6e-4);
  // The position shown is the one of A, east and north.
  EXPECT_NEAR(number(seen["position"][0]), logged("x_m", "A", time_s), 0.06);
  EXPECT_NEAR(number(seen["position"][1]), logged("y_m", "A", time_s), 0.06);
  EXPECT_NE(seen["before"], seen["early"]["arrow"]);
}

TEST_F(Report, names_the_place_under_the_cursor) {
  if (browser().empty()) GTEST_SKIP() << "no Chromium is installed";
  const json seen = in_page(R"js(
    const svg = document.querySelector('#map svg'), box = svg.getBoundingClientRect();
    const arrow = document.querySelector('#rover-A').getAttribute('transform').match(/[-0-9.]+/g).map(Number);
    const k = box.width / svg.viewBox.baseVal.width;
    svg.dispatchEvent(new PointerEvent('pointermove', {
      bubbles: true, clientX: box.left + k * arrow[0], clientY: box.top + k * arrow[1],
    }));
    return {place: text('#map-place'), lines: document.querySelectorAll('.graticule polyline').length,
            labels: [...document.querySelectorAll('.graticule text')].map(label => label.textContent)};
  )js");
  ASSERT_FALSE(seen.contains("error")) << seen;
  const auto place = seen["place"].get<std::string>();
  std::smatch found;
  ASSERT_TRUE(std::regex_search(place, found, std::regex("^([0-9.]+)° N, ([0-9.]+)° W; ")))
      << place;
  // An arrow is placed to half a pixel of 0.3 m, which is 1e-5 degrees.
  const double end_s = std::stod(query(log(), "SELECT max(time_s) FROM samples"));
  EXPECT_NEAR(std::stod(found[1]), logged("lat_deg", "A", end_s), 2e-5);
  EXPECT_NEAR(-std::stod(found[2]), logged("lon_deg", "A", end_s), 2e-5);
  EXPECT_GE(seen["lines"], 4);
  EXPECT_THAT(seen["labels"].dump(), HasSubstr("° W"));
  EXPECT_THAT(seen["labels"].dump(), HasSubstr("° N"));
}

TEST_F(Report, shows_batteries_from_empty_to_full_and_pictures_large) {
  if (browser().empty()) GTEST_SKIP() << "no Chromium is installed";
  const json seen = in_page(R"js(
    plot('energy').scrollIntoView();
    await rest();
    const ticks = [...document.querySelectorAll('#plot-energy .dygraph-axis-label-y')].map(tick => Number(tick.textContent));
    await click(document.querySelector('.enlarge'));
    return {ticks, first: document.querySelector('.plot').id, value: text('#plot-energy output'),
            hasSolar: document.querySelector('#plot-solar') !== null,
            large: document.querySelector('dialog[open] img').src.slice(0, 16)};
  )js");
  ASSERT_FALSE(seen.contains("error")) << seen;
  EXPECT_EQ(seen["first"], "plot-energy");
  const auto ticks = seen["ticks"].get<std::vector<double>>();
  EXPECT_EQ(*std::ranges::min_element(ticks), 0);
  EXPECT_GE(*std::ranges::max_element(ticks), 40) << "the battery holds 40 kWh";
  const double end_s = std::stod(query(log(), "SELECT max(time_s) FROM samples"));
  EXPECT_THAT(seen["value"].get<std::string>(),
              HasSubstr(fmt::format(" {:.1f} %", 100 * logged("charge", "A", end_s))));
  EXPECT_EQ(seen["hasSolar"], true);
  EXPECT_EQ(seen["large"], "data:image/jpeg;");
  const json battery = data_of(*page_)["rovers"][0]["battery"];
  EXPECT_NEAR(battery["capacity_j"].get<double>(), 40 * 3.6e6, 1);
  EXPECT_NEAR(battery["reserve_j"].get<double>(), 4 * 3.6e6, 1);
}

TEST_F(Report, zooms_all_plots_by_dragging_and_back_by_a_double_click) {
  if (browser().empty()) GTEST_SKIP() << "no Chromium is installed";
  const json seen = in_page(R"js(
    const energy = plot('energy'), speed = plot('speed');
    energy.scrollIntoView();
    await rest();
    const isWhole = () => document.querySelector('#whole').disabled;
    const whole = isWhole();
    await drag(energy, 0.25, 0.75);
    const zoomed = isWhole();
    await move(speed, 0.5);
    const middle = text('#clock-elapsed');
    await move(speed, 0);
    const left = text('#clock-elapsed');
    await twice(speed);
    const again = isWhole();
    await move(energy, 0);
    return {whole, zoomed, middle, left, again, start: text('#clock-elapsed')};
  )js");
  ASSERT_FALSE(seen.contains("error")) << seen;
  const double end_s = std::stod(query(log(), "SELECT max(time_s) FROM samples"));
  EXPECT_EQ(seen["whole"], true);
  EXPECT_EQ(seen["zoomed"], false);
  EXPECT_NEAR(clock_s(seen["middle"]), 0.5 * end_s, 1);
  EXPECT_NEAR(clock_s(seen["left"]), 0.25 * end_s, 1);
  EXPECT_EQ(seen["again"], true);
  EXPECT_EQ(seen["start"], "00:00:00");
}

TEST_F(Report, hides_a_rover_and_holds_the_cursor) {
  if (browser().empty()) GTEST_SKIP() << "no Chromium is installed";
  const json seen = in_page(R"js(
    const energy = plot('energy');
    energy.scrollIntoView();
    await rest();
    const values = () => [...document.querySelectorAll('#plot-energy output')].map(o => o.textContent);
    await click(document.querySelectorAll('.chip')[0]);
    const hidden = values(), arrow = document.querySelector('#rover-A').getAttribute('visibility');
    await click(document.querySelectorAll('.chip')[0]);
    const shown = values();
    await drag(energy, 0.5, 0.5);
    const held = text('#clock-elapsed');
    await move(energy, 0.9);
    return {hidden, arrow, shown, held, still: text('#clock-elapsed')};
  )js");
  ASSERT_FALSE(seen.contains("error")) << seen;
  EXPECT_EQ(seen["hidden"][0], "");
  EXPECT_NE(seen["hidden"][1], "");
  EXPECT_EQ(seen["arrow"], "hidden");
  EXPECT_NE(seen["shown"][0], "");
  EXPECT_THAT(seen["held"].get<std::string>(), HasSubstr("(held)"));
  EXPECT_EQ(seen["held"], seen["still"]);
}

TEST_F(Report, shows_what_events_noted_and_goes_to_its_time) {
  if (browser().empty()) GTEST_SKIP() << "no Chromium is installed";
  const json seen = in_page(R"js(
    plot('energy').scrollIntoView();
    await rest();
    const before = text('#clock-elapsed');
    const row = document.querySelector('#note-table tbody tr');
    const cells = [...row.children].map(cell => cell.textContent);
    await click(row);
    const after = text('#clock-elapsed');
    const mark = document.querySelector('.note-mark');
    await click(document.querySelectorAll('.chip')[1]);
    const ticks = [...document.querySelectorAll('#plot-energy .dygraph-axis-label-y')];
    return {before, after, cells, title: mark.textContent, hidden: mark.getAttribute('visibility'),
            legend: text('.map-legend'), ticks: ticks.map(tick => tick.textContent)};
  )js");
  ASSERT_FALSE(seen.contains("error")) << seen;
  EXPECT_EQ(seen["cells"], json({"00:30:00", "B", "Drill 1", "hole", "depth_m 2.000"}));
  EXPECT_NE(seen["before"], seen["after"]);
  EXPECT_THAT(seen["after"].get<std::string>(), StartsWith("00:30:00"));
  EXPECT_THAT(seen["title"].get<std::string>(), HasSubstr("hole depth_m 2"));
  EXPECT_EQ(seen["hidden"], "hidden");
  EXPECT_THAT(seen["legend"].get<std::string>(), HasSubstr("note"));
  // No two labels of an axis are equal.
  const auto ticks = seen["ticks"].get<std::vector<std::string>>();
  EXPECT_GT(ticks.size(), 2u);
  EXPECT_EQ(std::set(ticks.begin(), ticks.end()).size(), ticks.size());
}

TEST(ReportScripts, are_javascript) {
  if (run_command({"which", "node"}).exit_code != 0) GTEST_SKIP() << "no node is installed";
  int scripts = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(repository() / "core/product/report")) {
    if (entry.path().extension() != ".js") continue;
    ++scripts;
    const Outcome outcome = run_command({"node", "--check", entry.path()});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_LE(read_lines(entry.path()).size(), 400u) << entry.path();
  }
  EXPECT_GT(scripts, 3);
}

TEST_F(Report, is_written_again_from_the_log_alone) {
  const Outcome outcome = run({"report", *folder_ / "run", "--no-pictures", "--shadow-at", "10 s",
                               "-o", *folder_ / "again.html", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(json::parse(outcome.out)["report"], (*folder_ / "again.html").string());
  const json again = data_of(read_text(*folder_ / "again.html")), first = data_of(*page_);
  EXPECT_EQ(again["rovers"], first["rovers"]);
  EXPECT_EQ(again["map"]["shadow_s"], 10);
  EXPECT_TRUE(again["pictures"].empty());
}

TEST_F(Report, has_a_figure_for_a_paper) {
  const Outcome outcome = run({"report", *folder_ / "run", "--png", "--dpi", "150"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(read_text(*folder_ / "run/report.png"), StartsWith("\x89PNG"));
}

TEST_F(Report, of_a_run_without_a_summary_says_that_it_has_not_finished) {
  const std::filesystem::path copy = *folder_ / "unfinished";
  std::filesystem::create_directory(copy);
  for (const char* name : {"plan.kml", "log.gpkg"}) {
    std::filesystem::copy(std::filesystem::path(*folder_ / "run") / name, copy / name);
  }
  ASSERT_EQ(run({"report", copy, "--no-pictures"}).exit_code, 0);
  EXPECT_TRUE(data_of(read_text(copy / "report.html"))["summary"].is_null());
}

TEST(ReportElsewhere, finds_the_scripts_beside_the_plan_that_was_run) {
  const TempFolder folder, elsewhere;
  folder.write("events/Nap.lua",
               "local lsos = require 'lsos'\nreturn lsos.event { api = 1, doc = 'Nap.', "
               "phases = { nap = function() return lsos.done end } }\n");
  folder.write("nap.kml", run({"schema", "Nap"}, {folder.path()}).out);
  ASSERT_EQ(run({"nap.kml", "--quiet", "--no-report"}, {folder.path()}).exit_code, 0);
  const std::string done = folder / "out/nap";
  const Outcome overlay = run({"overlay", done}, {elsewhere.path()});
  EXPECT_EQ(overlay.exit_code, 0);
  EXPECT_EQ(overlay.err, "");
  EXPECT_THAT(read_text(done + "/overlay.kml"), HasSubstr("Nap"));
  const Outcome report = run({"report", done, "--no-pictures"}, {elsewhere.path()});
  EXPECT_EQ(report.err, "");
  EXPECT_FALSE(data_of(read_text(done + "/report.html"))["map"].is_null());

  std::filesystem::remove_all(folder / "events");
  const Outcome gone = run({"overlay", done}, {elsewhere.path()});
  EXPECT_EQ(gone.exit_code, 0);
  EXPECT_THAT(gone.err, HasSubstr("warning: what the plan drew may be incomplete: "));
  EXPECT_THAT(gone.err, HasSubstr("Nap"));
  const Outcome bare = run({"report", done, "--no-pictures"}, {elsewhere.path()});
  EXPECT_EQ(bare.exit_code, 0);
  EXPECT_THAT(bare.err, HasSubstr("warning: map and pictures: "));
}

TEST_F(Report, compare_finds_a_run_equal_to_itself_and_not_to_another) {
  const std::string plan = folder_->write("other.kml", read_text(*folder_ / "run/plan.kml"));
  std::string text = read_text(plan);
  text.replace(text.find(">20<"), 4, ">30<");
  folder_->write("other.kml", text);
  ASSERT_EQ(run({plan, "-o", *folder_ / "other", "--quiet", "--no-report"}).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(*folder_ / "other/report.html"));
  const std::string a = *folder_ / "run", b = *folder_ / "other";

  EXPECT_EQ(run({"compare", a, a}).exit_code, 0);
  EXPECT_EQ(run({"compare", a, a, "--exact"}).exit_code, 0);
  const Outcome different = run({"compare", a, b, "--json"});
  EXPECT_EQ(different.exit_code, 1);
  const json answer = json::parse(different.out);
  EXPECT_EQ(answer["equal"], false);
  EXPECT_THAT(different.out, HasSubstr("\"rover A\""));
  EXPECT_THAT(different.out, HasSubstr("plan_sha256"));
  const Outcome exact = run({"compare", a, b, "--exact"});
  EXPECT_EQ(exact.exit_code, 1);
  EXPECT_THAT(exact.out, HasSubstr("first difference: layer samples, row "));
}

}  // namespace
}  // namespace lsos::test
