// Places written as two numbers.
#include "planet/place_text.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "base/random.h"

namespace lsos {
namespace {

TEST(LonLat, is_read_in_degrees) {
  const Parsed<Geodetic> place = parse_lon_lat(" 46.3 , -89.84 deg");
  ASSERT_TRUE(place) << place.why;
  EXPECT_EQ(place.value->lon_rad, geodetic_from_degrees(46.3, -89.84).lon_rad);
  EXPECT_DOUBLE_EQ(place.value->lat_rad, geodetic_from_degrees(46.3, -89.84).lat_rad);
  EXPECT_EQ(place.value->height_m, 0);
}

TEST(LonLat, tells_what_is_allowed) {
  for (const char* text : {"", "46.3", "46.3,", "here,there", "46.3,1,2", "46,3 1,5", "1 m,2"}) {
    EXPECT_EQ(parse_lon_lat(text).why, "LON,LAT is wanted, in degrees, such as 31.5,20.25") << text;
  }
  EXPECT_EQ(parse_lon_lat("-89.84,146.3").why,
            "a longitude of -180..360 and a latitude of -90..90 deg are allowed; longitude comes "
            "first");
  EXPECT_EQ(parse_lon_lat("400,0").why,
            "a longitude of -180..360 and a latitude of -90..90 deg are allowed");
}

// Places of a plan have up to 15 decimals. A bit counts: kept routes are found by the site's bits.
TEST(LonLat, is_the_same_to_the_last_bit_when_it_is_read_again) {
  RandomStream random(1);
  for (int i = 0; i < 20'000; ++i) {
    const int decimals = 4 + i % 12;
    const std::string lon = fmt::format("{:.{}f}", 360 * random.uniform() - 180, decimals);
    const std::string lat = fmt::format("{:.{}f}", 180 * random.uniform() - 90, decimals);
    const Geodetic place = geodetic_from_degrees(std::stod(lon), std::stod(lat));
    const Parsed<Geodetic> read = parse_lon_lat(lon + "," + lat);
    ASSERT_TRUE(read) << read.why;
    EXPECT_EQ(read.value->lon_rad, place.lon_rad) << lon;
    EXPECT_EQ(read.value->lat_rad, place.lat_rad) << lat;
    const Parsed<Geodetic> again = parse_lon_lat(lon_lat_text(place));
    ASSERT_TRUE(again) << again.why;
    EXPECT_EQ(again.value->lon_rad, place.lon_rad) << lon;
    EXPECT_EQ(again.value->lat_rad, place.lat_rad) << lat;
  }
  EXPECT_EQ(lon_lat_text(geodetic_from_degrees(-111.447287, 35.7)), "-111.447287,35.7");
  EXPECT_EQ(lon_lat_text(geodetic_from_degrees(0, 0)), "0,0");
}

}  // namespace
}  // namespace lsos
