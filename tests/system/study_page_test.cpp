// study.html and study.kml of a sweep, in a browser as a user sees them.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>

#include "system/browser.h"
#include "system/study_text.h"

namespace lsos::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string hostile = "</script><b>'\"&";

// A number as the page writes it, with a Unicode minus sign.
double number(std::string text) {
  const std::size_t minus = text.find("\u2212");
  if (minus != std::string::npos) text.replace(minus, std::string("\u2212").size(), "-");
  return std::stod(text);
}

// All tests share one sweep of six cases, of a plan in which one label has text that would end a
// <script>.
class StudyHtml : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TempFolder;
    std::string text = kml(short_plan());
    const std::string mark = "<Placemark>";
    text.insert(text.rfind(mark) + mark.size(),
                "<name>&lt;/script&gt;&lt;b&gt;'&quot;&amp;</name>");
    folder_->write("plan.kml", text);
    folder_->write(
        "study.lua",
        study_text("cases = 6, interval_s = 1, sampling = 'sobol', gather = { lsos.gather "
                   "{ rover = 'A', quantity = 'speed_mps', take = 'greatest', name = "
                   "'fastest' } },",
                   "    lsos.vary { of = 'A/10.Speed', uniform = { '0.5 m/s', '1.5 m/s' "
                   "} },\n    lsos.vary { of = 'A/10.Place', within = '2 m' },"));
    const Outcome outcome =
        run({"sweep", "study.lua", "-o", "out", "--quiet"}, {.folder = folder_->path()});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    page_ = new std::string(read_text(*folder_ / "out/study.html"));
  }
  static void TearDownTestSuite() {
    delete folder_;
    delete page_;
  }
  static json in_page(const std::string& steps) {
    return in_browser(*folder_, *folder_ / "out/study.html", steps);
  }

  static inline TempFolder* folder_ = nullptr;
  static inline std::string* page_ = nullptr;
};

TEST_F(StudyHtml, is_left_by_a_sweep_and_loads_nothing) {
  EXPECT_THAT(*page_, HasSubstr("default-src 'none'; img-src data:;"));
  const std::regex loads(R"re((src|href)\s*=\s*["']?(https?:)?//|url\(\s*["']?http|@import)re");
  EXPECT_FALSE(std::regex_search(*page_, loads));
  EXPECT_THAT(*page_, Not(HasSubstr(hostile)));
  EXPECT_LT(page_->size(), 2'000'000u);
  const std::string kml = read_text(*folder_ / "out/study.kml");
  EXPECT_THAT(kml, Not(HasSubstr(hostile)));
  EXPECT_THAT(kml, HasSubstr("100 %"));
}

TEST_F(StudyHtml, shows_a_case_everywhere) {
  if (browser().empty()) GTEST_SKIP() << "no Chromium is installed";
  const json seen = in_page(R"js(
    const bands = plot('distance');
    bands.scrollIntoView();
    await rest();
    await move(bands, 0.1);
    const told = text('#plot-distance output');
    await click(document.querySelector('#case-table tbody tr:nth-child(4)'));
    const chosen = {bar: text('#chosen-case b'), link: document.querySelector('#open-case').getAttribute('href'),
      fastest: [...document.querySelectorAll('.histogram')].find(f => f.querySelector('h3').textContent.startsWith('fastest')).querySelector('output').textContent,
      row: document.querySelector('#case-table tr.is-chosen td').textContent};
    await click(document.querySelector('#chosen-case button'));
    return {told, chosen, none: text('#chosen-case'), clock: text('#clock-elapsed'),
      rows: document.querySelectorAll('#case-table tbody tr').length, bold: document.querySelectorAll('.arrival-names b b').length,
      label: [...document.querySelectorAll('.arrival-names span')].map(s => s.textContent).join('|'), map: document.querySelector('#relief') !== null,
      cells: document.querySelectorAll('#influence-table tbody tr:first-child button').length};
  )js");
  ASSERT_FALSE(seen.contains("error")) << seen;
  EXPECT_EQ(seen["rows"], 6);
  EXPECT_EQ(seen["chosen"]["bar"], "Case 4 ");
  EXPECT_EQ(seen["chosen"]["link"], "cases/000004/plan.kml");
  EXPECT_EQ(seen["chosen"]["row"], "4");
  EXPECT_EQ(seen["none"], "");
  EXPECT_EQ(seen["map"], true);
  EXPECT_EQ(seen["cells"], 3) << "a speed, and a place east and north";
  EXPECT_THAT(seen["label"].get<std::string>(), HasSubstr(hostile));
  const json fastest =
      rows(*folder_ / "out", "SELECT fastest FROM cases WHERE \"case\" = 4")[0]["fastest"];
  EXPECT_NEAR(number(seen["chosen"]["fastest"].get<std::string>().substr(8)), fastest, 6e-4);
  // The band at the time of the cursor, which is within half a second of a time of the table.
  const double end_s =
      rows(*folder_ / "out", "SELECT max(time_s) AS t FROM bands")[0]["t"].get<double>();
  const json near = rows(*folder_ / "out",
                         "SELECT p50 FROM bands WHERE quantity = 'distance_m' ORDER BY abs(time_s "
                         "- " +
                             std::to_string(0.1 * end_s) + ") LIMIT 2");
  const double told = number(seen["told"]), a = near[0]["p50"], b = near[1]["p50"];
  EXPECT_GE(told, std::min(a, b) - 0.06);
  EXPECT_LE(told, std::max(a, b) + 0.06);
}

TEST_F(StudyHtml, sorts_and_filters_its_cases) {
  if (browser().empty()) GTEST_SKIP() << "no Chromium is installed";
  const json seen = in_page(R"js(
    const cases = () => [...document.querySelectorAll('#case-table tbody tr td:first-child')].map(td => Number(td.textContent));
    const head = name => [...document.querySelectorAll('#case-table th')].find(th => th.textContent.includes(name));
    const filter = async words => {
      const input = document.querySelector('#case-filter');
      input.value = words;
      input.dispatchEvent(new Event('input'));
      await rest();
      return {cases: cases(), count: text('#case-count'), wrong: input.title};
    };
    await click(head('Speed'));
    const up = cases();
    await click(head('Speed'));
    const down = cases();
    return {up, down, few: await filter('completed case<=3 A/10.Speed>0'), none: await filter('no-such-word'), wrong: await filter('elephants>3'), all: await filter('')};
  )js");
  ASSERT_FALSE(seen.contains("error")) << seen;
  json expected = json::array();
  for (const json& row :
       rows(*folder_ / "out", "SELECT \"case\" FROM cases ORDER BY \"A/10.Speed\"")) {
    expected.push_back(row["case"]);
  }
  EXPECT_EQ(seen["up"], expected);
  std::reverse(expected.begin(), expected.end());
  EXPECT_EQ(seen["down"], expected);
  json few = seen["few"]["cases"];
  std::sort(few.begin(), few.end());
  EXPECT_EQ(few, json({1, 2, 3}));
  EXPECT_EQ(seen["few"]["count"], "3 of 6 cases");
  EXPECT_EQ(seen["none"]["cases"], json::array());
  EXPECT_THAT(seen["wrong"]["wrong"].get<std::string>(), HasSubstr("elephants>3"));
  EXPECT_EQ(seen["all"]["cases"].size(), 6u);
}

TEST_F(StudyHtml, is_made_again_by_gather) {
  std::filesystem::remove(*folder_ / "out/study.html");
  std::filesystem::remove(*folder_ / "out/study.kml");
  const Outcome outcome =
      run({"sweep", "gather", "study.lua", "-o", "out"}, {.folder = folder_->path()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("6 of 6 cases in out/study.gpkg, study.html and study.kml"));
  EXPECT_EQ(read_text(*folder_ / "out/study.html"), *page_);
}

}  // namespace
}  // namespace lsos::test
