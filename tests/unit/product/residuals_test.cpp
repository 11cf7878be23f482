// Residuals of telemetry against closed forms.
#include "product/comparison/residuals.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "planet/site_frame.h"
#include "product/comparison/residuals_text.h"
#include "unit/record/log_fixture.h"

namespace lsos {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

constexpr double speed_mps = 0.5;
constexpr int interval_s = 10, drive_s = 100, end_s = 200;

const Body& moon() { return *find_body("Moon"); }
SiteFrame site() { return SiteFrame(moon(), geodetic_from_degrees(80, -84.7, -1200)); }

// A rover drives east for 100 s, then stands heading north for 100 s.
SampleRow driven_sample(int time_s) {
  SampleRow row;
  const double driven_m = speed_mps * std::min(time_s, drive_s);
  row.time = SimTime{1'000'000LL * time_s};
  row.rover_id = "SEV1";
  row.p_S_m = {driven_m, 0, 0};
  row.place = site().geodetic(row.p_S_m);
  row.heading_rad = time_s <= drive_s ? std::numbers::pi / 2 : 0;
  row.speed_mps = time_s <= drive_s ? speed_mps : 0;
  row.charge = 1 - 1e-3 * time_s;
  if (time_s <= drive_s) row.slip = 0.05;
  return row;
}

EventRow event(std::int64_t sequence, int from_s, int until_s) {
  EventRow row = test_event();
  row.sequence = sequence;
  row.label = "Event " + std::to_string(sequence);
  row.start = SimTime{1'000'000LL * from_s};
  row.end = SimTime{1'000'000LL * until_s};
  return row;
}

class ResidualsTest : public ::testing::Test {
 protected:
  ResidualsTest() {
    LogWriter log(folder / "log.gpkg", moon_crs, test_start());
    for (int time_s = 0; time_s <= end_s; time_s += interval_s) log.write(driven_sample(time_s));
    log.write(event(10, 0, drive_s));
    log.write(event(20, drive_s + 20, end_s));
    log.finish();
  }
  Residuals of(const std::string& text, int run_s = end_s) {
    telemetry =
        read_telemetry("t.csv", text, {test_start(), SimTime{1'000'000LL * run_s}, {"SEV1"}});
    return residuals(LogReader(folder / "log.gpkg"), moon(), telemetry);
  }
  static const ResidualSeries& series(const Residuals& found, const std::string& quantity) {
    const auto at = std::ranges::find(found.series, quantity, &ResidualSeries::quantity);
    EXPECT_NE(at, found.series.end()) << quantity;
    return *at;
  }
  static ResidualStatistics all(const Residuals& found, const std::string& quantity) {
    const auto at = std::ranges::find(found.summaries, quantity, &ResidualSummary::quantity);
    EXPECT_EQ(at->span, ResidualSummary::Span::all);
    return at->statistics;
  }
  // A row of telemetry at the place that the rover has at another time, moved east and north.
  static std::string place(double time_s, double of_s, double east_m = 0, double north_m = 0) {
    const double driven_m = speed_mps * std::min<double>(of_s, drive_s);
    const Geodetic at = site().geodetic({driven_m + east_m, north_m, 0});
    return fmt::format("{},{:.12f},{:.12f}\n", time_s, lon_deg(at), lat_deg(at));
  }

  TestFolder folder;
  Telemetry telemetry;
};

TEST_F(ResidualsTest, are_a_known_offset) {
  std::string text = "time_s,charge\n";
  for (int time_s = 3; time_s < end_s; time_s += 7) {
    text += fmt::format("{},{}\n", time_s, driven_sample(time_s).charge + 0.025);
  }
  const ResidualStatistics found = all(of(text), "charge");
  EXPECT_EQ(found.count, 29u);
  EXPECT_NEAR(found.mean, 0.025, 1e-12);
  EXPECT_NEAR(found.rms, 0.025, 1e-12);
  EXPECT_NEAR(found.greatest, 0.025, 1e-12);
}

TEST_F(ResidualsTest, are_nothing_at_the_samples_themselves) {
  std::string text = "time_s,charge,speed_mps,heading_rad,x_m\n";
  for (int time_s = 0; time_s <= end_s; time_s += interval_s) {
    const SampleRow row = driven_sample(time_s);
    text += fmt::format("{},{},{},{},{}\n", time_s, row.charge, row.speed_mps, row.heading_rad,
                        row.p_S_m.x());
  }
  const Residuals found = of(text);
  for (const char* name : {"charge", "speed_mps", "heading_rad", "x_m"}) {
    EXPECT_EQ(all(found, name).count, 21u);
    EXPECT_EQ(all(found, name).greatest, 0) << name;
  }
}

// A clock that is dt late sees the rover v dt ahead.
TEST_F(ResidualsTest, of_a_shifted_clock_are_speed_times_shift_along_the_track) {
  constexpr double shift_s = 3;
  std::string text = "time_s,lon_deg,lat_deg\n";
  for (int time_s = 5; time_s < drive_s - 5; time_s += 4) text += place(time_s, time_s + shift_s);
  const Residuals found = of(text);
  EXPECT_NEAR(all(found, "place_along_m").mean, speed_mps * shift_s, 1e-6);
  EXPECT_NEAR(all(found, "place_along_m").rms, speed_mps * shift_s, 1e-6);
  EXPECT_NEAR(all(found, "place_across_m").greatest, 0, 1e-6);
  EXPECT_NEAR(all(found, "place_distance_m").mean, speed_mps * shift_s, 1e-6);
}

TEST_F(ResidualsTest, across_the_track_are_positive_to_the_left) {
  const Residuals driving = of("time_s,lon_deg,lat_deg\n" + place(45, 45, 0, 3));
  EXPECT_NEAR(all(driving, "place_along_m").mean, 0, 1e-6);
  EXPECT_NEAR(all(driving, "place_across_m").mean, 3, 1e-6);
  // It stands heading north, so that ahead is north and west is to the left.
  // There north is not that of the site, so near a pole.
  const SiteFrame there(moon(), driven_sample(155).place);
  const Geodetic measured = there.geodetic({-4, 3, 0});
  const Residuals standing = of(fmt::format("time_s,lon_deg,lat_deg\n155,{:.12f},{:.12f}\n",
                                            lon_deg(measured), lat_deg(measured)));
  EXPECT_NEAR(all(standing, "place_along_m").mean, 3, 1e-4);
  EXPECT_NEAR(all(standing, "place_across_m").mean, 4, 1e-4);
  EXPECT_NEAR(all(standing, "place_distance_m").mean, 5, 1e-4);
}

TEST_F(ResidualsTest, of_angles_go_the_shorter_way_round) {
  // It heads north, 0 degrees.
  const Residuals found = of("time_s,heading_deg\n150,359\n160,1\n");
  const std::vector<Residual>& both = series(found, "heading_rad").residuals;
  EXPECT_NEAR(both[0].residual, -std::numbers::pi / 180, 1e-12);
  EXPECT_NEAR(both[1].residual, std::numbers::pi / 180, 1e-12);
}

TEST_F(ResidualsTest, are_left_out_where_the_log_has_no_value) {
  const Residuals found = of("time_s,slip\n50,0.06\n100,0.06\n105,0.06\n150,0.06\n");
  EXPECT_EQ(series(found, "slip").residuals.size(), 2u);
  EXPECT_EQ(series(found, "slip").without_simulated, 2u);
  EXPECT_THAT(to_text(found, telemetry, "run"),
              HasSubstr("SEV1, slip: 2 of 4 measured values have none in the log"));
}

// Another rover went on: this one was parked when the run was killed, and had no sample since.
TEST_F(ResidualsTest, are_missed_after_the_last_sample_of_a_rover) {
  const Residuals found =
      of("time_s,charge,lon_deg,lat_deg\n50,0.9,80,-84.7\n250,0.8,80,-84.7\n", end_s + 100);
  EXPECT_EQ(series(found, "charge").residuals.size(), 1u);
  EXPECT_EQ(series(found, "charge").without_simulated, 1u);
  EXPECT_EQ(found.places.at("SEV1").size(), 1u);
}

TEST_F(ResidualsTest, are_summed_up_by_event) {
  const Residuals found = of("time_s,charge\n50,1\n60,1\n110,1\n150,1\n");
  const json answer = json::parse(to_json(found, telemetry, "run"));
  ASSERT_EQ(answer["residuals"].size(), 4u);
  const json& whole = answer["residuals"][0];
  EXPECT_EQ(whole["during"], "all");
  EXPECT_EQ(whole["count"], 4);
  EXPECT_NEAR(whole["mean"].get<double>(), (0.05 + 0.06 + 0.11 + 0.15) / 4, 1e-12);
  EXPECT_NEAR(whole["greatest"].get<double>(), 0.15, 1e-12);
  EXPECT_EQ(whole["greatest_time_s"], 150);
  const json& drive = answer["residuals"][1];
  EXPECT_EQ(drive["sequence"], 10);
  EXPECT_NEAR(drive["rms"].get<double>(), std::sqrt((0.05 * 0.05 + 0.06 * 0.06) / 2), 1e-12);
  EXPECT_EQ(answer["residuals"][2]["sequence"], 20);
  EXPECT_EQ(answer["residuals"][3]["during"], "between events");
  EXPECT_EQ(answer["residuals"][3]["count"], 1);
  EXPECT_EQ(answer["rows_used"], 4);
  const std::string text = to_text(found, telemetry, "run");
  EXPECT_THAT(text, HasSubstr("t.csv against run: 4 of 4 rows used"));
  EXPECT_THAT(text, HasSubstr("event SEV1/10 Event 10"));
  EXPECT_THAT(text, HasSubstr("rover SEV1, between events"));
}

}  // namespace
}  // namespace lsos
