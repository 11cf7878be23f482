// The page of a thousand cases: how large it is, and how quickly a browser shows it.
#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "system/browser.h"
#include "system/study_text.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int cases = 1000;

std::string case_path(const TempFolder& folder, int number) {
  const std::string digits = std::to_string(number);
  return folder / ("out/cases/" + std::string(6 - digits.size(), '0') + digits);
}

// One case is run; the others are copies of it with other numbers.
void copy_case(const TempFolder& folder, const json& first, int number) {
  fs::copy(case_path(folder, 1), case_path(folder, number));
  json record = first;
  const double share = std::fmod(0.618034 * number, 1);
  record["case"] = number;
  record["values"]["A/10.Speed"] = 0.5 + share;
  record["gathered"]["fastest"] = 0.5 + share + 0.01 * std::sin(number);
  std::ofstream(case_path(folder, number) + "/case.json") << record.dump(2);
}

// Wall time until a browser has drawn the page; the best of three.
double drawn_s(const TempFolder& folder, const std::string& page) {
  double best_s = 1e9;
  for (int i = 0; i < 3; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    const Outcome outcome = run_command(
        {browser(), "--headless", "--no-sandbox", "--disable-gpu", "--window-size=1300,2000",
         "--screenshot=" + (folder / "page.png").string(), "file://" + page});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    best_s = std::min(best_s, took.count());
  }
  EXPECT_GT(fs::file_size(folder / "page.png"), 1000u);
  return best_s;
}

TEST(StudyOfAThousand, has_a_page_that_opens_quickly) {
  const TempFolder folder;
  folder.write("plan.kml", kml(short_plan()));
  folder.write(
      "study.lua",
      study_text("cases = 1000, interval_s = 0.5, gather = { lsos.gather { rover = 'A', take "
                 "= 'greatest', quantity = 'speed_mps', name = 'fastest' } },",
                 "    lsos.vary { of = 'A/10.Speed', uniform = { '0.5 m/s', '1.5 m/s' } },\n"
                 "    lsos.vary { of = 'Rover A.InitialCharge', uniform = { 0.5, 0.9 } },"));
  const Surroundings here{.folder = folder.path()};
  const Outcome one =
      run({"sweep", "run", "study.lua", "-o", "out", "--cases", "1", "--quiet"}, here);
  ASSERT_EQ(one.exit_code, 0) << one.err;
  const json first = json::parse(read_text(case_path(folder, 1) + "/case.json"));
  for (int number = 2; number <= cases; ++number) copy_case(folder, first, number);
  const Outcome gathered = run({"sweep", "gather", "study.lua", "-o", "out"}, here);
  ASSERT_EQ(gathered.exit_code, 0) << gathered.err;
  const std::string page = folder / "out/study.html";
  const auto size = fs::file_size(page);
  RecordProperty("page_bytes", std::to_string(size));
  EXPECT_LT(size, 10'000'000u);
  if (browser().empty()) GTEST_SKIP() << "no Chromium is installed";
  const double start_s = drawn_s(folder, folder.write("empty.html", "<!doctype html><p>empty</p>"));
  const double page_s = drawn_s(folder, page);
  RecordProperty("opens_s", std::to_string(page_s - start_s));
  EXPECT_LT(page_s - start_s, 3);
}

}  // namespace
}  // namespace lsos::test
