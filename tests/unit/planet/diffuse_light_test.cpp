// Light that dust and air scatter, against limits in closed form, photons followed one by one, and
// published tables.
#include "planet/diffuse_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/random.h"
#include "planet/sunlight.h"

namespace lsos {
namespace {

double sine_at(double zenith_deg) { return std::cos(zenith_deg * std::numbers::pi / 180); }

// Where the light of a layer goes, found by following photons with the phase function of Henyey and
// Greenstein. It shares nothing with the two-stream solution but the meaning of its parameters.
struct PhotonShares {
  double direct = 0, scattered_down = 0, escaped = 0, absorbed = 0;
};

PhotonShares follow_photons(const Dust& dust, double depth, double sine, double ground_albedo) {
  constexpr int count = 40'000;
  RandomStream random(7);
  const double g = dust.asymmetry;
  PhotonShares shares;
  for (int k = 0; k < count; ++k) {
    double at = 0, down = sine;  // optical depth below the top, cosine to the vertical
    bool is_scattered = false;
    for (;;) {
      at += down * -std::log(1 - random.uniform());
      if (at < 0) {
        shares.escaped += 1.0 / count;
        break;
      }
      if (at >= depth) {
        (is_scattered ? shares.scattered_down : shares.direct) += 1.0 / count;
        if (random.uniform() >= ground_albedo) break;
        at = depth;
        down = -std::sqrt(random.uniform());  // by Lambert's law
        is_scattered = true;
        continue;
      }
      if (random.uniform() >= dust.single_scattering_albedo) {
        shares.absorbed += 1.0 / count;
        break;
      }
      is_scattered = true;
      const double part = (1 - g * g) / (1 - g + 2 * g * random.uniform());
      const double cosine = (1 + g * g - part * part) / (2 * g);
      const double turn = 2 * std::numbers::pi * random.uniform();
      down = std::clamp(
          down * cosine +
              std::sqrt(std::max(0.0, (1 - down * down) * (1 - cosine * cosine))) * std::cos(turn),
          -1.0, 1.0);
    }
  }
  return shares;
}

TEST(DustyLight, without_dust_is_direct_alone) {
  const LayerLight none = dusty_light(mars_dust, 0, 0.5, 0.25);
  EXPECT_EQ(none.direct, 1);
  EXPECT_EQ(none.aureole, 0);
  EXPECT_EQ(none.sky, 0);
  const LayerLight little = dusty_light(mars_dust, 1e-6, 0.5, 0.25);
  EXPECT_NEAR(little.direct, 1, 3e-6);
  EXPECT_NEAR(little.aureole + little.sky, 0, 3e-6);
  EXPECT_NEAR(little.escaped, 0.25, 3e-6);
}

TEST(DustyLight, that_is_not_scattered_follows_beers_law) {
  for (const double depth : {0.1, 0.5, 3.}) {
    const LayerLight light = dusty_light({0, 0.6}, depth, 0.4, 0);
    EXPECT_NEAR(light.direct, std::exp(-depth / 0.4), 1e-15);
    EXPECT_NEAR(light.down(), light.direct, 1e-15);
    EXPECT_EQ(light.escaped, 0);
  }
}

// Dust that absorbs nothing sends each part of the light up or into the ground.
TEST(DustyLight, is_all_accounted_for_where_nothing_is_absorbed) {
  for (const double depth : {0.1, 1., 10., 100.}) {
    for (const double sine : {0.05, 0.5, 1.}) {
      for (const double albedo : {0., 0.25, 0.9}) {
        const LayerLight light = dusty_light({1, 0.79}, depth, sine, albedo);
        EXPECT_NEAR(light.escaped + (1 - albedo) * light.down(), 1, 1e-4)
            << depth << ' ' << sine << ' ' << albedo;
      }
    }
  }
}

// What is neither in the ground nor escaped was absorbed by the dust: as much as the photons say.
// The error of the two streams is greatest where the Sun is low.
TEST(DustyLight, goes_where_photons_go) {
  for (const double depth : {0.3, 1., 3.}) {
    for (const double sine : {0.3, 0.7, 1.}) {
      const PhotonShares photons = follow_photons(mars_dust, depth, sine, 0.25);
      const LayerLight light = dusty_light(mars_dust, depth, sine, 0.25);
      const double down = photons.direct + photons.scattered_down;
      EXPECT_NEAR(light.direct, photons.direct, 0.01) << depth << ' ' << sine;
      const double error = sine < 0.5 ? 0.05 : 0.035;
      EXPECT_NEAR(light.down(), down, error) << depth << ' ' << sine;
      EXPECT_NEAR(light.escaped, photons.escaped, error) << depth << ' ' << sine;
      EXPECT_NEAR(1 - light.escaped - 0.75 * light.down(), photons.absorbed, error)
          << depth << ' ' << sine;
    }
  }
}

TEST(DustyLight, never_falls_below_nothing_nor_breaks_at_its_limits) {
  for (const double albedo : {0., 0.5, 0.86, 1.}) {
    for (const double depth : {1e-12, 0.01, 1., 30., 1e4}) {
      for (const double sine : {1e-9, 0.01, 0.3, 1 / std::sqrt(3.), 0.79, 1.}) {
        const LayerLight light = dusty_light({albedo, 0.6}, depth, sine, 0.3);
        EXPECT_GE(light.direct, 0);
        EXPECT_GE(light.aureole, 0);
        EXPECT_GE(light.sky, 0);
        EXPECT_LE(light.down(), 1 / (1 - 0.3)) << albedo << ' ' << depth << ' ' << sine;
      }
    }
  }
}

// Normalised net flux on the ground, (1 - albedo) x downward light, for albedo 0.1: table III of
// Appelbaum and Flood 1990 (NASA TM 102299), computed by Pollack over many wavelengths. A row an
// optical depth; columns are zenith angles.
constexpr double table_zeniths_deg[] = {0, 10, 20, 30, 40, 50, 60, 70, 80, 85};
struct TableRow {
  double depth, flux[10];
};
constexpr TableRow flux_table[] = {
    {0.1, {0.885, 0.883, 0.882, 0.880, 0.876, 0.870, 0.857, 0.830, 0.755, 0.635}},
    {0.3, {0.847, 0.846, 0.841, 0.836, 0.826, 0.806, 0.774, 0.708, 0.562, 0.412}},
    {0.5, {0.810, 0.810, 0.802, 0.796, 0.778, 0.752, 0.708, 0.628, 0.452, 0.342}},
    {0.7, {0.776, 0.773, 0.766, 0.755, 0.733, 0.700, 0.646, 0.555, 0.383, 0.298}},
    {1, {0.732, 0.725, 0.717, 0.700, 0.670, 0.628, 0.560, 0.455, 0.317, 0.252}},
    {1.5, {0.651, 0.646, 0.633, 0.612, 0.580, 0.530, 0.460, 0.362, 0.251, 0.202}},
    {2, {0.582, 0.573, 0.558, 0.537, 0.500, 0.448, 0.378, 0.293, 0.208, 0.170}},
    {3, {0.460, 0.450, 0.434, 0.414, 0.376, 0.330, 0.273, 0.206, 0.150, 0.128}},
    {4, {0.370, 0.360, 0.347, 0.330, 0.296, 0.258, 0.212, 0.160, 0.118, 0.100}},
    {6, {0.228, 0.223, 0.215, 0.200, 0.178, 0.153, 0.130, 0.103, 0.080, 0.068}}};

TEST(DustyLight, is_that_of_the_published_table_for_mars) {
  double squares = 0;
  int count = 0;
  for (const TableRow& row : flux_table) {
    for (int k = 0; k < 10; ++k) {
      const double zenith_deg = table_zeniths_deg[k];
      const double net = 0.9 * dusty_light(mars_dust, row.depth, sine_at(zenith_deg), 0.1).down();
      const bool is_usual = row.depth <= 2 && zenith_deg <= 70;
      EXPECT_NEAR(net, row.flux[k], is_usual ? 0.02 : 0.055) << row.depth << ' ' << zenith_deg;
      if (!is_usual) continue;
      squares += (net - row.flux[k]) * (net - row.flux[k]);
      ++count;
    }
  }
  EXPECT_LT(std::sqrt(squares / count), 0.006);
}

// The same for albedo 0.4: the table of 1991 (Appelbaum and Landis, NASA TM 105216).
TEST(DustyLight, is_that_of_the_table_for_bright_ground) {
  struct Point {
    double depth, zenith_deg, flux;
  };
  for (const auto& [depth, zenith_deg, flux] :
       {Point{0.5, 0, 0.560}, Point{0.5, 30, 0.546}, Point{0.5, 60, 0.483}, Point{1, 0, 0.511},
        Point{1, 30, 0.488}, Point{1, 60, 0.392}, Point{2, 0, 0.417}, Point{2, 60, 0.273}}) {
    const double net = 0.6 * dusty_light(mars_dust, depth, sine_at(zenith_deg), 0.4).down();
    EXPECT_NEAR(net, flux, 0.022) << depth << ' ' << zenith_deg;
  }
}

// Bird and Hulstrom's model (SERI TR-642-761, 1981) for a clear, moderately turbid sky gives about
// 90 to 130 W/m2 of diffuse light at noon and 40 to 70 near 10 degrees (recalled: a band only).
TEST(ClearSky, scatters_about_a_tenth_of_the_light_at_noon_and_more_of_it_when_the_sun_is_low) {
  const auto diffuse_wpm2 = [](double elevation_deg) {
    const double elevation_rad = elevation_deg * std::numbers::pi / 180;
    return 1361 * std::sin(elevation_rad) *
           clear_sky_diffuse_share(clear_sky_share(elevation_rad, 0));
  };
  EXPECT_NEAR(diffuse_wpm2(60), 100, 30);
  EXPECT_NEAR(diffuse_wpm2(10), 50, 20);
  EXPECT_LT(diffuse_wpm2(0.1), 1);
}

}  // namespace
}  // namespace lsos
