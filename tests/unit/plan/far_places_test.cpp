#include "plan/far_places.h"

#include <gmock/gmock.h>

#include "plan_fixture.h"

namespace lsos {
namespace {

std::vector<double> degrees_of(const std::string& coordinates) {
  std::vector<double> values;
  for (const Geodetic& place : with_decimal_commas(coordinates)) {
    values.push_back(lon_deg(place));
    values.push_back(lat_deg(place));
  }
  return values;
}

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(FarPlaces, whole_numbers_may_be_meant_with_decimal_commas) {
  constexpr double rounding = 1e-9;
  EXPECT_THAT(degrees_of("31,5 12,25"),
              ElementsAre(DoubleNear(31.5, rounding), DoubleNear(12.25, rounding)));
  // Leading zeros after the decimal comma count.
  EXPECT_THAT(degrees_of("-31,0001\n12,0002"),
              ElementsAre(DoubleNear(-31.0001, rounding), DoubleNear(12.0002, rounding)));
  EXPECT_THAT(degrees_of("31.5,12"), IsEmpty());
  EXPECT_THAT(degrees_of("31,5"), IsEmpty());
  EXPECT_THAT(degrees_of("31,5 12,-2"), IsEmpty());
  EXPECT_THAT(degrees_of("31,5,0 12,2,0"), IsEmpty());
  EXPECT_THAT(degrees_of("31,5 91,2"), IsEmpty());
}

TEST(FarPlaces, distances_are_told_with_as_many_digits_as_matter) {
  EXPECT_EQ(distance_text(49.6), "50 m");
  EXPECT_EQ(distance_text(4210), "4.2 km");
  EXPECT_EQ(distance_text(912345), "912 km");
}

// The faults of a plan with one rover at 31,20 and these events.
std::string faults_of_events(const std::string& events) {
  const std::string file =
      test::write_file(test::document(test::mission() + test::rover() + events));
  Faults faults;
  read_plan(file, test::declarations(), faults);
  return test::faults_text(faults);
}

std::string drive(int sequence, const std::string& coordinates) {
  return test::event("Route", "leg", "A", sequence, {}, test::line(coordinates));
}

TEST(FarPlaces, long_legs_are_no_slip_where_all_are_long) {
  // Legs of 12 km: 0.4 degrees of latitude on the Moon.
  EXPECT_EQ(faults_of_events(drive(1, "31,20 31,20.4") + drive(2, "31,20.4 31,20.8 31,21.2")), "");
  EXPECT_THAT(faults_of_events(drive(1, "31,20 31,20.001 31,20.4") + drive(2, "31,20.4 31,20.401")),
              ::testing::HasSubstr("waypoint 3 (31.000000,20.400000) is 12 km from waypoint 2"));
}

// The faults of a plan whose rover begins at `start` and drives along `coordinates`.
std::string faults_of_drive(const std::string& start, const std::string& coordinates) {
  const test::Fields rover{{"RoverId", "A"}, {"RoverType", "SEV"}};
  const std::string file = test::write_file(
      test::document(test::mission() + test::placemark("", "#Rover", rover, test::point(start)) +
                     drive(1, coordinates)));
  Faults faults;
  read_plan(file, test::declarations(), faults);
  return test::faults_text(faults);
}

TEST(FarPlaces, one_long_leg_is_no_slip_where_there_is_little_to_compare_it_with) {
  EXPECT_EQ(faults_of_drive("31,20", "31,20 31,20.4"), "");
  // The legs are 400 m and 10.6 km long and begin beside the rover.
  EXPECT_EQ(faults_of_drive("31,20", "31,20.0005 31,20.0137 31,20.3633"), "");
  EXPECT_THAT(faults_of_drive("31,20", "31,20 31,24"),
              ::testing::HasSubstr("waypoint 2 (31.000000,24.000000) is 121 km from waypoint 1"));
  EXPECT_THAT(faults_of_drive("31,20", "31,20 31,20.4 31,20.001"),
              ::testing::HasSubstr("waypoint 2 (31.000000,20.400000) is 12 km"));
  EXPECT_THAT(faults_of_drive("31,20", "31,20.4 31,20.001 31,20.002"),
              ::testing::HasSubstr("waypoint 1 (31.000000,20.400000) is 12 km"));
}

TEST(FarPlaces, near_equal_longitude_and_latitude_are_no_slip) {
  EXPECT_EQ(faults_of_drive("30.0,30.05", "30.0,30.05 30.05,30.0"), "");
  EXPECT_THAT(faults_of_drive("30.3,30.3", "30.0,30.5 30.5,30.0"),
              ::testing::Not(::testing::HasSubstr("exchanged")));
  EXPECT_EQ(faults_of_drive("0.03,0.03", "0.03,0.03 0,0"), "");
  EXPECT_THAT(faults_of_drive("31,12", "31,12 12,31.01"),
              ::testing::HasSubstr("with longitude and latitude exchanged it would be"));
  EXPECT_THAT(faults_of_drive("0.5,0.5", "0.5,0.5 0,0"),
              ::testing::HasSubstr("0,0 is what tools write"));
}

TEST(FarPlaces, an_altitude_that_is_no_number_is_none) {
  EXPECT_EQ(faults_of_events(drive(1, "31,20,nan 31.001,20,NaN")), "");
  EXPECT_EQ(faults_of_events(drive(1, "31,20,\n31.001,20,\n31.002,20,")), "");
  EXPECT_EQ(faults_of_events(drive(1, "31 , 20 , 31.001 , 20 , 31.002 , 20 ,")), "");
  // A number after a comma and a blank is an altitude.
  EXPECT_EQ(faults_of_events(drive(1, "31, 20, 0\n31.001, 20, 5")), "");
}

}  // namespace
}  // namespace lsos
