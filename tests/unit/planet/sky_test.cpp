// Sun and Earth in the sky, against tables made with another library (shared/data/ephemeris).
#include "planet/sky.h"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <vector>

#include "planet/rotation.h"
#include "support/reference_data.h"

namespace lsos {
namespace {

constexpr double deg = std::numbers::pi / 180;

using Row = std::map<std::string, std::string>;

std::vector<Row> rows_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  const auto cells = [](const std::string& line) {
    std::vector<std::string> result;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) result.push_back(cell);
    return result;
  };
  std::string line;
  std::getline(in, line);
  const auto names = cells(line);
  std::vector<Row> rows;
  while (std::getline(in, line)) {
    const auto values = cells(line);
    Row row;
    for (std::size_t k = 0; k < values.size(); ++k) row[names[k]] = values[k];
    rows.push_back(row);
  }
  return rows;
}

double number(const Row& row, const std::string& name) { return std::stod(row.at(name)); }

Instant instant(const std::string& utc) { return *parse_utc(utc).value; }

// The tables hold Terrestrial Time from a formula for UT1, which is up to 8.4 s off the leap
// seconds of UTC (2030): 0.035 deg of Mars's turn. Moon and Mars are compared at the table's TT,
// Earth, which turns with UT1, at its UTC. `site_sun_truth.csv` has the same epochs.
class Epochs {
 public:
  Epochs() {
    for (const Row& row : rows_of(reference_file("ephemeris/body_truth.csv"))) {
      days_[row.at("epoch_utc")] = number(row, "jd_tt_minus_2451545");
    }
  }
  Instant at(const Row& row) const {
    const std::string& utc = row.at("epoch_utc");
    if (row.at("body") == "Earth") return instant(utc);
    return {std::llround(((days_.at(utc) + 0.5) * 86400 - 32.184) * 1e6)};
  }

 private:
  std::map<std::string, double> days_;
};

// Angle between two directions.
double separation_deg(double lon_a_deg, double lat_a_deg, double lon_b_deg, double lat_b_deg) {
  const auto direction = [](double lon_deg, double lat_deg) {
    return Vec3(std::cos(lat_deg * deg) * std::cos(lon_deg * deg),
                std::cos(lat_deg * deg) * std::sin(lon_deg * deg), std::sin(lat_deg * deg));
  };
  const Vec3 a = direction(lon_a_deg, lat_a_deg), b = direction(lon_b_deg, lat_b_deg);
  return std::atan2(a.cross(b).norm(), a.dot(b)) / deg;
}

// Limits of the error in direction that the tables must hold.
double limit_deg(const std::string& body) { return body == "Mars" ? 0.02 : 0.01; }

TEST(Sky, has_sun_and_earth_over_the_places_of_the_table) {
  LSOS_NEEDS_REFERENCE("ephemeris/body_truth.csv");
  std::map<std::string, double> worst_deg, worst_earth_deg;
  const auto rows = rows_of(reference_file("ephemeris/body_truth.csv"));
  EXPECT_EQ(rows.size(), 54u);
  const Epochs epochs;
  int eclipses = 0;
  for (const Row& row : rows) {
    const std::string& name = row.at("body");
    SCOPED_TRACE(name + " " + row.at("epoch_utc"));
    const Body& body = *find_body(name);
    const Instant at = epochs.at(row);
    const Sky seen = sky(body, {0, 0, 0}, at);
    const double error_deg =
        separation_deg(lon_deg(seen.sub_solar), lat_deg(seen.sub_solar),
                       number(row, "subsolar_lonE_app_deg"), number(row, "subsolar_lat_app_deg"));
    EXPECT_LT(error_deg, limit_deg(name));
    worst_deg[name] = std::max(worst_deg[name], error_deg);

    const Sighting sun = sighting(body, Vec3::Zero(), CelestialBody::sun, at);
    EXPECT_NEAR(sun.distance_m / 1000 / number(row, "sun_dist_km"), 1, 5e-5);
    EXPECT_NEAR(2 * sun.disc_rad / deg, number(row, "sun_ang_diam_deg"), 1e-4);
    if (name == "Earth") continue;
    const Sighting earth = sighting(body, Vec3::Zero(), CelestialBody::earth, at);
    const double earth_deg =
        separation_deg(std::atan2(earth.direction_F.y(), earth.direction_F.x()) / deg,
                       std::asin(earth.direction_F.z()) / deg, number(row, "subearth_lonE_deg"),
                       number(row, "subearth_lat_deg"));
    EXPECT_LT(earth_deg, limit_deg(name));
    worst_earth_deg[name] = std::max(worst_earth_deg[name], earth_deg);
    EXPECT_NEAR(earth.distance_m / 1000 / number(row, "earth_dist_km"), 1, 1e-4);
    if (name != "Moon") continue;
    const double share = covered_share(sun.disc_rad, earth.disc_rad,
                                       std::atan2(sun.direction_F.cross(earth.direction_F).norm(),
                                                  sun.direction_F.dot(earth.direction_F)));
    const bool is_eclipse =
        number(row, "sun_earth_sep_deg") < number(row, "earth_ang_radius_deg") + sun.disc_rad / deg;
    EXPECT_EQ(share > 0, is_eclipse);
    EXPECT_EQ(row.at("earth_occults_sun").starts_with("no"), !is_eclipse);
    eclipses += is_eclipse;
  }
  for (const auto& [name, error_deg] : worst_deg) {
    std::printf("%-6s Sun within %.4f deg, Earth within %.4f deg\n", name.c_str(), error_deg,
                worst_earth_deg[name]);
  }
  std::printf("%d eclipses at the Moon\n", eclipses);
}

TEST(Sky, has_sun_and_earth_at_the_sites_of_the_table) {
  LSOS_NEEDS_REFERENCE("ephemeris/site_sun_truth.csv");
  const auto rows = rows_of(reference_file("ephemeris/site_sun_truth.csv"));
  EXPECT_EQ(rows.size(), 18u * 21u);
  const Epochs epochs;
  std::map<std::string, double> worst_deg, worst_earth_deg;
  for (const Row& row : rows) {
    const std::string& name = row.at("body");
    SCOPED_TRACE(name + " " + row.at("site") + " " + row.at("epoch_utc"));
    const Sky seen =
        sky(*find_body(name),
            geodetic_from_degrees(number(row, "lonE_deg"), number(row, "lat_deg")), epochs.at(row));
    const double error_deg =
        separation_deg(seen.sun.azimuth_rad / deg, seen.sun.elevation_rad / deg,
                       number(row, "sun_az_deg"), number(row, "sun_el_centre_deg"));
    EXPECT_LT(error_deg, limit_deg(name));
    worst_deg[name] = std::max(worst_deg[name], error_deg);
    EXPECT_NEAR(seen.sun_distance_m / 1000 / number(row, "sun_dist_km"), 1, 5e-5);
    EXPECT_NEAR(2 * seen.sun_disc_rad / deg, number(row, "sun_ang_diam_deg"), 1e-4);
    if (row.contains("earth_az_deg") && !row.at("earth_az_deg").empty()) {
      const double earth_deg =
          separation_deg(seen.earth->azimuth_rad / deg, seen.earth->elevation_rad / deg,
                         number(row, "earth_az_deg"), number(row, "earth_el_deg"));
      EXPECT_LT(earth_deg, limit_deg(name));
      worst_earth_deg[name] = std::max(worst_earth_deg[name], earth_deg);
    } else {
      EXPECT_FALSE(seen.earth);
    }
  }
  for (const auto& [name, error_deg] : worst_deg) {
    std::printf("%-6s Sun within %.4f deg, Earth within %.4f deg\n", name.c_str(), error_deg,
                worst_earth_deg[name]);
  }
}

TEST(Rotation, of_moon_and_mars_has_the_poles_and_meridians_of_the_table) {
  LSOS_NEEDS_REFERENCE("ephemeris/body_truth.csv");
  const Epochs epochs;
  for (const Row& row : rows_of(reference_file("ephemeris/body_truth.csv"))) {
    const std::string& name = row.at("body");
    if (name == "Earth") continue;
    SCOPED_TRACE(name + " " + row.at("epoch_utc"));
    const Mat3 R = R_FI(*find_body(name), epochs.at(row));
    const Vec3 pole_I = R.row(2);
    EXPECT_LT(separation_deg(std::atan2(pole_I.y(), pole_I.x()) / deg, std::asin(pole_I.z()) / deg,
                             number(row, "pole_ra_deg"), number(row, "pole_dec_deg")),
              name == "Mars" ? 1e-3 : 1e-5);
    // Angle from the ascending node of the equator on ICRF's to the prime meridian.
    const Vec3 node_F = R * Vec3::UnitZ().cross(pole_I).normalized();
    const double meridian_deg = -std::atan2(node_F.y(), node_F.x()) / deg;
    EXPECT_NEAR(std::remainder(meridian_deg - number(row, "W_deg"), 360), 0,
                name == "Mars" ? 5e-3 : 2e-5);
  }
}

// UTC stops for a second; the Sun does not.
TEST(Sky, goes_on_through_a_leap_second) {
  const Body& earth = *find_body("Earth");
  const auto turned_rad = [&](const char* from, const char* to) {
    const Mat3 turn = R_FI(earth, instant(to)) * R_FI(earth, instant(from)).transpose();
    return Eigen::AngleAxisd(turn).angle();
  };
  // Earth's turn follows UT1, which is UTC here: it stops while UTC counts its sixtieth second.
  EXPECT_NEAR(turned_rad("2016-12-31T23:59:58Z", "2016-12-31T23:59:59Z"), 7.292e-5, 1e-8);
  EXPECT_NEAR(turned_rad("2017-01-01T00:00:00Z", "2017-01-01T00:00:01Z"), 7.292e-5, 1e-8);
  EXPECT_NEAR(turned_rad("2016-12-31T23:59:59Z", "2017-01-01T00:00:01Z"), 2 * 7.292e-5, 1e-8);
  // The Moon moves by TT: three seconds pass.
  const auto moon_at = [](const char* utc) {
    return barycentric_state(CelestialBody::moon, instant(utc)).p_I_m;
  };
  const double speed_mps =
      barycentric_state(CelestialBody::moon, instant("2017-01-01T00:00:00Z")).v_I_mps.norm();
  EXPECT_NEAR((moon_at("2017-01-01T00:00:01Z") - moon_at("2016-12-31T23:59:59Z")).norm(),
              3 * speed_mps, 0.01 * speed_mps);
}

TEST(Sky, at_a_pole_and_at_180_degrees_has_no_jump) {
  const Body& moon = *find_body("Moon");
  const Instant at = instant("2026-07-01T00:00:00Z");
  const Sky east = sky(moon, geodetic_from_degrees(180, 10), at);
  const Sky west = sky(moon, geodetic_from_degrees(-180, 10), at);
  EXPECT_NEAR(std::remainder(east.sun.azimuth_rad - west.sun.azimuth_rad, 2 * std::numbers::pi), 0,
              1e-9);
  EXPECT_NEAR(east.sun.elevation_rad, west.sun.elevation_rad, 1e-9);
  // At the pole azimuths count from the meridian of the given longitude; the Sun stays in place.
  const Sky pole = sky(moon, geodetic_from_degrees(0, -90), at);
  const Sky turned = sky(moon, geodetic_from_degrees(90, -90), at);
  EXPECT_NEAR(pole.sun.elevation_rad, turned.sun.elevation_rad, 1e-9);
  EXPECT_NEAR(std::remainder(pole.sun.azimuth_rad - turned.sun.azimuth_rad - 90 * deg,
                             2 * std::numbers::pi),
              0, 1e-9);
}

TEST(CoveredShare, of_circles_is_that_of_elementary_geometry) {
  EXPECT_EQ(covered_share(1, 1, 2), 0);
  EXPECT_EQ(covered_share(1, 3, 2), 1);
  EXPECT_EQ(covered_share(2, 1, 0.5), 0.25);
  // Two equal circles through each other's centres: 2/3 - sqrt(3)/(2 pi).
  EXPECT_NEAR(covered_share(1, 1, 1), 2.0 / 3 - std::sqrt(3.0) / (2 * std::numbers::pi), 1e-12);
  // A straight edge runs through the middle of the disc.
  EXPECT_NEAR(covered_share(1, 1e5, 1e5), 0.5, 1e-4);
  EXPECT_NEAR(covered_share(1, 2, 1), 1, 1e-7);
}

// Bennett 1982 in the Explanatory Supplement at 1010 hPa and 10 deg C: 34.5' at the visible
// horizon, 9.9' at 5, 5.3' at 10, 1.0' at 45 degrees.
TEST(Refraction, raises_by_what_is_seen) {
  const auto seen_arcmin = [](double apparent_deg) {
    double true_deg = apparent_deg;
    for (int k = 0; k < 20; ++k) true_deg = apparent_deg - refraction_rad(true_deg * deg, 0) / deg;
    return (apparent_deg - true_deg) * 60;
  };
  EXPECT_NEAR(seen_arcmin(0), 34.5, 1);
  EXPECT_NEAR(seen_arcmin(5), 9.9, 0.3);
  EXPECT_NEAR(seen_arcmin(10), 5.3, 0.2);
  EXPECT_NEAR(seen_arcmin(45), 1.0, 0.05);
  EXPECT_NEAR(refraction_rad(90 * deg, 0), 0, 1e-5);
  EXPECT_LT(refraction_rad(0, 4000), 0.75 * refraction_rad(0, 0));
  EXPECT_EQ(refraction_rad(-90 * deg, 0), 0);
  EXPECT_NEAR(refraction_rad(-1.001 * deg, 0), refraction_rad(-0.999 * deg, 0), 1e-4);
}

}  // namespace
}  // namespace lsos
