#include "terrain/grid/height_tile.h"

#include <gmock/gmock.h>

#include <cmath>

namespace lsos {
namespace {

template <class F>
HeightTile tile_with(TileKey key, const F& f) {
  HeightTile tile(key);
  for (int row = -1; row <= 65; ++row) {
    for (int column = -1; column <= 65; ++column) {
      tile.height_m(column, row) =
          f(static_cast<double>(key.column * 64 + column), static_cast<double>(key.row * 64 + row));
    }
  }
  for (int row = 0; row < 64; ++row) {
    for (int column = 0; column < 64; ++column) tile.set_ground(column, row);
  }
  return tile;
}

TEST(HeightTile, is_found_by_floor) {
  EXPECT_EQ(CellPoint(0, 63.999).tile(), (TileKey{0, 0}));
  EXPECT_EQ(CellPoint(-0.001, 64).tile(), (TileKey{-1, 1}));
  EXPECT_EQ(CellPoint(-64, -64.001).tile(), (TileKey{-1, -2}));
  EXPECT_EQ(CellPoint(-3, 0).along_u, 0);
  EXPECT_EQ(CellPoint(-3, 2.25).along_v, 0.25);
}

TEST(HeightTile, surface_equals_the_nodes) {
  const auto f = [](double u, double v) { return 1000 + std::sin(u) * std::cos(2 * v); };
  const HeightTile tile = tile_with({-1, 2}, f);
  for (double u : {-64.0, -30.0, -1.0}) {
    for (double v : {128.0, 140.0, 191.0}) {
      EXPECT_NEAR(surface_height(tile, {u, v}).height_m, f(u, v), 1e-12);
    }
  }
}

TEST(HeightTile, surface_is_exact_for_quadratic_heights) {
  const auto f = [](double u, double v) {
    return 5 + 0.5 * u - 2 * v + 0.25 * u * u - 0.1 * u * v + 0.3 * v * v;
  };
  const HeightTile tile = tile_with({0, 0}, f);
  const SurfaceHeight found = surface_height(tile, {20.3, 40.8});
  EXPECT_NEAR(found.height_m, f(20.3, 40.8), 1e-10);
  EXPECT_NEAR(found.by_u_m, 0.5 + 0.5 * 20.3 - 0.1 * 40.8, 1e-10);
  EXPECT_NEAR(found.by_v_m, -2 - 0.1 * 20.3 + 0.6 * 40.8, 1e-10);
}

TEST(HeightTile, level_ground_stays_level_to_the_last_bit) {
  const HeightTile tile = tile_with({0, 0}, [](double, double) { return 1234.5678; });
  const SurfaceHeight found = surface_height(tile, {10.123, 20.456});
  EXPECT_EQ(found.height_m, 1234.5678);
  EXPECT_EQ(found.by_u_m, 0);
  EXPECT_EQ(found.by_v_m, 0);
}

TEST(HeightTile, neighbours_meet_with_equal_height_and_gradient) {
  const auto f = [](double u, double v) { return std::sin(0.8 * u) + std::cos(0.6 * v + u); };
  const HeightTile left = tile_with({0, 0}, f);
  const HeightTile right = tile_with({1, 0}, f);
  for (double v = 0.1; v < 64; v += 1.7) {
    const SurfaceHeight a = surface_height(left, {std::nextafter(64.0, 0.0), v});
    const SurfaceHeight b = surface_height(right, {64.0, v});
    EXPECT_NEAR(a.height_m, b.height_m, 1e-12);
    EXPECT_NEAR(a.by_u_m, b.by_u_m, 1e-12);
    EXPECT_NEAR(a.by_v_m, b.by_v_m, 1e-12);
  }
}

TEST(HeightTile, has_no_height_where_there_is_no_ground) {
  HeightTile tile({0, 0});
  tile.set_ground(3, 4);
  EXPECT_TRUE(std::isnan(surface_height(tile, {2.9, 4.5}).height_m));
  EXPECT_FALSE(std::isnan(surface_height(tile, {3.1, 4.5}).height_m));
}

}  // namespace
}  // namespace lsos
