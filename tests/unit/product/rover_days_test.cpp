// The table of days.
#include "product/rover_days.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "unit/record/log_fixture.h"

namespace lsos {
namespace {

using ::testing::HasSubstr;

constexpr int hour_s = 3600, day_s = 86400;

SimTime time_at(int time_s) { return SimTime{1'000'000LL * time_s}; }

// It drives from 10 h on at 1 m/s for 28 hours, over the first midnight, and uses 100 W. The Sun
// shines for the first 12 hours.
SampleRow sample_of_days(int time_s) {
  constexpr int begin_s = 10 * hour_s, end_s = 38 * hour_s;
  SampleRow row;
  row.time = time_at(time_s);
  row.rover_id = "A";
  row.distance_m = std::clamp(time_s, begin_s, end_s) - begin_s;
  row.speed_mps = time_s > begin_s && time_s < end_s ? 1 : 0;
  row.slope_rad = time_s < day_s ? 0.1 : 0.2;
  row.load_j = 100.0 * time_s;
  row.drive_j = row.loss_j = row.external_j = 0;
  row.solar_j = 200.0 * std::min(time_s, 12 * hour_s);
  row.charge = 1 - time_s / 1e6;
  row.sun_fraction = time_s < 12 * hour_s ? 1 : 0;
  return row;
}

class RoverDays : public ::testing::Test {
 protected:
  // Samples every seven hours and at the ends of the drive: none at midnight.
  std::vector<RoverDay> days_of(int end_s) {
    LogWriter log(folder / "log.gpkg", moon_crs, test_start());
    std::set<int> times{0, 10 * hour_s, 12 * hour_s, 38 * hour_s, end_s};
    for (int time_s = 0; time_s < end_s; time_s += 7 * hour_s) times.insert(time_s);
    for (const int time_s : times) {
      if (time_s <= end_s) log.write(sample_of_days(time_s));
    }
    EventRow event = test_event();
    event.rover_id = "A";
    event.type = "EVA";
    event.start = time_at(23 * hour_s);
    event.end = time_at(25 * hour_s);
    log.write(event);
    PairRow pair;
    pair.from_id = "A";
    pair.to_id = "Earth";
    log.write(pair);
    log.write(
        SightIntervalRow{"A", "Earth", "visible", time_at(20 * hour_s), time_at(30 * hour_s), 1});
    log.finish();
    return rover_days(LogReader(folder / "log.gpkg"));
  }

  TestFolder folder;
};

TEST_F(RoverDays, are_cut_between_two_samples) {
  const std::vector<RoverDay> days = days_of(2 * day_s + 6 * hour_s);
  ASSERT_EQ(days.size(), 3u);
  EXPECT_NEAR(days[0].distance_m, 14 * hour_s, 1e-6);
  EXPECT_NEAR(days[1].distance_m, 14 * hour_s, 1e-6);
  EXPECT_NEAR(days[2].distance_m, 0, 1e-6);
  EXPECT_NEAR(days[0].drive_s, 14 * hour_s, 1e-6);
  EXPECT_NEAR(days[1].drive_s, 14 * hour_s, 1e-6);
  EXPECT_NEAR(days[0].energy_used_j, 100.0 * day_s, 1e-3);
  EXPECT_NEAR(days[2].energy_used_j, 600.0 * hour_s, 1e-3);
  EXPECT_NEAR(days[0].solar_j, 2400.0 * hour_s, 1e-3);
  EXPECT_NEAR(days[1].solar_j, 0, 1e-3);
  EXPECT_NEAR(days[0].sunlit_s, 12 * hour_s, 1e-6);
  EXPECT_NEAR(days[0].charge_start, 1, 1e-12);
  EXPECT_NEAR(days[0].charge_end, 1 - 0.0864, 1e-12);
  EXPECT_NEAR(days[1].charge_start, 1 - 0.0864, 1e-12);
  EXPECT_NEAR(days[1].charge_min, 1 - 2 * 0.0864, 1e-12);
  EXPECT_EQ(days[0].evas, 1);
  EXPECT_EQ(days[0].events_ended, 0);
  EXPECT_EQ(days[1].events_ended, 1);
  EXPECT_NEAR(days[0].earth_visible_s, 4 * hour_s, 1e-6);
  EXPECT_NEAR(days[1].earth_visible_s, 6 * hour_s, 1e-6);
  EXPECT_NEAR(days[1].earth_link_s, 0, 1e-6);
  EXPECT_NEAR(days[0].max_slope_rad, 0.1, 1e-12);
  EXPECT_NEAR(days[2].to_s, 2 * day_s + 6 * hour_s, 1e-9);
}

// At 0 N 0 E on 20 March 2010 the Sun is due south, or nearly overhead, at 12:07:30 UTC by the
// equation of time (NOAA). Its middle rises 6 h 2 min before, as the air lifts it by 0.5 degrees,
// and sets as long after.
TEST_F(RoverDays, know_the_charge_at_dawn_and_dusk) {
  LogWriter log(folder / "earth.gpkg", moon_crs, *parse_utc("2010-03-20T00:00:00Z").value);
  log.write_run({{"planet", "Earth"}});
  for (int time_s = 0; time_s <= 2 * day_s; time_s += 600) {
    SampleRow row = sample_of_days(time_s);
    row.place = {};
    log.write(row);
  }
  log.finish();
  const std::vector<RoverDay> days = rover_days(LogReader(folder / "earth.gpkg"));
  ASSERT_EQ(days.size(), 2u);
  const double noon_s = 12 * hour_s + 450, half_s = 6 * hour_s + 130;
  EXPECT_NEAR(days[0].charge_dawn, 1 - (noon_s - half_s) / 1e6, 60 / 1e6);
  EXPECT_NEAR(days[0].charge_dusk, 1 - (noon_s + half_s) / 1e6, 60 / 1e6);
  EXPECT_NEAR(days[1].charge_dawn, 1 - (day_s + noon_s - half_s) / 1e6, 90 / 1e6);
  // A log that does not say where it was has neither.
  EXPECT_TRUE(std::isnan(days_of(day_s)[0].charge_dawn));
}

TEST_F(RoverDays, that_end_at_midnight_are_not_followed_by_an_empty_one) {
  EXPECT_EQ(days_of(2 * day_s).size(), 2u);
}

TEST_F(RoverDays, are_a_table_for_spreadsheets) {
  const std::string csv = days_csv(days_of(2 * day_s), test_start());
  EXPECT_THAT(csv, HasSubstr("rover_id,day,from_utc,from_s,to_s,distance_m,drive_s,"));
  EXPECT_THAT(csv, HasSubstr("\nA,2," + format_utc(test_start() + time_at(day_s)) +
                             ",86400,172800,50400,"));
}

}  // namespace
}  // namespace lsos
