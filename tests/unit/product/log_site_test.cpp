// The frame in which a log has its places, where the ground itself is not at hand.
#include <gtest/gtest.h>

#include "product/report_data.h"
#include "unit/record/log_fixture.h"

namespace lsos {
namespace {

class LogSite : public ::testing::Test {
 protected:
  // A log whose only rover starts 30 km from the site, and the frame that was logged in.
  SiteFrame logged_at(const Geodetic& origin) {
    const SiteFrame logged(*find_body("Moon"), origin);
    SampleRow row = test_sample(0);
    row.p_S_m = {20e3, 22e3, 130};
    row.place = logged.geodetic(row.p_S_m);
    start_ = row.place;
    LogWriter log(folder_ / "log.gpkg", moon_crs, test_start());
    log.write(row);
    log.finish();
    return logged;
  }
  Plan plan() const {
    Plan plan;
    plan.mission.planet = find_body("Moon");
    plan.rovers.emplace_back().id = "SEV1";
    plan.rovers.front().start = {start_.lon_rad, start_.lat_rad, 0};
    return plan;
  }
  static void expect_equal(const SiteFrame& found, const SiteFrame& logged) {
    const Vec3 p_S_m(-5e3, 12e3, 40);
    const Geodetic there = found.geodetic(p_S_m), right = logged.geodetic(p_S_m);
    EXPECT_LT(surface_distance_m(found.body(), there, right), 1e-3);
    EXPECT_NEAR(there.height_m, right.height_m, 1e-3);
  }

  TestFolder folder_;
  Geodetic start_;
};

TEST_F(LogSite, is_that_of_the_plan) {
  const Geodetic origin = geodetic_from_degrees(12, -80, -1500);
  const SiteFrame logged = logged_at(origin);
  Plan with_site = plan();
  with_site.mission.site = Geodetic{origin.lon_rad, origin.lat_rad, 0};
  expect_equal(site_of(LogReader(folder_ / "log.gpkg"), with_site), logged);
}

TEST_F(LogSite, is_that_of_the_run_with_whose_end_it_begins) {
  const Geodetic origin = geodetic_from_degrees(12, -80, -1500);
  const SiteFrame logged = logged_at(origin);
  Plan begun = plan();
  begun.mission.site = geodetic_from_degrees(13, -80);
  begun.mission.earlier_site = Geodetic{origin.lon_rad, origin.lat_rad, 0};
  expect_equal(site_of(LogReader(folder_ / "log.gpkg"), begun), logged);
}

TEST_F(LogSite, is_where_the_first_rover_starts_otherwise) {
  const SiteFrame logged(*find_body("Moon"), geodetic_from_degrees(12, -80, -1500));
  SampleRow row = test_sample(0);
  row.p_S_m = {0, 0, 0.5};
  row.place = logged.geodetic({0, 0, 0.5});
  {
    LogWriter log(folder_ / "log.gpkg", moon_crs, test_start());
    log.write(row);
    log.finish();
  }
  start_ = row.place;
  expect_equal(site_of(LogReader(folder_ / "log.gpkg"), plan()), logged);
}

}  // namespace
}  // namespace lsos
