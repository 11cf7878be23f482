// What telemetry says of rovers at a moment.
#include "product/comparison/last_measured.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "base/units.h"
#include "unit/record/log_fixture.h"

namespace lsos {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const std::vector<std::string> ids = {"SEV1", "SEV2"};
const SiteFrame mars_site(*find_body("Moon"), {radians(10), radians(20), 0});

MeasuredStates states_at(double time_s, const std::string& rows, double ground_m = 0) {
  const RunExtent extent{test_start(), SimTime{3'600'000'000}, ids};
  return last_measured(read_telemetry("t.csv", rows, extent), from_seconds(time_s), ids,
                       {&mars_site, [&](const Geodetic&) { return ground_m; }});
}

TEST(LastMeasured, is_the_last_value_of_each_kind_up_to_the_moment) {
  const MeasuredStates states = states_at(30,
                                          "time_s,rover_id,lon_deg,lat_deg,heading_deg,charge\n"
                                          "10,SEV1,1,2,90,0.9\n"
                                          "20,SEV1,,,100,0.8\n"
                                          "30,SEV1,3,4,,\n"
                                          "31,SEV1,5,6,110,0.7\n"
                                          "30,SEV2,,,,0.5\n");
  ASSERT_THAT(states.rovers, SizeIs(2));
  const LastMeasured& last = states.rovers.at("SEV1");
  EXPECT_DOUBLE_EQ(last.state.place->lon_rad, radians(3));
  EXPECT_DOUBLE_EQ(last.state.place->lat_rad, radians(4));
  EXPECT_DOUBLE_EQ(*last.state.heading_rad, radians(100));
  EXPECT_DOUBLE_EQ(*last.state.charge, 0.8);
  EXPECT_EQ(last.line, 4);
  EXPECT_EQ(last.age, from_seconds(10));
  EXPECT_FALSE(states.rovers.at("SEV2").state.place);
  EXPECT_FALSE(states.rovers.at("SEV2").state.heading_rad);
  EXPECT_THAT(states.warnings, IsEmpty());
}

TEST(LastMeasured, has_places_on_the_site_and_energies_too) {
  const MeasuredStates states = states_at(30,
                                          "time_s,rover_id,x_m,y_m,energy_kWh\n"
                                          "10,SEV1,100,0,2\n"
                                          "20,SEV1,0,-50,\n"
                                          "25,SEV1,7,,\n");
  const MeasuredState& state = states.rovers.at("SEV1").state;
  EXPECT_NEAR(state.place->lon_rad, radians(10), 1e-12);
  // 50 m south on a sphere of 1737.4 km.
  EXPECT_NEAR(state.place->lat_rad, radians(20) - 50 / 1'737'400.0, 1e-9);
  EXPECT_DOUBLE_EQ(*state.energy_j, 7.2e6);
  EXPECT_FALSE(state.charge);
}

// 50 km away the ground lies 719 m below the tangent plane, and the place of x and y at z = 0 is
// 21 m farther than that on the ground.
TEST(LastMeasured, has_places_far_from_the_site_on_the_ground) {
  const Geodetic place{radians(10), radians(20) - 50'000 / 1'738'400.0, 1000};
  const Vec3 p_S_m = mars_site.p_S_m(place);
  const auto latitude = [&](const std::string& rows) {
    return states_at(30, rows, 1000).rovers.at("SEV1").state.place->lat_rad;
  };
  EXPECT_NEAR(
      latitude(fmt::format("time_s,rover_id,x_m,y_m\n10,SEV1,{},{}\n", p_S_m.x(), p_S_m.y())),
      place.lat_rad, 1e-9);
  EXPECT_NEAR(latitude(fmt::format("time_s,rover_id,x_m,y_m,z_m\n10,SEV1,{},{},{}\n", p_S_m.x(),
                                   p_S_m.y(), p_S_m.z())),
              place.lat_rad, 1e-12);
}

TEST(LastMeasured, is_the_later_of_charge_and_energy) {
  const MeasuredStates states = states_at(30,
                                          "time_s,rover_id,charge,energy_kWh\n"
                                          "10,SEV1,0.9,\n20,SEV1,,2\n"
                                          "10,SEV2,,2\n20,SEV2,0.9,\n");
  EXPECT_FALSE(states.rovers.at("SEV1").state.charge);
  EXPECT_DOUBLE_EQ(*states.rovers.at("SEV1").state.energy_j, 7.2e6);
  EXPECT_DOUBLE_EQ(*states.rovers.at("SEV2").state.charge, 0.9);
  EXPECT_FALSE(states.rovers.at("SEV2").state.energy_j);
}

TEST(LastMeasured, warns_of_old_values_and_of_rovers_without_any) {
  const MeasuredStates states =
      states_at(100, "time_s,rover_id,charge\n10,SEV1,0.9\n101,SEV2,0.5\n");
  ASSERT_THAT(states.warnings, SizeIs(2));
  EXPECT_EQ(to_string(states.warnings[0]),
            "t.csv:2: warning: SEV1 goes on with values measured up to 0:01:30 before");
  EXPECT_EQ(to_string(states.warnings[1]),
            "t.csv: warning: has no place, heading or charge of SEV2 up to 0:01:40 of the mission: "
            "it goes "
            "on as simulated");
}

}  // namespace
}  // namespace lsos
