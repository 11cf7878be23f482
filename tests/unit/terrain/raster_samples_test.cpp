#include <cmath>
#include <thread>

#include "ground_fixture.h"

namespace lsos {
namespace {

constexpr char crs[] = "+proj=laea +lat_0=-10 +lon_0=50 +R=1737400 +units=m";

// A raster of 1 m whose column c, row r lies at x = c - half the width, y = half the height - r.
std::string centred(const std::string& name, const std::vector<std::vector<double>>& rows,
                    const std::string& band = "") {
  const std::string x = std::to_string(-0.5 * static_cast<double>(rows[0].size()) - 0.5);
  const std::string y = std::to_string(0.5 * static_cast<double>(rows.size()) + 0.5);
  return TextRaster{crs, x + ", 1, 0, " + y + ", 0, -1", band, rows}.write(name);
}

SiteFrame moon() { return site_on("Moon", 50, -10); }

TEST(RasterSamples, scale_offset_and_unit_are_applied) {
  const auto rows = rows_of(20, 20, [](int, int) { return 7.0; });
  const Ground ground(raster_terrain(centred("r", rows,
                                             "<UnitType>km</UnitType><Offset>2</Offset>"
                                             "<Scale>0.5</Scale>")),
                      moon(), 0);
  EXPECT_NEAR(*ground.elevation_m(moon().origin()), 5500, 1e-9);
}

TEST(RasterSamples, radii_are_taken_as_heights_above_the_body) {
  const auto rows = rows_of(20, 20, [](int, int) { return -300.0; });
  const Ground ground(raster_terrain(centred("r", rows, "<Offset>1737400</Offset>")), moon(), 0);
  EXPECT_NEAR(*ground.elevation_m(moon().origin()), -300, 1e-9);
}

TEST(RasterSamples, there_is_no_ground_in_cells_that_touch_missing_ones) {
  auto rows = rows_of(20, 20, [](int column, int row) { return 3.0 * column + row; });
  rows[9][10] = -9999;  // x = 0, y = 1
  rows[5][5] = NAN;     // x = -5, y = 5
  const Ground ground(raster_terrain(centred("r", rows, "<NoDataValue>-9999</NoDataValue>")),
                      moon(), 0);
  Ground::Probe probe(ground);
  const auto is_ground = [&](double x, double y) { return probe.sample({x, y, 0}).is_ground(); };
  EXPECT_FALSE(is_ground(0, 1));
  EXPECT_FALSE(is_ground(0.9, 1.9));
  EXPECT_FALSE(is_ground(-0.9, 0.1));
  EXPECT_TRUE(is_ground(1.1, 1));
  EXPECT_TRUE(is_ground(0, -0.1));
  EXPECT_FALSE(is_ground(-5.5, 5.5));
  EXPECT_TRUE(is_ground(-6.1, 5));
  const GroundSample none = probe.sample({0, 1, 0});
  EXPECT_TRUE(std::isnan(none.gap_m));
  EXPECT_TRUE(std::isnan(none.elevation_m));
  // A plane stays a plane beside the holes and up to the raster's edge.
  for (double x : {-10.4, -3.9, 1.05, 9.4}) {
    for (double y : {-9.3, 2.01, 10.4}) {
      EXPECT_NEAR(probe.sample({x, y, 0}).elevation_m, 3 * (x + 10) + (10 - y), 1e-3) << x << y;
    }
  }
}

TEST(RasterSamples, the_surface_is_smooth_beside_holes) {
  auto rows = rows_of(30, 30, [](int column, int row) {
    return 2 * std::sin(0.7 * column) + std::cos(0.5 * row + 0.2 * column);
  });
  for (int row = 12; row < 17; ++row) rows[row][15] = NAN;
  rows[17][16] = NAN;
  const Ground ground(raster_terrain(centred("r", rows)), moon(), 0);
  Ground::Probe probe(ground);
  // Borders between cells lie at whole numbers.
  for (double border = -14; border <= 14; ++border) {
    for (double along = -13.87; along < 14; along += 0.21) {
      for (bool is_column : {true, false}) {
        const auto at = [&](double offset) {
          return is_column ? Vec3(border + offset, along, 0) : Vec3(along, border + offset, 0);
        };
        const GroundSample before = probe.sample(at(-1e-4));
        const GroundSample after = probe.sample(at(1e-4));
        if (!before.is_ground() || !after.is_ground()) continue;
        EXPECT_LT((before.normal_S - after.normal_S).norm(), 2e-3) << border << " " << along;
        EXPECT_NEAR(before.elevation_m, after.elevation_m, 1e-3);
      }
    }
  }
}

TEST(RasterSamples, hash_follows_samples_and_georeference) {
  auto rows = rows_of(20, 20, [](int column, int row) { return 3.0 * column + row; });
  const auto hash = [](const std::string& file) {
    return Ground(raster_terrain(file), moon(), 0).hash();
  };
  const std::string first = hash(centred("a", rows));
  EXPECT_EQ(hash(centred("b", rows)), first);
  EXPECT_NE(hash(centred("c", rows, "<Offset>1</Offset>")), first);
  EXPECT_NE(hash(TextRaster{crs, "-10, 1, 0, 10.5, 0, -1", "", rows}.write("d")), first);
  rows[19][19] += 1e-6;
  EXPECT_NE(hash(centred("e", rows)), first);
}

// Bits must depend neither on what was sampled before, nor on other threads.
TEST(RasterSamples, are_equal_in_any_order_and_on_any_thread) {
  const auto rows = rows_of(300, 300, [](int column, int row) {
    return 20 * std::sin(0.11 * column) * std::cos(0.07 * row);
  });
  const std::string file = centred("r", rows);
  std::vector<Vec3> points;
  for (int k = 0; k < 3000; ++k) {
    points.emplace_back(140 * std::sin(0.7 * k), 140 * std::cos(1.3 * k), 0.01 * k);
  }
  const auto sampled = [&](const Ground& ground, bool reversed) {
    std::vector<GroundSample> samples(points.size());
    Ground::Probe probe(ground);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const std::size_t at = reversed ? points.size() - 1 - k : k;
      samples[at] = probe.sample(points[at]);
    }
    return samples;
  };
  const Ground alone(raster_terrain(file), moon(), 0);
  const std::vector<GroundSample> expected = sampled(alone, false);

  const Ground shared(raster_terrain(file), moon(), 0);
  std::vector<GroundSample> first, second;
  std::thread other([&] { first = sampled(shared, true); });
  second = sampled(shared, false);
  other.join();
  for (std::size_t k = 0; k < points.size(); ++k) {
    ASSERT_TRUE(expected[k].is_ground());
    for (const GroundSample& sample : {first[k], second[k]}) {
      ASSERT_EQ(sample.gap_m, expected[k].gap_m);
      ASSERT_EQ(sample.elevation_m, expected[k].elevation_m);
      ASSERT_EQ(sample.normal_S, expected[k].normal_S);
    }
  }
}

}  // namespace
}  // namespace lsos
