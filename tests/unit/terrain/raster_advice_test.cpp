// Warnings about rasters that can be read and yet are not what they seem.
#include "terrain/raster/raster_advice.h"

#include <cstdlib>

#include "ground_fixture.h"

namespace lsos {
namespace {

using ::testing::HasSubstr;

// A globe of that many cells per degree.
TerrainSpec globe(double cells) {
  const int columns = static_cast<int>(360 * cells), rows = static_cast<int>(180 * cells);
  const TextRaster raster{
      "+proj=longlat +R=1737400",
      "0," + std::to_string(1 / cells) + ",0,90,0," + std::to_string(-1 / cells), "",
      rows_of(columns, rows, [](int column, int row) { return 300 * std::sin(column + row); })};
  return raster_terrain(raster.write("globe"));
}

TEST(Slivers, are_the_cells_next_to_a_pole) {
  for (const double cells : {0.1, 1.0}) {
    const TerrainSpec spec = globe(cells);
    for (const double side : {-1, 1}) {
      const Ground ground(spec, site_on("Moon", 20, side * 85), 0);
      // The cells at 87.08 degrees are 1 : 19.6.
      for (const double lat_deg : {0.0, 60.0, 80.0, 86.0, 87.08}) {
        EXPECT_EQ(ground.slivers(geodetic_from_degrees(20, side * lat_deg)), "") << lat_deg;
      }
      for (const double lat_deg : {87.3, 89.0, 89.9999, 90.0}) {
        EXPECT_THAT(
            ground.slivers(geodetic_from_degrees(20, side * lat_deg)),
            HasSubstr(side < 0 ? "a polar map is wanted, as gdalwarp -t_srs IAU_2015:30135"
                               : "a polar map is wanted, as gdalwarp -t_srs IAU_2015:30130"))
            << lat_deg;
      }
    }
  }
}

TEST(Slivers, do_not_matter_under_a_polar_map) {
  const TextRaster polar{"+proj=stere +lat_0=-90 +R=1737400 +units=m", "-5000,100,0,5000,0,-100",
                         "", rows_of(100, 100, [](int, int) { return 50; })};
  TerrainSpec spec = raster_terrain(polar.write("polar"));
  spec.layers.push_back(globe(1).layers.front());
  const Ground ground(spec, site_on("Moon", 0, -90), 0);
  EXPECT_EQ(ground.slivers(geodetic_from_degrees(0, -90)), "");
  EXPECT_EQ(ground.slivers(geodetic_from_degrees(40, -89.95)), "");
  EXPECT_THAT(ground.slivers(geodetic_from_degrees(40, -89)), HasSubstr("slivers"));
}

// Hills that rise by that many units over 400 km.
std::vector<Fault> advice_of(double rise, const std::string& band, const std::string& unit = "") {
  const TextRaster raster{"+proj=eqc +R=1737400 +units=m", "-200000,10000,0,200000,0,-10000", band,
                          rows_of(40, 40, [&](int column, int row) {
                            return -2 + rise / 4 * (std::sin(column) + std::cos(row));
                          })};
  TerrainSpec spec = raster_terrain(raster.write("hills"));
  std::get<RasterSurface>(spec.layers[0]).unit = unit;
  return Ground(spec, site_on("Moon", 0, 0), 0).advice();
}

TEST(RasterUnit, of_heights_that_may_be_in_km_is_asked_for) {
  const auto asked = advice_of(6, "");
  ASSERT_EQ(asked.size(), 1u);
  EXPECT_EQ(asked[0].severity, Severity::warning);
  EXPECT_THAT(asked[0].what, HasSubstr("over 400 km and names no unit: are they km?"));
  EXPECT_THAT(asked[0].what, HasSubstr("say the unit (unit in lsos.raster, or --unit)"));
  EXPECT_EQ(advice_of(6, "<UnitType>m</UnitType>").size(), 0u);
  EXPECT_EQ(advice_of(6, "", "km").size(), 0u);
  // Metres as whole numbers, with a scale that makes km of them.
  EXPECT_EQ(advice_of(6000, "<Scale>0.001</Scale>").size(), 1u);
  EXPECT_EQ(advice_of(600, "").size(), 0u);
  EXPECT_EQ(advice_of(0, "").size(), 0u);  // level, made by hand
}

// 30 km of a salt flat on Earth.
std::size_t salt_flat_advices(double height, const std::string& type) {
  TextRaster raster{
      "EPSG:32719", "600000,1000,0,7800000,0,-1000", "",
      rows_of(30, 30, [&](int column, int row) { return height + ((column + row) % 2); })};
  raster.type = type;
  return Ground(raster_terrain(raster.write("flat")), site_on("Earth", -67.9, -20), 0)
      .advice()
      .size();
}

TEST(RasterUnit, is_not_asked_for_where_km_are_impossible) {
  EXPECT_EQ(salt_flat_advices(3655.4, "Float32"), 0u);
  EXPECT_EQ(salt_flat_advices(3.4, "Float32"), 1u);
  EXPECT_EQ(salt_flat_advices(3, "Int16"), 0u);
}

// 2 km of low hills about the datum.
std::size_t low_hills_advices(double rise, double step) {
  const auto height = [&](int column, int row) {
    const double exact = rise / 4 * (std::sin(0.2 * column) + std::cos(0.3 * row));
    return std::round(exact / step) * step;
  };
  const TextRaster raster{"+proj=eqc +R=1737400 +units=m", "-1000,20,0,1000,0,-20", "",
                          rows_of(100, 100, height)};
  return Ground(raster_terrain(raster.write("low")), site_on("Moon", 0, 0), 0).advice().size();
}

TEST(RasterUnit, is_asked_for_of_measured_ground_that_is_too_level) {
  EXPECT_EQ(low_hills_advices(0.1, 1e-5), 1u) << "100 m of relief in km";
  EXPECT_EQ(low_hills_advices(100, 1e-2), 0u);
  EXPECT_EQ(low_hills_advices(0.1, 1e-2), 0u) << "made by hand";
}

// 2 km of hills with one cell of another height, or with a rock of so many cells.
std::vector<Fault> spiked_advice(double spike_m, int cells, double cell_m = 10) {
  const auto height = [&](int column, int row) {
    const bool is_in = column >= 50 && column < 50 + cells && row >= 70 && row < 70 + cells;
    return std::round(20 * std::sin(0.2 * column) + 5 * std::cos(0.3 * row)) +
           (is_in ? spike_m : 0);
  };
  const std::string cell = std::to_string(cell_m);
  const TextRaster raster{"+proj=eqc +R=1737400 +units=m", "-1000," + cell + ",0,1000,0,-" + cell,
                          "", rows_of(200, 200, height)};
  return Ground(raster_terrain(raster.write("spiked")), site_on("Moon", 0, 0), 0).advice();
}

TEST(RasterSpike, is_told_with_its_place) {
  for (const double spike_m : {3000.0, -3000.0}) {
    const auto warnings = spiked_advice(spike_m, 1);
    ASSERT_EQ(warnings.size(), 1u);
    // The spike lies 495 m west of the datum and 295 m north of it: pixels' centres.
    EXPECT_THAT(warnings[0].what,
                HasSubstr("from one cell to the next and back at longitude -0.0163241"
                          ", latitude 0.00972848: a fault of the map?"));
  }
  const auto of_three_cells = spiked_advice(900, 3);
  ASSERT_EQ(of_three_cells.size(), 1u);
}

TEST(RasterSpike, is_neither_a_rock_nor_a_cliff) {
  EXPECT_EQ(spiked_advice(0, 1).size(), 0u);
  EXPECT_EQ(spiked_advice(30, 1).size(), 0u) << "a slope of 72 degrees";
  EXPECT_EQ(spiked_advice(8, 2, 0.5).size(), 0u) << "a boulder of 8 m in cells of 0.5 m";
  EXPECT_EQ(spiked_advice(900, 20).size(), 0u) << "a mesa";
}

std::vector<Fault> advice_of_heights(const std::string& band, double cell_m,
                                     const std::function<double(int, int)>& height) {
  const std::string cell = std::to_string(cell_m), half = std::to_string(cell_m * 50);
  const TextRaster raster{"+proj=eqc +R=1737400 +units=m",
                          "-" + half + "," + cell + ",0," + half + ",0,-" + cell, band,
                          rows_of(100, 100, height)};
  TerrainSpec spec = raster_terrain(raster.write("heights"));
  std::get<RasterSurface>(spec.layers[0]).is_band_given = true;
  return Ground(spec, site_on("Moon", 0, 0), 0).advice();
}

TEST(RasterExtremes, are_told_where_the_body_has_no_such_heights) {
  const auto relief = [](double size) {
    return [size](int column, int row) { return size * std::sin(1 + 0.1 * column + 0.05 * row); };
  };
  const auto warnings = advice_of_heights("", 5000, relief(18000));
  ASSERT_EQ(warnings.size(), 1u) << warnings[1].what;
  EXPECT_THAT(warnings[0].what,
              HasSubstr("heights of -18000 to 18000 m, where Moon has -9200 to 10800"));
  EXPECT_EQ(advice_of_heights("", 5000, relief(9500)).size(), 0u);
}

TEST(RasterSteps, of_whole_numbers_on_small_cells_are_told) {
  const auto hills = [](int column, int row) {
    return std::round(12 * std::sin(0.05 * column) + 8 * std::cos(0.03 * row));
  };
  const auto warnings = advice_of_heights("", 1, hills);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0].what, HasSubstr("in steps of 1 m on cells of 1 m"));
  EXPECT_EQ(advice_of_heights("", 30, hills).size(), 0u) << "a step of 2 degrees";
  EXPECT_EQ(advice_of_heights("<Scale>0.01</Scale>", 1, hills).size(), 0u);
  EXPECT_EQ(advice_of_heights("", 1, [](int column, int) { return column; }).size(), 0u)
      << "a ramp made by hand";
}

TEST(RasterWord, of_a_band_that_was_chosen_counts) {
  const auto slopes = [](int column, int row) { return 10 + 0.1 * column + 0.03 * row; };
  const auto warnings = advice_of_heights("<Description>map_slope</Description>", 10, slopes);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0].what, HasSubstr("band 1 is called 'map_slope'"));
  EXPECT_EQ(advice_of_heights("<Description>map_height</Description>", 10, slopes).size(), 0u);
}

TEST(CoarseGround, is_what_no_rover_can_be_said_to_drive_on) {
  const auto coarseness = [](double cell_m) {
    const std::string cell = std::to_string(cell_m), half = std::to_string(cell_m * 50);
    const TextRaster raster{"+proj=eqc +R=1737400 +units=m",
                            "-" + half + "," + cell + ",0," + half + ",0,-" + cell, "",
                            rows_of(100, 100, [](int column, int row) { return column * row; })};
    const TerrainSpec spec = raster_terrain(raster.write("coarse"));
    return Ground(spec, site_on("Moon", 0, 0), 0).coarseness(geodetic_from_degrees(0, 0));
  };
  EXPECT_EQ(coarseness(20), "");
  EXPECT_THAT(coarseness(118), HasSubstr("by cells of 118 m alone (raster '"));
  EXPECT_THAT(coarseness(7600), HasSubstr("by cells of 7.6 km alone"));
}

// Samples of 8 bits that are no picture name their unit or have a scale.
TEST(RasterKind, of_8_bits_without_a_unit_is_asked_for) {
  const auto advice = [](const std::string& band) {
    TextRaster raster{"+proj=eqc +R=1737400 +units=m", "-200,4,0,200,0,-4", band,
                      rows_of(100, 100, [](int column, int row) { return (column * row) % 200; })};
    raster.type = "Byte";
    return Ground(raster_terrain(raster.write("shade")), site_on("Moon", 0, 0), 0).advice();
  };
  ASSERT_EQ(advice("").size(), 1u);
  EXPECT_THAT(advice("")[0].what, HasSubstr("is it a hillshade, a map of slopes or a picture?"));
  EXPECT_EQ(advice("<UnitType>m</UnitType>").size(), 0u);
  EXPECT_EQ(advice("<Scale>0.1</Scale>").size(), 0u);
}

TEST(RasterBand, of_several_that_nobody_has_named_is_asked_for) {
  const TextRaster one{"+proj=eqc +R=1737400 +units=m", "-200,4,0,200,0,-4", "",
                       rows_of(100, 100, [](int column, int row) { return 0.1 * column + row; })};
  const std::string file = one.write("one"), two = file + ".two.vrt";
  ASSERT_EQ(std::system(
                ("gdalbuildvrt -q -separate '" + two + "' '" + file + "' '" + file + "'").c_str()),
            0);
  TerrainSpec spec = raster_terrain(two);
  const auto warnings = Ground(spec, site_on("Moon", 0, 0), 0).advice();
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0].what,
              HasSubstr("has 1 more band, and nothing says which are heights: band 1"));
  std::get<RasterSurface>(spec.layers[0]).is_band_given = true;
  EXPECT_EQ(Ground(spec, site_on("Moon", 0, 0), 0).advice().size(), 0u);
}

// A fine raster whose heights lie that much above those of a coarse one around it.
std::vector<Fault> step_advice_of(double step_m) {
  const auto hills = [](int column, int row) { return 2 * std::sin(column) + std::cos(row); };
  const TextRaster fine{"+proj=eqc +R=1737400 +units=m", "-200,4,0,200,0,-4", "",
                        rows_of(100, 100, [&](int c, int r) { return step_m + hills(c, r); })};
  const TextRaster coarse{"+proj=eqc +R=1737400 +units=m", "-2000,40,0,2000,0,-40", "",
                          rows_of(100, 100, hills)};
  TerrainSpec spec = raster_terrain(fine.write("fine"));
  spec.layers.push_back(RasterSurface{coarse.write("coarse")});
  return Ground(spec, site_on("Moon", 0, 0), 0).advice();
}

TEST(RasterStep, between_heights_of_two_references_is_told) {
  EXPECT_EQ(step_advice_of(0).size(), 0u);
  EXPECT_EQ(step_advice_of(2).size(), 0u);
  const auto warnings = step_advice_of(-500);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0].what, HasSubstr("m below '"));
  EXPECT_THAT(warnings[0].what, HasSubstr("are they heights above two references?"));
}

}  // namespace
}  // namespace lsos
