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
  // Zeros behind the comma count.
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

// What is said of a plan with one rover at 31,20 and these events.
std::string said_of(const std::string& events) {
  const std::string file =
      test::write_file(test::document(test::mission() + test::rover() + events));
  Faults faults;
  read_plan(file, test::declarations(), faults);
  return test::said(faults);
}

std::string drive(int sequence, const std::string& coordinates) {
  return test::event("Route", "leg", "A", sequence, {}, test::line(coordinates));
}

TEST(FarPlaces, long_legs_are_no_slip_where_all_are_long) {
  // Legs of 12 km: 0.4 degrees of latitude on the Moon.
  EXPECT_EQ(said_of(drive(1, "31,20 31,20.4") + drive(2, "31,20.4 31,20.8 31,21.2")), "");
  EXPECT_THAT(said_of(drive(1, "31,20 31,20.001 31,20.4") + drive(2, "31,20.4 31,20.401")),
              ::testing::HasSubstr("waypoint 3 (31.000000,20.400000) is 12 km from waypoint 2"));
}

TEST(FarPlaces, an_altitude_that_is_no_number_is_none) {
  EXPECT_EQ(said_of(drive(1, "31,20,nan 31.001,20,NaN")), "");
  EXPECT_EQ(said_of(drive(1, "31,20,\n31.001,20,\n31.002,20,")), "");
  EXPECT_EQ(said_of(drive(1, "31 , 20 , 31.001 , 20 , 31.002 , 20 ,")), "");
  // An altitude behind a blank is one.
  EXPECT_EQ(said_of(drive(1, "31, 20, 0\n31.001, 20, 5")), "");
}

}  // namespace
}  // namespace lsos
