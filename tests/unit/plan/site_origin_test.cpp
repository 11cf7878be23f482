// The place from which x and y are counted and generated ground is laid out.
#include <gtest/gtest.h>

#include "plan_fixture.h"

namespace lsos::test {
namespace {

Plan plan_of_two(const Fields& mission_fields) {
  Faults faults;
  Plan plan = read_plan(write_file(document(mission(mission_fields) + rover("B") + rover("A"))),
                        declarations(), faults);
  EXPECT_EQ(faults_text(faults), "");
  return plan;
}

TEST(SiteOrigin, is_said_or_where_the_first_rover_starts) {
  const Plan silent = plan_of_two({});
  EXPECT_EQ(site_of(silent).lon_rad, silent.rovers[0].start.lon_rad);
  Plan said = plan_of_two({{"SiteOrigin", "31.01,20.5"}});
  EXPECT_EQ(site_of(said).lon_rad, geodetic_from_degrees(31.01, 20.5).lon_rad);
  EXPECT_EQ(site_of(said).lat_rad, geodetic_from_degrees(31.01, 20.5).lat_rad);
  EXPECT_NE(said.hash(), silent.hash());
  said.mission.earlier_site = geodetic_from_degrees(1, 2);
  EXPECT_EQ(site_of(said).lat_rad, geodetic_from_degrees(1, 2).lat_rad)
      << "that of the run with whose end it begins";
}

}  // namespace
}  // namespace lsos::test
