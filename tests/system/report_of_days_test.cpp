// report.html of a mission longer than a day, in a browser.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "system/browser.h"
#include "system/run_folder.h"

namespace lsos::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

// A mission of 26 hours, in which B's second event is not done in time.
TEST(ReportOfDays, begins_with_failures_and_shows_a_day_with_its_numbers) {
  if (browser().empty()) GTEST_SKIP() << "no Chromium is installed";
  const TempFolder folder;
  const auto rover = [](const std::string& id, const std::string& place) {
    return Mark{"Rover", {{"RoverId", id}, {"RoverType", "SEV"}}, point(place)};
  };
  const std::string plan = folder.write(
      "plan.kml", kml({mission(), rover("A", "-27,0"), rover("B", "-27,0.002"),
                       event("Route", "A", 1, {}, line("-26.9995,0 -26.999,0.0003")),
                       event("Pause", "A", 2, {{"Duration", "26 h"}, {"WarnWhen", "charge > 0.5"}}),
                       event("Pause", "B", 1, {{"Duration", "25 h"}}),
                       event("Pause", "B", 2, {{"Duration", "1 h"}, {"Timeout", "5"}}),
                       event("Pause", "B", 3, {{"Duration", "20"}})}));
  ASSERT_EQ(run({plan, "-o", folder / "run", "--quiet"}).exit_code, 1);
  const json seen = in_browser(folder, folder / "run/report.html", R"js(
    await rest();
    const choice = document.querySelector('#day');
    const rows = () => [...document.querySelectorAll('#day-numbers tbody tr')].map(row => row.textContent);
    const whole = rows().length;
    choice.value = '2';
    choice.dispatchEvent(new Event('change'));
    await rest();
    const second = {rows: rows(), heads: text('#day-numbers thead'), clock: text('#clock-elapsed')};
    await click(document.querySelector('#findings button.link'));
    const folds = [...document.querySelectorAll('#event-table details')];
    const before = document.querySelectorAll('#event-table tbody tr').length;
    for (const fold of folds) fold.open = true;
    await rest();
    return {whole, second, choice: choice.value, folds: folds.map(fold => fold.querySelector('summary').textContent),
      before, after: document.querySelectorAll('#event-table tbody tr').length,
      expected: [...document.querySelectorAll('#event-table tbody tr')].map(row => [...row.querySelectorAll('.expected')].map(each => each.textContent)),
      first: document.querySelector('#findings').firstElementChild.textContent,
      pins: [...document.querySelectorAll('#map .note-mark')].map(mark => mark.textContent),
      about: text('#estimate-about'), legend: text('.map-legend'), pictures: text('#picture-list')};
  )js");
  ASSERT_FALSE(seen.contains("error")) << seen;
  EXPECT_EQ(seen["whole"], 0);
  ASSERT_EQ(seen["second"]["rows"].size(), 2u);
  EXPECT_THAT(seen["second"]["rows"][0].get<std::string>(), StartsWith("A0.0 m"));
  EXPECT_THAT(seen["second"]["heads"].get<std::string>(), HasSubstr("Charge at start"));
  EXPECT_EQ(seen["second"]["clock"], "1 d 00:00:00");
  EXPECT_EQ(seen["choice"], "-1") << "the failed event is no day";
  EXPECT_THAT(seen["first"].get<std::string>(), HasSubstr("1 failed, 1 not started"));
  EXPECT_THAT(seen["first"].get<std::string>(), HasSubstr("1 event of B never began"));
  EXPECT_EQ(seen["before"], 0);
  EXPECT_EQ(seen["after"], 5);
  ASSERT_EQ(seen["pins"].size(), 1u) << seen["pins"];
  EXPECT_THAT(seen["pins"][0].get<std::string>(), HasSubstr("warn when condition charge > 0.5"));
  EXPECT_THAT(seen["legend"].get<std::string>(), HasSubstr("WarnWhen begins to hold"));
  // The estimate stands under the end, the energy used, that from the Sun and the charge.
  ASSERT_EQ(seen["expected"][0].size(), 4u) << seen["expected"];
  for (const json& cell : seen["expected"][0]) {
    EXPECT_THAT(cell.get<std::string>(), StartsWith("est. "));
  }
  EXPECT_THAT(seen["second"]["rows"][0].get<std::string>(), HasSubstr("est. "));
  EXPECT_THAT(seen["about"].get<std::string>(), HasSubstr("The greatest differences are of ends "));
  EXPECT_THAT(seen["about"].get<std::string>(), HasSubstr(" points "));
  EXPECT_EQ(seen["folds"].size(), 3u) << seen["folds"];
  EXPECT_THAT(seen["pictures"].get<std::string>(), HasSubstr("failed"));
}

}  // namespace
}  // namespace lsos::test
