// Energy that the panels of a Mars rover get in a sol, against what was reported from Mars. Nothing
// of the model of light is fitted to these reports; the panels' `factor` in MER.lua is set from the
// energy of the first sols.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lua/host/catalog.h"
#include "lua/host/mission_reader.h"
#include "planet/sunlight.h"
#include "planet/utc.h"

namespace lsos::test {
namespace {

struct Sol {
  const char* date;
  double optical_depth, clean_share, reported_wh;  // share of the panels that dust leaves
};

struct LevelEnergy {
  double direct_jpm2 = 0, all_jpm2 = 0;
};

// On level ground under a free sky.
LevelEnergy energy_of_sol(const Geodetic& place, const Sol& sol) {
  constexpr int steps = 720;
  constexpr double dark_ground = 0.15;  // Meridiani, recalled
  const Body& mars = *find_body("Mars");
  const Instant start = *parse_utc(sol.date).value;
  const double step_s = mars.solar_day_s / steps;
  LevelEnergy energy;
  for (int k = 0; k < steps; ++k) {
    const Sunlight light =
        sunlight(mars, place, start + from_seconds(k * step_s), sol.optical_depth, dark_ground);
    const double sine = std::max(0.0, std::sin(light.seen.elevation_rad));
    energy.direct_jpm2 += step_s * sine * light.irradiance_wpm2;
    energy.all_jpm2 += step_s * level_wpm2(light);
  }
  return energy;
}

// Area times efficiency of all panels, m2.
double effective_m2(const char* rover) {
  double sum_m2 = 0;
  for (const PanelSpec& panel : read_catalog("")->load_rover(rover).power.panels) {
    sum_m2 += panel.area_m2() * panel.efficiency * panel.factor;
  }
  return sum_m2;
}

// Reports of the mission's status, one a season: optical depth and "dust factor" as reported (NASA
// and JPL, collected in github.com/georgeslabreche/mars, opportunity_status/oppy_status.csv). The
// rover stood within a few degrees of level in most, and leaned to the north in winter.
constexpr Sol opportunity_sols[] = {
    {"2009-07-08", 0.438, 0.519, 429},  {"2009-09-29", 0.677, 0.599, 461},
    {"2010-08-24", 0.334, 0.7285, 562}, {"2010-11-02", 0.646, 0.678, 610},
    {"2011-01-24", 0.854, 0.616, 554},  {"2011-05-04", 0.819, 0.51, 367},
    {"2012-06-20", 0.229, 0.684, 526},  {"2012-10-17", 0.604, 0.624, 579},
    {"2013-01-16", 1.08, 0.623, 498},   {"2013-06-20", 0.801, 0.626, 497},
    {"2014-04-01", 0.433, 0.868, 661},  {"2014-05-13", 0.621, 0.964, 761},
    {"2014-10-20", 1.75, 0.697, 434},   {"2014-11-11", 1.474, 0.713, 516},
    {"2016-05-02", 0.508, 0.774, 645},  {"2016-08-30", 1.079, 0.693, 453},
    {"2018-01-30", 0.427, 0.847, 665},  {"2018-04-16", 0.558, 0.826, 726}};

// The model's energy over the reported one, averaged.
struct Ratios {
  double direct = 0, all = 0, all_worst = 0;
};
Ratios ratios_of_opportunity() {
  const Geodetic meridiani = geodetic_from_degrees(-5.4, -2.1, -1400);
  const double m2 = effective_m2("MER");
  Ratios mean;
  for (const Sol& sol : opportunity_sols) {
    const LevelEnergy energy = energy_of_sol(meridiani, sol);
    const double share =
        sol.clean_share * m2 / (3600 * sol.reported_wh) / std::size(opportunity_sols);
    mean.direct += share * energy.direct_jpm2;
    mean.all += share * energy.all_jpm2;
    mean.all_worst =
        std::max(mean.all_worst, share * energy.all_jpm2 * std::size(opportunity_sols));
  }
  return mean;
}

// The sky doubles what the disc alone gives over these sols. What is left is on the side of too
// much: the rover's mast shades its panels, dust on a panel dims light from aside more than the
// "dust factor" says, and dust reddens the light, which cells of three junctions use less well.
TEST(MarsLight, is_what_opportunity_reported) {
  const Ratios mean = ratios_of_opportunity();
  std::printf("of the reported energy a sol: direct light %.2f, with the sky %.2f (at most %.2f)\n",
              mean.direct, mean.all, mean.all_worst);
  EXPECT_LT(mean.direct, 0.7);
  EXPECT_NEAR(mean.all, 1, 0.15);
  EXPECT_LT(mean.all_worst, 1.5);
}

// "Nearly 900 Wh a sol" when both rovers had landed (NASA, January 2004), through air of an optical
// depth of about 0.9 after a storm (recalled).
TEST(MarsLight, gives_the_first_sols_their_energy) {
  for (const Geodetic& place :
       {geodetic_from_degrees(175.47, -14.57, -1900), geodetic_from_degrees(-5.53, -1.95, -1400)}) {
    const LevelEnergy energy = energy_of_sol(place, {"2004-01-26", 0.9, 1, 900});
    EXPECT_NEAR(effective_m2("MER") * energy.all_jpm2 / 3600, 900, 60);
  }
}

}  // namespace
}  // namespace lsos::test
