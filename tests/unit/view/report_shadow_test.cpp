// Shadow of the report's map, against the Sun's disc marched over the same ground.
#include "view/ground/report_shadow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "planet/sunlight.h"
#include "unit/view/view_fixture.h"
#include "view/exposure/ground_light.h"

namespace lsos {
namespace {

using test::deg;

// The first moment, in steps of an hour, at which the Sun stands so high or higher there.
Instant sun_at(const SiteFrame& site, double elevation_rad) {
  Instant at = *parse_utc("2026-03-01T00:00:00Z").value;
  const auto elevation = [&] {
    return sunlight(site.body(), site.origin(), at, 0).seen.elevation_rad;
  };
  while (elevation() > 0) at = at + from_seconds(3600);
  while (elevation() < elevation_rad) at = at + from_seconds(3600);
  return at;
}

TEST(ReportShadow, is_where_marching_has_it) {
  const SiteFrame site(*find_body("Moon"), geodetic_from_degrees(0, -85));
  Ground ground(test::bowl_and_hill(), site, 1);
  const MapCells cells{-1500, 2500, 10, 300, 300};
  for (const double elevation_deg : {0.6, 2.0}) {
    const Instant at = sun_at(site, elevation_deg * deg);
    const std::vector<double> shares = sunlit_shares(ground, cells, at, 2);
    GroundLightProbe march(ground, cells.cell_m);
    double difference = 0, sum = 0, marched = 0;
    int count = 0;
    for (int row = 5; row < cells.rows; row += 10) {
      for (int column = 5; column < cells.columns; column += 10) {
        const Geodetic place = site.geodetic(cells.p_S_m(column, row));
        const Sunlight sun = sunlight(site.body(), place, at, 0);
        const Vec3 sun_S = direction_S(site, site.p_S_m(place), sun.seen);
        const double share = march.at(place, sun_S, sun.disc_rad)->sun_fraction;
        difference += std::abs(shares[cells.index(column, row)] - share);
        sum += shares[cells.index(column, row)];
        marched += share;
        ++count;
      }
    }
    EXPECT_GT(marched / count, 0.05) << elevation_deg;
    EXPECT_LT(marched / count, 0.95) << elevation_deg;
    EXPECT_NEAR(sum / count, marched / count, 0.02) << elevation_deg;
    EXPECT_LT(difference / count, 0.05) << elevation_deg;
  }
}

}  // namespace
}  // namespace lsos
