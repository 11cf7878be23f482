// The octaves to which resolutions are rounded, and the probes kept for them.
#include "view/ground/ground_probes.h"

#include "unit/terrain/ground_fixture.h"

namespace lsos {
namespace {

TEST(GroundProbes, round_a_resolution_down_to_an_octave_of_the_finest) {
  EXPECT_EQ(octave_below_m(0.2, 0), 0.2);
  EXPECT_EQ(octave_below_m(0.2, 0.39), 0.2);
  EXPECT_EQ(octave_below_m(0.2, 0.4), 0.4);
  EXPECT_EQ(octave_below_m(0.2, 0.79), 0.4);
  EXPECT_EQ(octave_below_m(1, 1000), 512);
}

TEST(GroundProbes, round_a_resolution_up_to_an_octave_of_the_finest) {
  EXPECT_EQ(octave_above_m(0.2, 0), 0.2);
  EXPECT_EQ(octave_above_m(0.2, 0.2), 0.2);
  EXPECT_EQ(octave_above_m(0.2, 0.3), 0.4);
  EXPECT_EQ(octave_above_m(0.2, 0.5), 0.8);
  EXPECT_EQ(octave_above_m(1, 1000), 1024);
}

TEST(GroundProbes, keep_one_probe_a_resolution) {
  const Ground ground(raster_terrain(TextRaster{"+proj=eqc +R=1737400 +units=m", "-20,1,0,20,0,-1",
                                                "", rows_of(40, 40, [](int, int) { return 5; })}
                                         .write("level")),
                      site_on("Moon", 0, 0), 1);
  GroundProbes probes(ground, ProbeDetail::sparse);
  Ground::Probe& full = probes.at(0);
  EXPECT_NE(&full, &probes.at(4));
  EXPECT_EQ(&full, &probes.at(0));
  EXPECT_NEAR(full.sample({1, 2, 0}).elevation_m, 5, 1e-9);
  EXPECT_NEAR(probes.at(4).sample({1, 2, 0}).elevation_m, 5, 1e-9);
}

}  // namespace
}  // namespace lsos
