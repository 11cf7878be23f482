// Detail below a raster's resolution: roughness, rocks and craters.
#include "terrain/detail/rocks.h"
#include "terrain/detail/roughness.h"

#include <cmath>
#include <numbers>
#include <thread>

#include "ground_fixture.h"
#include "terrain/detail/detail.h"

namespace lsos {
namespace {

// Heights of a block of nodes, from several tiles.
std::vector<std::vector<double>> roughness_heights(const RoughnessField& field, int tiles) {
  std::vector<std::vector<double>> result(64 * tiles, std::vector<double>(64 * tiles));
  for (int row = 0; row < tiles; ++row) {
    for (int column = 0; column < tiles; ++column) {
      HeightTile tile({column, row});
      field.add_to(tile, {column * 64 - 1, row * 64 - 1, 1});
      for (int j = 0; j < 64; ++j) {
        for (int i = 0; i < 64; ++i) result[row * 64 + j][column * 64 + i] = tile.height_m(i, j);
      }
    }
  }
  return result;
}

TEST(Roughness, deviates_as_the_power_of_the_distance) {
  for (const double hurst : {0.5, 0.7, 0.9}) {
    const RoughnessField field({0.02, hurst, 64}, 9, {0.25});
    const auto h = roughness_heights(field, 16);
    const int side = static_cast<int>(h.size());
    // Shepard et al. 2001: RMS deviation nu(L) = nu_0 L^H.
    for (const int lag : {2, 4, 8, 16}) {  // to a sixteenth of the longest wave
      double sum = 0;
      int count = 0;
      for (int j = 0; j < side; ++j) {
        for (int i = 0; i + lag < side; ++i, ++count) {
          sum += (h[j][i + lag] - h[j][i]) * (h[j][i + lag] - h[j][i]);
        }
      }
      const double expected = 0.02 * std::pow(0.25 * lag, hurst);
      EXPECT_NEAR(std::sqrt(sum / count) / expected, 1, lag == 4 ? 0.03 : 0.15)
          << hurst << " " << lag;
    }
  }
}

TEST(Roughness, of_a_node_does_not_depend_on_the_tile_or_the_stride) {
  const RoughnessField field({0.02, 0.7, 32}, 9, {0.25});
  const auto h = roughness_heights(field, 4);
  HeightTile coarse({0, 0});
  field.add_to(coarse, {4 - 8, 4 - 8, 8});
  HeightTile right({1, 0});
  field.add_to(right, {63, -1, 1});
  for (int k = 0; k < 20; ++k) EXPECT_NEAR(coarse.height_m(k, k), h[4 + 8 * k][4 + 8 * k], 1e-15);
  for (int k = 0; k < 64; ++k) EXPECT_EQ(right.height_m(-1, k), h[k][63]);
  const RoughnessField around({0.02, 0.7, 32}, 9, {0.25, 1, 256});
  HeightTile first({0, 0}), again({4, 0});
  around.add_to(first, {-1, -1, 1});
  around.add_to(again, {255, -1, 1});
  for (int k = 0; k < 64; ++k) EXPECT_EQ(first.height_m(k, k), again.height_m(k, k));
}

std::vector<std::vector<double>> hills(int columns, int rows) {
  return rows_of(columns, rows, [](int column, int row) {
    return 20 * std::sin(column * 0.21) + 15 * std::cos(row * 0.17);
  });
}

Detail all_detail(bool with_rocks) {
  Detail detail;
  detail.craters.emplace();
  detail.craters->age_gyr = 3.9;
  detail.craters->diameter_min_m = 1;
  detail.craters->diameter_max_m = 200;
  detail.roughness = Roughness{0.03, 0.7, 16};
  if (with_rocks) detail.rocks = RockPopulation{0.05, 0.3, 3, 0.5};
  return detail;
}

// Relief that detail adds to a raster's heights, at so many places of a cell on each axis.
struct AddedRelief {
  static constexpr int samples = 12, cells = 40, side = samples * cells;
  std::vector<double> heights_m = std::vector<double>(std::size_t{side} * side);

  double at(int i, int j) const { return heights_m[static_cast<std::size_t>(j * side + i)]; }
  // RMS of the means over squares of so many samples a side, at every place.
  double rms_m(int across) const {
    std::vector<double> sums(std::size_t{side + 1} * (side + 1), 0);  // sums of all before i and j
    const auto sum = [&](int i, int j) -> double& {
      return sums[static_cast<std::size_t>(j * (side + 1) + i)];
    };
    for (int j = 0; j < side; ++j) {
      for (int i = 0; i < side; ++i) {
        sum(i + 1, j + 1) = at(i, j) + sum(i, j + 1) + sum(i + 1, j) - sum(i, j);
      }
    }
    double squares = 0;
    const int places = side - across + 1;
    for (int j = 0; j < places; ++j) {
      for (int i = 0; i < places; ++i) {
        const double mean_m =
            (sum(i + across, j + across) - sum(i, j + across) - sum(i + across, j) + sum(i, j)) /
            across / across;
        squares += mean_m * mean_m;
      }
    }
    return std::sqrt(squares / places / places);
  }
};

struct Case {
  const char* name;
  double cell_m;
};

class EnhancedRaster : public ::testing::TestWithParam<Case> {
 protected:
  TerrainSpec spec(bool is_enhanced, bool with_rocks = false) const {
    const double cell_m = GetParam().cell_m;
    const TextRaster raster{
        "+proj=stere +lat_0=-90 +R=1737400 +units=m",
        "100000," + std::to_string(cell_m) + ",0,50000,0," + std::to_string(-cell_m), "",
        hills(60, 60)};
    TerrainSpec spec = raster_terrain(raster.write("hills"));
    if (is_enhanced) spec.detail = all_detail(with_rocks);
    return spec;
  }
  SiteFrame site() const {
    // The middle of the raster.
    const double half_m = 30 * GetParam().cell_m;
    const double x = 100000 + half_m, y = 50000 - half_m;
    const double lat_deg =
        -90 + 2 * std::atan(std::hypot(x, y) / (2 * 1737400)) * 180 / std::numbers::pi;
    return site_on("Moon", std::atan2(x, y) * 180 / std::numbers::pi, lat_deg);
  }
  // Smaller craters and rocks are seldom hit by the samples and take long.
  Detail coarse_detail(bool with_rocks) const {
    Detail detail = all_detail(with_rocks);
    detail.craters->diameter_min_m = GetParam().cell_m / 4;
    detail.spacing_m = GetParam().cell_m / 16;
    if (with_rocks) detail.rocks->diameter_min_m = GetParam().cell_m / 16;
    return detail;
  }
  AddedRelief added_relief(const Detail& detail) const {
    const SiteFrame at = site();
    TerrainSpec with_detail = spec(false);
    with_detail.detail = detail;
    const Ground plain(spec(false), at, 4), enhanced(with_detail, at, 4);
    Ground::Probe plain_probe(plain), probe(enhanced);
    AddedRelief added;
    for (int j = 0; j < AddedRelief::side; ++j) {
      for (int i = 0; i < AddedRelief::side; ++i) {
        const auto cell = [](int k) { return 10 - 0.5 + (k + 0.5) / AddedRelief::samples; };
        const Vec3 p_S_m = at.p_S_m(place(cell(i), cell(j)));
        added.heights_m[static_cast<std::size_t>(j * AddedRelief::side + i)] =
            probe.sample(p_S_m).elevation_m - plain_probe.sample(p_S_m).elevation_m;
      }
    }
    return added;
  }
  // Place of a cell's centre, or of a point of the cell in shares of its side.
  Geodetic place(double column, double row) const {
    const double x = 100000 + (column + 0.5) * GetParam().cell_m;
    const double y = 50000 - (row + 0.5) * GetParam().cell_m;
    const double lat_rad = -std::numbers::pi / 2 + 2 * std::atan(std::hypot(x, y) / (2 * 1737400));
    return {std::atan2(x, y), lat_rad, 0};
  }
};

TEST_P(EnhancedRaster, adds_nothing_at_the_scale_of_its_cells) {
  Detail roughness = coarse_detail(false);
  roughness.craters.reset();
  for (const Detail& detail : {coarse_detail(false), coarse_detail(true), roughness}) {
    const AddedRelief added = added_relief(detail);
    const double rms_m = added.rms_m(1);
    EXPECT_GT(rms_m, detail.craters ? 0.005 * GetParam().cell_m : 0.01);  // there is something
    // The means are those over two cells by two, anywhere.
    EXPECT_LT(added.rms_m(2 * AddedRelief::samples), 0.1 * rms_m);
    double sum_m = 0;
    for (const double height_m : added.heights_m) sum_m += height_m;
    EXPECT_LT(std::abs(sum_m / static_cast<double>(added.heights_m.size())), 0.02 * rms_m);
  }
}

// Neither the centres of cells nor their rows and columns show.
TEST_P(EnhancedRaster, is_rough_alike_anywhere_in_a_cell_and_in_any_direction) {
  const AddedRelief added = added_relief(coarse_detail(false));
  constexpr int samples = AddedRelief::samples, side = AddedRelief::side;
  double middle = 0, all = 0;                       // mean squares
  int in_middle = 0, count = 0;                     // samples
  double straight = 0, slanted = 0;                 // mean square rise to an equally distant place
  constexpr int straight_lag = 7, slanted_lag = 5;  // 7 and 7.07 samples
  for (int j = slanted_lag; j < side - straight_lag; ++j) {
    for (int i = 0; i < side - straight_lag; ++i) {
      const double here_m = added.at(i, j);
      const auto is_middle = [](int k) { return k % samples >= 3 && k % samples < 9; };
      if (is_middle(i) && is_middle(j)) middle += here_m * here_m, ++in_middle;
      all += here_m * here_m, ++count;
      straight += std::pow(added.at(i + straight_lag, j) - here_m, 2) +
                  std::pow(added.at(i, j + straight_lag) - here_m, 2);
      slanted += std::pow(added.at(i + slanted_lag, j + slanted_lag) - here_m, 2) +
                 std::pow(added.at(i + slanted_lag, j - slanted_lag) - here_m, 2);
    }
  }
  EXPECT_NEAR(straight / slanted, 1, 0.06);
  EXPECT_NEAR(middle / in_middle / (all / count), 1, 0.15);
}

TEST_P(EnhancedRaster, has_normals_that_are_its_gradients) {
  const Ground ground(spec(true, true), site(), 4);
  Ground::Probe probe(ground);
  for (double x = -150; x < 150; x += 7.3) {
    const double far = x * GetParam().cell_m / 20;
    const Vec3 p = on_surface(ground, probe, {far, 0.6 * far + 3, 0});
    EXPECT_LT((probe.sample(p).normal_S - normal_by_differences(probe, p, 1e-5)).norm(), 2e-4) << x;
  }
}

TEST_P(EnhancedRaster, has_the_same_bits_whichever_tile_is_asked_first) {
  const Ground one(spec(true, true), site(), 4), two(spec(true, true), site(), 4);
  constexpr int count = 500;
  std::vector<double> forward(count), backward(count);
  const double step = GetParam().cell_m / 20;
  const auto point = [&](int k) { return Vec3(step * (k - 250), step * 0.7 * (k - 200), 0); };
  std::thread thread([&] {
    Ground::Probe probe(two);
    for (int k = count - 1; k >= 0; --k) backward[k] = probe.sample(point(k)).gap_m;
  });
  Ground::Probe probe(one);
  for (int k = 0; k < count; ++k) forward[k] = probe.sample(point(k)).gap_m;
  thread.join();
  EXPECT_EQ(forward, backward);
}

// Features much larger than the nodes of a coarse level remain, and lower no cell as a whole.
TEST_P(EnhancedRaster, is_from_afar_what_it_is_from_close_by) {
  TerrainSpec spec = this->spec(true);
  spec.detail->roughness.reset();
  spec.detail->craters->diameter_min_m = GetParam().cell_m / 4;
  const Ground ground(spec, site(), 4);
  Ground::Probe close(ground);
  for (const double nodes_per_cell : {64, 32, 16, 8, 4, 2}) {
    const double node_m = GetParam().cell_m / nodes_per_cell;
    Ground::Probe far = Ground::Probe::with_sparse_detail(ground, node_m);
    double rms_m = 0;
    constexpr int count = 2000;
    for (int k = 0; k < count; ++k) {
      const double r_m = 5 * GetParam().cell_m * std::sqrt((k + 0.5) / count), angle = 2.399963 * k;
      const Vec3 p_S_m{r_m * std::cos(angle), r_m * std::sin(angle), 0};
      rms_m += std::pow(far.sample(p_S_m).elevation_m - close.sample(p_S_m).elevation_m, 2) / count;
    }
    rms_m = std::sqrt(rms_m);
    EXPECT_LT(rms_m, 0.04 * node_m);
  }
}

INSTANTIATE_TEST_SUITE_P(Cells, EnhancedRaster,
                         ::testing::Values(Case{"two_metres", 2}, Case{"twenty_metres", 20},
                                           Case{"forty_metres", 40}),
                         [](const auto& test) { return test.param.name; });

// Fresh craters of one size are so few that most stand alone: depth, rim and outline are checked.
TEST(Detail, over_a_raster_has_craters_that_are_round_and_as_deep_as_published) {
  const TextRaster raster{"+proj=eqc +R=1737400 +units=m", "-60,1,0,60,0,-1", "",
                          rows_of(120, 120, [](int, int) { return 5; })};
  TerrainSpec spec = raster_terrain(raster.write("level"));
  const double diameter_m = 0.6, depth_m = 0.196 * diameter_m, rim_m = 0.036 * diameter_m;
  CraterPopulation craters;
  craters.diameter_min_m = diameter_m;
  craters.diameter_max_m = 1.001 * diameter_m;
  craters.density_pm2 = 20;  // of craters, one in 500 is in that range
  spec.detail = Detail{.craters = craters, .rocks = {}, .roughness = {}};
  const SiteFrame site = site_on("Moon", 0, 0);
  const Ground ground(spec, site, 4);
  Ground::Probe probe(ground);
  const Stereographic map(site.body(), 0, 0);
  const auto all = craters_touching(craters, 4, {{-40, -40}, {40, 40}});
  int alone = 0;
  for (const Crater& crater : all) {
    const auto is_near = [&](const Crater& other) {
      return &other != &crater && std::hypot(other.centre.x_m - crater.centre.x_m,
                                             other.centre.y_m - crater.centre.y_m) < 4;
    };
    if (std::ranges::any_of(all, is_near)) continue;
    ++alone;
    const auto height_m = [&](double r_m, double angle) {
      const PlanePoint at{crater.centre.x_m + r_m * std::cos(angle),
                          crater.centre.y_m + r_m * std::sin(angle)};
      return probe.sample(site.p_S_m(map.place(at))).elevation_m - 5;
    };
    double mean_m = 0, low_m = 1, high_m = -1, half_low_m = 1, half_high_m = -1;
    constexpr int around = 32;
    for (int k = 0; k < around; ++k) {
      const double angle = 2 * std::numbers::pi * k / around;
      const double crest_m = height_m(diameter_m / 2, angle);
      const double half_m = height_m(diameter_m / 4, angle);
      mean_m += crest_m / around;
      low_m = std::min(low_m, crest_m), high_m = std::max(high_m, crest_m);
      half_low_m = std::min(half_low_m, half_m), half_high_m = std::max(half_high_m, half_m);
    }
    // From rim to floor; above the ground far around; and all around.
    EXPECT_NEAR((mean_m - height_m(0, 0)) / depth_m, 1, 0.08);
    EXPECT_NEAR(height_m(1.45, 0.4), 0, 0.1 * rim_m);
    EXPECT_LT(high_m - low_m, 0.12 * depth_m);
    EXPECT_LT(half_high_m - half_low_m, 0.06 * depth_m);
  }
  EXPECT_GT(alone, 10);
}

TEST(Detail, stays_where_it_is_when_the_site_moves) {
  const TextRaster raster{"+proj=eqc +R=1737400 +units=m", "-300,5,0,300,0,-5", "",
                          hills(120, 120)};
  TerrainSpec spec = raster_terrain(raster.write("hills"));
  spec.detail = all_detail(true);
  const Ground here(spec, site_on("Moon", 0, 0), 4), there(spec, site_on("Moon", 0.005, -0.004), 4);
  for (double lon_deg = -0.004; lon_deg < 0.004; lon_deg += 0.0003) {
    const Geodetic at = geodetic_from_degrees(lon_deg, 0.6 * lon_deg);
    EXPECT_NEAR(*here.elevation_m(at), *there.elevation_m(at), 1e-6);
  }
}

TEST(Detail, has_rocks_that_the_sample_knows_of) {
  TerrainSpec spec = plane_terrain(0);
  spec.detail = Detail{.craters = {}, .rocks = RockPopulation{0.1, 0.4, 2, 0.5}, .roughness = {}};
  const Ground ground(spec, site_on("Moon", 10, 0), 4);
  Ground::Probe probe(ground);
  int on_rock = 0, all = 0;
  for (double x = -40; x < 40; x += 0.31) {
    for (double y = -40; y < 40; y += 0.29, ++all) {
      const GroundSample s = probe.sample({x, y, 0});
      const bool is_rock = s.soil == static_cast<int>(ground.soils().size()) - 1;
      EXPECT_EQ(is_rock, s.elevation_m > 0);
      on_rock += is_rock;
    }
  }
  RockPopulation p = *spec.detail->rocks;
  EXPECT_NEAR(static_cast<double>(on_rock) / all, rock_cover(p, 0.4), 0.006);
}

// A cell's side is found from distances, whose last digits differ from site to site.
TEST(Roughness, has_as_many_waves_whatever_the_last_digit_of_the_spacing) {
  HeightTile low({3, 5}), high({3, 5});
  RoughnessField({0.02, 0.7, 16}, 9, {0.25 * (1 - 1e-9)}).add_to(low, {200, 300, 1});
  RoughnessField({0.02, 0.7, 16}, 9, {0.25 * (1 + 1e-9)}).add_to(high, {200, 300, 1});
  for (int k = 0; k < 64; ++k) EXPECT_NEAR(low.height_m(k, k), high.height_m(k, k), 1e-8);
}

TEST(Relief, has_no_ground_on_the_other_side) {
  TerrainSpec spec;
  ReliefSurface relief;
  relief.lat_rad = -1.5;
  spec.layers = {relief};
  EXPECT_NO_THROW(Ground(spec, site_on("Moon", 20, -80), 0));
  EXPECT_THROW(Ground(spec, site_on("Moon", 20, 80), 0), InputError);
}

// At a latitude of 60 degrees a cell is half as wide as high.
TEST(Roughness, is_as_rough_to_the_east_as_to_the_north_off_the_equator) {
  const double deg = 0.0001;
  const TextRaster raster{"+proj=longlat +R=1737400", "10,0.0001,0,60.003,0,-0.0001", "",
                          rows_of(60, 60, [](int, int) { return 0; })};
  TerrainSpec spec = raster_terrain(raster.write("level"));
  spec.detail = Detail{.craters = {}, .rocks = {}, .roughness = Roughness{0.05, 0.7, 6}};
  const double lon_deg = 10 + 30 * deg, lat_deg = 60;
  const Ground ground(spec, site_on("Moon", lon_deg, lat_deg), 4);
  Ground::Probe probe(ground);
  double east = 0, north = 0;
  for (double x = -30; x < 30; x += 0.37) {
    for (double y = -60; y < 60; y += 0.41) {
      const double here_m = probe.sample({x, y, 0}).elevation_m;
      east += std::pow(probe.sample({x + 0.5, y, 0}).elevation_m - here_m, 2);
      north += std::pow(probe.sample({x, y + 0.5, 0}).elevation_m - here_m, 2);
    }
  }
  EXPECT_NEAR(std::sqrt(east / north), 1, 0.1);
}

}  // namespace
}  // namespace lsos
