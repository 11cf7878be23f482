#include "planet/ephemeris.h"

#include <erfa.h>
#include <erfam.h>
#include <gtest/gtest.h>

namespace lsos {
namespace {

// Between the cached nodes, against the series itself.
TEST(Ephemeris, is_within_metres_of_its_series_at_any_time) {
  Instant at = *parse_utc("2026-03-03T05:17:31Z").value;
  for (int k = 0; k < 40; ++k) {
    at.tai_us += 5 * 3600'000'000LL + 1'234'567;
    double heliocentric[2][3], barycentric[2][3], moon[2][3];
    ASSERT_EQ(eraEpv00(ERFA_DJ00, tt_days(at), heliocentric, barycentric), 0);
    eraMoon98(ERFA_DJ00, tt_days(at), moon);
    const BarycentricState earth_state = barycentric_state(CelestialBody::earth, at);
    const BarycentricState moon_state = barycentric_state(CelestialBody::moon, at);
    for (int i = 0; i < 3; ++i) {
      const double earth_m = barycentric[0][i] * ERFA_DAU;
      const double earth_mps = barycentric[1][i] * ERFA_DAU / 86400;
      EXPECT_NEAR(earth_state.p_I_m[i], earth_m, 1);
      EXPECT_NEAR(earth_state.v_I_mps[i], earth_mps, 1e-3);
      EXPECT_NEAR(moon_state.p_I_m[i], earth_m + moon[0][i] * ERFA_DAU, 5);
      EXPECT_NEAR(moon_state.v_I_mps[i], earth_mps + moon[1][i] * ERFA_DAU / 86400, 5e-3);
    }
  }
}

}  // namespace
}  // namespace lsos
