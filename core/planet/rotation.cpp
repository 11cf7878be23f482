#include "planet/rotation.h"

#include <erfa.h>
#include <erfam.h>

#include <array>
#include <cmath>

#include "base/units.h"
#include "planet/ephemeris.h"

namespace lsos {

namespace {

constexpr double days_a_century = 36525;

// Right ascension and declination of the north pole, and the prime meridian's angle, degrees.
struct Orientation {
  double pole_ra_deg = 0;
  double pole_dec_deg = 0;
  double meridian_deg = 0;
};

// Archinal et al. 2011, table 2: each term adds its amplitudes times a sine or cosine.
Orientation moon_orientation(double days) {
  struct Term {
    double argument_deg, argument_degpday;
    double ra_sin, dec_cos, meridian_sin;
  };
  constexpr std::array<Term, 13> terms{{{125.045, -0.0529921, -3.8787, 1.5419, 3.5610},
                                        {250.089, -0.1059842, -0.1204, 0.0239, 0.1208},
                                        {260.008, 13.0120009, 0.0700, -0.0278, -0.0642},
                                        {176.625, 13.3407154, -0.0172, 0.0068, 0.0158},
                                        {357.529, 0.9856003, 0, 0, 0.0252},
                                        {311.589, 26.4057084, 0.0072, -0.0029, -0.0066},
                                        {134.963, 13.0649930, 0, 0.0009, -0.0047},
                                        {276.617, 0.3287146, 0, 0, -0.0046},
                                        {34.226, 1.7484877, 0, 0, 0.0028},
                                        {15.134, -0.1589763, -0.0052, 0.0008, 0.0052},
                                        {119.743, 0.0036096, 0, 0, 0.0040},
                                        {239.961, 0.1643573, 0, 0, 0.0019},
                                        {25.053, 12.9590088, 0.0043, -0.0009, -0.0044}}};
  const double centuries = days / days_a_century;
  Orientation o{269.9949 + 0.0031 * centuries, 66.5392 + 0.0130 * centuries,
                38.3213 + 13.17635815 * days - 1.4e-12 * days * days};
  for (const Term& term : terms) {
    const double argument_rad = radians(term.argument_deg + term.argument_degpday * days);
    o.pole_ra_deg += term.ra_sin * std::sin(argument_rad);
    o.pole_dec_deg += term.dec_cos * std::cos(argument_rad);
    o.meridian_deg += term.meridian_sin * std::sin(argument_rad);
  }
  return o;
}

// Archinal et al. 2018, table 1.
Orientation mars_orientation(double days) {
  struct Term {
    double amplitude_deg, argument_deg, argument_degpcentury;
  };
  constexpr Term ra[] = {{0.000068, 198.991226, 19139.4819985},
                         {0.000238, 226.292679, 38280.8511281},
                         {0.000052, 249.663391, 57420.7251593},
                         {0.000009, 266.183510, 76560.6367950},
                         {0.419057, 79.398797, 0.5042615}};
  constexpr Term dec[] = {{0.000051, 122.433576, 19139.9407476},
                          {0.000141, 43.058401, 38280.8753272},
                          {0.000031, 57.663379, 57420.7517205},
                          {0.000005, 79.476401, 76560.6495004},
                          {1.591274, 166.325722, 0.5042615}};
  constexpr Term meridian[] = {
      {0.000145, 129.071773, 19140.0328244}, {0.000157, 36.352167, 38281.0473591},
      {0.000040, 56.668646, 57420.9295360},  {0.000001, 67.364003, 76560.2552215},
      {0.000001, 104.792680, 95700.4387578}, {0.584542, 95.391654, 0.5042615}};
  const double centuries = days / days_a_century;
  Orientation o{317.269202 - 0.10927547 * centuries, 54.432516 - 0.05827105 * centuries,
                176.049863 + 350.891982443297 * days};
  const auto angle_rad = [&](const Term& term) {
    return radians(term.argument_deg + term.argument_degpcentury * centuries);
  };
  for (const Term& term : ra) o.pole_ra_deg += term.amplitude_deg * std::sin(angle_rad(term));
  for (const Term& term : dec) o.pole_dec_deg += term.amplitude_deg * std::cos(angle_rad(term));
  for (const Term& term : meridian) {
    o.meridian_deg += term.amplitude_deg * std::sin(angle_rad(term));
  }
  return o;
}

Mat3 rotation_matrix(const Orientation& o) {
  const auto about = [](const Vec3& axis, double angle_deg) -> Mat3 {
    return Eigen::AngleAxisd(-radians(angle_deg), axis).toRotationMatrix();
  };
  return about(Vec3::UnitZ(), std::fmod(o.meridian_deg, 360)) *
         about(Vec3::UnitX(), 90 - o.pole_dec_deg) * about(Vec3::UnitZ(), 90 + o.pole_ra_deg);
}

Mat3 earth_rotation(Instant at) {
  constexpr double utc_epoch = 2451544.5;  // Julian date
  double matrix[3][3];
  eraC2t00b(ERFA_DJ00, tt_days(at), utc_epoch, utc_days(at), 0, 0, matrix);
  Mat3 R;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) R(i, j) = matrix[i][j];
  }
  return R;
}

}  // namespace

Mat3 R_FI(const Body& body, Instant at) {
  switch (body.id) {
    case BodyId::moon:
      return rotation_matrix(moon_orientation(tt_days(at)));
    case BodyId::mars:
      return rotation_matrix(mars_orientation(tt_days(at)));
    case BodyId::earth:
    case BodyId::other:
      break;
  }
  return earth_rotation(at);
}

}  // namespace lsos
