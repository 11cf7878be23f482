#include "planet/ephemeris.h"

#include <erfa.h>
#include <erfam.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "base/error.h"
#include "base/sim_time.h"

namespace lsos {

namespace {

constexpr double tt_minus_tai_s = 32.184;

BarycentricState state_of(const double pv_au[2][3]) {
  return {Vec3(pv_au[0][0], pv_au[0][1], pv_au[0][2]) * ERFA_DAU,
          Vec3(pv_au[1][0], pv_au[1][1], pv_au[1][2]) * (ERFA_DAU / day_length_s)};
}

BarycentricState operator+(const BarycentricState& a, const BarycentricState& b) {
  return {a.p_I_m + b.p_I_m, a.v_I_mps + b.v_I_mps};
}
BarycentricState operator-(const BarycentricState& a, const BarycentricState& b) {
  return {a.p_I_m - b.p_I_m, a.v_I_mps - b.v_I_mps};
}

// Evaluates the series, a sum of a few thousand terms, at `days` of TT since J2000.
BarycentricState series(CelestialBody body, double days) {
  double heliocentric[2][3], barycentric[2][3];
  // Status 1: outside 1900..2100, where the series continues with less accuracy.
  LSOS_ASSERT(eraEpv00(ERFA_DJ00, days, heliocentric, barycentric) >= 0);
  BarycentricState earth = state_of(barycentric);
  switch (body) {
    case CelestialBody::earth:
      return earth;
    case CelestialBody::sun:
      return earth - state_of(heliocentric);
    case CelestialBody::moon: {
      double geocentric[2][3];
      eraMoon98(ERFA_DJ00, days, geocentric);
      return earth + state_of(geocentric);
    }
    case CelestialBody::mars: {
      constexpr int mars = 4;
      double pv[2][3];
      LSOS_ASSERT(eraPlan94(ERFA_DJ00, days, mars, pv) >= 0);
      return earth - state_of(heliocentric) + state_of(pv);
    }
  }
  return earth;
}

// The series is evaluated at whole eighths of a day and joined by cubics with its positions and
// velocities there: within metres of it, and hundreds of times faster.
constexpr int nodes_a_day = 8;

struct Node {
  std::int64_t number = INT64_MIN;
  BarycentricState state;
};

const BarycentricState& node(CelestialBody body, std::int64_t number) {
  constexpr int bodies = 4, cached = 4;
  thread_local std::array<std::array<Node, cached>, bodies> nodes;
  Node& node =
      nodes[static_cast<std::size_t>(body)][static_cast<std::size_t>(number & (cached - 1))];
  if (node.number != number) {
    node = {number, series(body, static_cast<double>(number) / nodes_a_day)};
  }
  return node.state;
}

}  // namespace

double tt_days(Instant at) {
  return (static_cast<double>(at.tai_us) * 1e-6 + tt_minus_tai_s) / day_length_s - 0.5;
}

BarycentricState barycentric_state(CelestialBody body, Instant at) {
  const double nodes = tt_days(at) * nodes_a_day;
  const auto before = static_cast<std::int64_t>(std::floor(nodes));
  const BarycentricState& a = node(body, before);
  const BarycentricState& b = node(body, before + 1);
  const double t = nodes - static_cast<double>(before);
  constexpr double span_s = day_length_s / nodes_a_day;
  const Vec3 from_m = a.v_I_mps * span_s, to_m = b.v_I_mps * span_s, delta_m = b.p_I_m - a.p_I_m;
  // p = a + t (from + t (c2 + t c3))
  const Vec3 c2 = 3 * delta_m - 2 * from_m - to_m, c3 = from_m + to_m - 2 * delta_m;
  return {a.p_I_m + t * (from_m + t * (c2 + t * c3)),
          (from_m + t * (2 * c2 + 3 * t * c3)) / span_s};
}

double disc_radius_m(CelestialBody body) {
  switch (body) {
    case CelestialBody::sun:
      return 695700e3;
    case CelestialBody::earth:
      return 6371e3;
    case CelestialBody::moon:
      return 1737.4e3;
    case CelestialBody::mars:
      return 3389.5e3;
  }
  return 0;
}

}  // namespace lsos
