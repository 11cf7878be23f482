// The data of report.html: valid JSON whatever labels hold, and numbers as in the log.
#include "product/report.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "base/base64.h"
#include "product/event_kinds.h"
#include "product/figure.h"
#include "unit/record/log_fixture.h"

namespace lsos {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

std::string decoded(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0, count = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<unsigned>(digits.find(c));
    if ((count += 6) >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 255u);
  }
  return bytes;
}

template <class Number>
std::vector<Number> unpacked(const std::string& text) {
  const std::string bytes = decoded(text);
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  std::memcpy(numbers.data(), bytes.data(), bytes.size());
  return numbers;
}

class ReportTest : public ::testing::Test {
 protected:
  ReportTest() {
    plan.file = "plans/<hostile> & \"plan\".kml";
    plan.mission.planet = find_body("Moon");
    LogWriter log(folder / "log.gpkg", moon_crs, test_start());
    for (int i = 0; i < 20; ++i) {
      SampleRow row = test_sample(i);
      row.energy_j = 1e6 - 1000 * i;
      log.write(row);
    }
    EventRow event = test_event();
    event.label = "</script><script>alert(\"1\")</script> '\\ \xff <!--";
    event.status = EventStatus::failed;
    event.reason = "stuck & \"lost\"";
    event.end = SimTime{30'000'000};
    log.write(event);
    log.write(NoteRow{.time = SimTime{8'000'000},
                      .rover_id = "SEV1",
                      .sequence = 10,
                      .name = "beacon",
                      .fields_json = R"({"n":3,"text":"</script>"})",
                      .place = test_sample(4).place});
    log.finish();
  }
  ReportData data() const {
    const LogReader log(folder / "log.gpkg");
    return read_report_data(log, plan, site());
  }
  SiteFrame site() const { return SiteFrame(*plan.mission.planet, test_sample(0).place); }

  TestFolder folder;
  Plan plan;
};

// 30 days at 60 s, and 40 rows of a drive between them.
TEST_F(ReportTest, shows_a_short_drive_in_a_month_of_standing) {
  constexpr int before = 20'000, drive = 40, after = 23'000;
  LogWriter log(folder / "long.gpkg", moon_crs, test_start());
  SimTime time{};
  for (int i = 0; i < before + drive + after; ++i) {
    const bool is_moving = i >= before && i < before + drive;
    SampleRow row = test_sample(std::clamp(i - before, 0, drive));
    row.p_S_m.y() = 3 * std::sin(row.p_S_m.x());
    row.speed_mps = is_moving ? 0.3 + 0.01 * (i % 7) : 0;
    row.time = time;
    time += SimTime{(is_moving ? 2 : 60) * 1'000'000};
    log.write(row);
  }
  log.finish();
  const ReportData found = read_report_data(LogReader(folder / "long.gpkg"), plan, site());
  const ReportRover& rover = found.rovers.front();
  EXPECT_LT(rover.position.size(), 60u) << "the drive, and little else";
  EXPECT_GT(rover.position.size(), 40u);
  const auto speed = std::ranges::find(rover.series, std::string("speed_mps"),
                                       &std::pair<std::string, ThinnedRows>::first);
  EXPECT_EQ(std::ranges::count_if(speed->second.column(0), [](double v) { return v > 0; }), drive);
}

TEST_F(ReportTest, holds_valid_json_whatever_labels_say) {
  const std::string text = report_json(data(), plan, site(), R"({"warnings": ["</script>"]})", {});
  EXPECT_THAT(text, Not(HasSubstr("<")));
  const json page = json::parse(text);
  EXPECT_EQ(page["plan"], plan.file);
  EXPECT_EQ(page["summary"]["warnings"][0], "</script>");
  EXPECT_THAT(page["events"][0]["label"].get<std::string>(),
              StartsWith("</script><script>alert(\"1\")</script> '\\ "));
  EXPECT_EQ(page["events"][0]["reason"], "stuck & \"lost\"");
}

TEST_F(ReportTest, holds_the_numbers_of_the_log) {
  const json page = json::parse(report_json(data(), plan, site(), "", {}));
  const json& rover = page["rovers"][0];
  EXPECT_EQ(rover["samples"], 20);
  const auto times = unpacked<double>(rover["energy_j"]["t"]);
  const auto energies = unpacked<float>(rover["energy_j"]["v"]);
  ASSERT_EQ(times.size(), 20u);
  EXPECT_EQ(times[7], 14);
  EXPECT_EQ(energies[7], 993000.0f);
  EXPECT_EQ(unpacked<float>(rover["position"]["x_m"])[7], 7.0f);
  EXPECT_EQ(unpacked<std::int32_t>(rover["position"]["lat_e7deg"])[7], -892500000);
  EXPECT_TRUE(rover["energy_rate_w"].is_null());  // not modelled
  EXPECT_TRUE(page["summary"].is_null());
}

// The last second of 2016 was a leap second, that of 2017 was not.
TEST_F(ReportTest, knows_when_clocks_stood_still) {
  const auto leaps = [&](const char* start, double end_s) {
    ReportData of = data();
    of.start = *parse_utc(start).value;
    of.end_s = end_s;
    return json::parse(report_json(of, plan, site(), "", {}))["leap_ends_s"];
  };
  EXPECT_EQ(leaps("2016-12-31T23:59:50Z", 31), json::array({11.0}));
  EXPECT_EQ(leaps("2016-12-31T23:59:50Z", 10.5), json::array());
  EXPECT_EQ(leaps("2016-12-31T23:59:60.5Z", 20), json::array({0.5}));
  EXPECT_EQ(leaps("2017-12-31T23:59:50Z", 31), json::array());
  const json years = leaps("2014-01-01T00:00:00Z", 4 * 365.25 * 86400);
  EXPECT_EQ(years, json::array({546 * 86400.0 + 1, 1096 * 86400.0 + 2}));
}

TEST_F(ReportTest, holds_what_was_noted_and_where) {
  const json page = json::parse(report_json(data(), plan, site(), "", {}));
  ASSERT_EQ(page["notes"].size(), 1u);
  EXPECT_EQ(page["notes_in_log"], 1);
  const json& note = page["notes"][0];
  EXPECT_EQ(note["time_s"], 8);
  EXPECT_EQ(note["name"], "beacon");
  EXPECT_EQ(note["fields"], json::parse(R"({"n": 3, "text": "</script>"})"));
  // 4e-4 degrees of longitude at 89.25 degrees south: 1737.4 km x cos(89.25 deg) x 6.98e-6.
  EXPECT_NEAR(note["x_m"].get<double>(), 0.159, 0.006);
}

TEST_F(ReportTest, names_types_of_a_users_own) {
  const auto row = [](const char* type) {
    EventRow event;
    event.type = type;
    return event;
  };
  const auto kinds = event_kinds({row("Route"), row("Trench"), row("Beacon"), row("Trench")},
                                 {{"Route", Activity::driving}, {"Scoop", Activity::science}});
  EXPECT_EQ(kind_of(kinds, "Route").name, "driving");
  EXPECT_EQ(kind_of(kinds, "Trench").name, "Trench");
  EXPECT_NE(kind_of(kinds, "Trench").colour, kind_of(kinds, "Beacon").colour);
  EXPECT_EQ(kind_of(kinds, "Scoop").name, "science and use");
  EXPECT_EQ(kind_of(kinds, "Another").name, "other");
}

TEST_F(ReportTest, is_one_page_that_loads_nothing) {
  const std::string page = report_html(data(), plan, site(), "", {});
  EXPECT_THAT(page, StartsWith("<!doctype html>"));
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
  EXPECT_THAT(page, Not(HasSubstr("src=\"http")));
  EXPECT_THAT(page, Not(HasSubstr("href=\"http")));
  EXPECT_THAT(page, Not(HasSubstr("sourceMappingURL")));
  EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
}

TEST_F(ReportTest, has_a_figure_of_its_plots) {
  const std::string png = figure_png(data(), 100);
  EXPECT_THAT(png, StartsWith("\x89PNG"));
  // 18 cm at 100 dpi.
  const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(png[at]); };
  EXPECT_EQ(byte(18) << 8 | byte(19), 709);
}

TEST_F(ReportTest, a_figure_too_large_for_a_picture_says_how_large_it_may_be) {
  try {
    figure_png(data(), 100'000);
    FAIL() << "it was drawn";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("--dpi 100000: the figure is 180 mm by "));
    EXPECT_THAT(error.what(), HasSubstr(" dpi at most make a picture of it"));
  }
}

// Intervals are logged when they end, so the log of a killed run lacks the last ones.
TEST_F(ReportTest, shows_sight_that_was_not_over_when_the_log_ended) {
  LogWriter log(folder / "cut.gpkg", moon_crs, test_start());
  log.write(test_sample(0));
  const auto pair = [](double time_s, const char* to_id, bool is_visible, bool is_linked) {
    PairRow row;
    row.time = from_seconds(time_s);
    row.from_id = "SEV1";
    row.to_id = to_id;
    row.visible = is_visible ? 1 : 0;
    row.link = is_linked ? 1 : 0;
    return row;
  };
  log.write(pair(0, "Base", true, true));
  log.write(pair(0, "Mast", true, false));  // parked: its next row comes much later
  log.write(SightIntervalRow{"SEV1", "Mast", "visible", from_seconds(0), from_seconds(10), 0});
  log.write(SightIntervalRow{"SEV1", "Base", "link", from_seconds(0), from_seconds(12), 0});
  log.write(pair(20, "Base", true, false));
  log.write(pair(40, "Base", true, true));
  log.write(pair(60, "Base", true, true));
  log.finish();
  const ReportData data = read_report_data(LogReader(folder / "cut.gpkg"), plan, site());
  ASSERT_EQ(data.pairs.size(), 2u);
  using Intervals = std::vector<std::pair<double, double>>;
  EXPECT_EQ(data.pairs[0].visible_s, (Intervals{{0, 60}}));
  EXPECT_EQ(data.pairs[0].link_s, (Intervals{{0, 12}, {40, 60}}));
  EXPECT_EQ(data.pairs[1].visible_s, (Intervals{{0, 10}})) << "as its interval says";
  EXPECT_TRUE(data.pairs[1].link_s.empty());
}

TEST(Base64, is_as_everywhere) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

}  // namespace
}  // namespace lsos
