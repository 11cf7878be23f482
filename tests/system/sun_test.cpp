// `lsos-host sun`: the fields of the contract and their values.
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "system/process.h"

namespace lsos::test {
namespace {

using nlohmann::json;

json sun(const Words& arguments) {
  Words words{"sun"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const Outcome outcome = run(words);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return outcome.exit_code == 0 ? json::parse(outcome.out) : json::array({json::object()});
}

// Expected values are rows of shared/data/ephemeris, computed with another library.
TEST(Sun, at_the_moons_pole_stands_where_the_table_says) {
  const json rows = sun({"--planet", "Moon", "--site", "0,-89.5", "--at",
                         "2009-06-23T10:00:00Z,2009-06-23T12:00:00+02:00"});
  ASSERT_EQ(rows.size(), 2u);
  const json& row = rows[0];
  EXPECT_NEAR(row["azimuth_deg"].get<double>(), 171.31497, 0.01);
  EXPECT_NEAR(row["elevation_deg"].get<double>(), -1.24810, 0.001);
  EXPECT_NEAR(row["angular_diameter_deg"].get<double>(), 0.525523, 1e-4);
  EXPECT_NEAR(row["distance_m"].get<double>(), 151699550.5e3, 1e6);
  EXPECT_NEAR(row["sub_solar_lon_deg"].get<double>(), 171.316289, 0.001);
  EXPECT_NEAR(row["sub_solar_lat_deg"].get<double>(), 0.753177, 0.001);
  EXPECT_NEAR(row["earth_azimuth_deg"].get<double>(), 359.90608, 0.01);
  EXPECT_NEAR(row["earth_elevation_deg"].get<double>(), 2.54829, 0.003);
  EXPECT_NEAR(row["earth_distance_m"].get<double>(), 357925.4e3, 3e4);
  EXPECT_EQ(row["eclipsed"], 0);
  EXPECT_TRUE(row["elevation_refracted_deg"].is_null());
  EXPECT_EQ(row["utc"], "2009-06-23T10:00:00.000Z");
  EXPECT_EQ(rows[1]["azimuth_deg"], row["azimuth_deg"]);
}

// The lunar eclipse of 2025-03-14 is total from 06:26 to 07:31 UTC (NASA's catalogue of lunar
// eclipses): the whole Sun is behind Earth. Light refracted by Earth's air is not modelled.
TEST(Sun, goes_behind_earth_in_an_eclipse) {
  const json rows = sun({"--planet", "Moon", "--site", "0,0", "--at",
                         "2025-03-14T02:00Z,2025-03-14T05:00Z,2025-03-14T07:00Z"});
  EXPECT_EQ(rows[0]["eclipsed"], 0);
  EXPECT_GT(rows[1]["eclipsed"].get<double>(), 0.05);
  EXPECT_LT(rows[1]["eclipsed"].get<double>(), 1);
  EXPECT_EQ(rows[2]["eclipsed"], 1);
}

TEST(Sun, on_earth_is_raised_by_air_and_has_no_earth_in_its_sky) {
  const json row = sun(
      {"--planet", "Earth", "--site", "-111.52,35.55,1.8 km", "--at", "2016-12-31T23:59:60Z"})[0];
  EXPECT_GT(row["elevation_refracted_deg"].get<double>(), row["elevation_deg"].get<double>());
  EXPECT_TRUE(row["earth_azimuth_deg"].is_null());
  EXPECT_TRUE(row["eclipsed"].is_null());
}

TEST(Sun, on_mars_shows_earth) {
  const json row =
      sun({"--planet", "Mars", "--site", "137.4417,-4.5895", "--at", "2009-09-07T18:30:00Z"})[0];
  EXPECT_NEAR(row["azimuth_deg"].get<double>(), 258.07744, 0.02);
  EXPECT_NEAR(row["elevation_deg"].get<double>(), 55.46549, 0.01);
  EXPECT_NEAR(row["distance_m"].get<double>(), 223604439.7e3, 1e7);
  EXPECT_NEAR(row["earth_azimuth_deg"].get<double>(), 1.22354, 0.05);
  EXPECT_NEAR(row["earth_elevation_deg"].get<double>(), 78.95047, 0.01);
  EXPECT_NEAR(row["earth_distance_m"].get<double>(), 233882128.0e3, 1e7);
  EXPECT_TRUE(row["eclipsed"].is_null());
}

// The sky's share on Mars grows with the dust; on the Moon there is none.
TEST(Sun, has_direct_and_diffuse_light) {
  const Words noon_on_mars{"--planet", "Mars", "--site", "-5.5,-2", "--at", "2012-10-17T10:30Z"};
  const auto with = [&](const Words& more) {
    Words words = noon_on_mars;
    words.insert(words.end(), more.begin(), more.end());
    return sun(words)[0];
  };
  const json clear = with({"--optical-depth", "0"}), usual = with({});
  EXPECT_EQ(clear["diffuse_wpm2"], 0);
  EXPECT_EQ(usual["optical_depth"], 0.5);
  EXPECT_EQ(usual, with({"--optical-depth", "0.5", "--albedo", "0.25"}));
  const double level_wpm2 = usual["level_wpm2"];
  EXPECT_LT(level_wpm2, clear["level_wpm2"].get<double>());
  EXPECT_NEAR(usual["diffuse_wpm2"].get<double>() / level_wpm2, 0.35, 0.1);
  EXPECT_NEAR(usual["reflected_wpm2"].get<double>(), 0.25 * level_wpm2, 0.01);

  const json moon = sun({"--planet", "Moon", "--site", "30,10", "--at", "2026-01-01T00:00Z"})[0];
  EXPECT_NEAR(moon["direct_wpm2"].get<double>(), 1404, 5);
  EXPECT_EQ(moon["diffuse_wpm2"], 0);
  EXPECT_EQ(moon["reflected_wpm2"], 0);
  const json night = sun({"--planet", "Moon", "--site", "210,10", "--at", "2026-01-01T00:00Z"})[0];
  EXPECT_EQ(night["direct_wpm2"], 0);
}

}  // namespace
}  // namespace lsos::test
