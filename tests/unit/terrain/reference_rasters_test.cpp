// Every raster of the reference data is read correctly, or refused with a reason.
#include <algorithm>
#include <cmath>
#include <map>

#include "ground_fixture.h"
#include "terrain/raster/raster_reader.h"

namespace lsos {
namespace {

using ::testing::HasSubstr;

// Values by gdalinfo and gdal_translate, in the meaning of the file.
struct Read {
  const char* body;
  double low_m, high_m;
  double valid_share;
};
struct Expected {
  std::string refusal;  // part of the message; "" where it is read
  Read read{};
};
Expected refused(const char* why) { return {why}; }
Expected heights(const char* body, double low_m, double high_m, double valid_share = 1) {
  return {"", {body, low_m, high_m, valid_share}};
}

const std::map<std::string, Expected>& expected() {
  static const std::map<std::string, Expected> files{
      {"earth/ames_roverscape_0p5m_UTM10.tif", heights("Earth", 2.743, 5.452, 0.8973)},
      {"formats/N10W110.hgt.zip", heights("Earth", 0, 9)},
      {"formats/gdal_dem10.img", heights("Earth", 0, 9)},
      {"formats/gdal_isis2/arvidson_original_truncated.cub", refused("has 43 x 1 cells; at least")},
      {"formats/gdal_n43.dt0", heights("Earth", 75, 460)},
      {"formats/gdal_pds4/byte_pds4_cart_1700.img", refused("its label '")},
      // 74 is missing, 255 saturated.
      {"formats/gdal_pds4/byte_pds4_cart_1700.xml", heights("Earth", 90, 247, 398 / 400.0)},
      {"formats/gdal_pds4/byte_pds4_cart_1700_multi_sds.xml", heights("Earth", 99, 206)},
      {"formats/gdal_pds4/byte_pds4_cart_1b00.img", refused("byte_pds4_cart_1b00.xml'?")},
      {"formats/gdal_pds4/byte_pds4_cart_1b00.xml", heights("Earth", 74, 255)},
      {"formats/gdal_pds4/byte_pds4_cart_1d00_1933.img", refused("its label '")},
      {"formats/gdal_pds4/byte_pds4_cart_1d00_1933.xml", heights("Earth", 74, 255)},
      {"formats/gdal_pds4/byte_pds4_cart_1g00_1950.img", refused("its label '")},
      {"formats/gdal_pds4/byte_pds4_cart_1g00_1950.xml", heights("Earth", 74, 255)},
      {"formats/gdal_pds4/missing_constant_hexadecimal_double.xml", refused("cannot be read: ")},
      {"formats/gdal_pds4/missing_constant_hexadecimal_float.xml",
       refused("Failed to read scanline 5")},
      {"formats/gdal_pds4/oblique_cylindrical.IMG", refused("oblique_cylindrical.xml'?")},
      {"formats/gdal_pds4/oblique_cylindrical.xml", refused("has 1 x 1 cells; at least 2 x 2")},
      {"formats/gdal_pds4/template_with_sp.xml", refused("cannot be opened: ")},
      {"formats/gdal_usgsdem/022gdeme_truncated", refused("has 1 x 1201 cells")},
      {"formats/gdal_usgsdem/114p01_0100_deme_truncated.dem", refused("has 1 x 1201 cells")},
      {"formats/gdal_usgsdem/39079G6_truncated.dem", heights("Earth", 325, 385, 0.2394)},
      {"formats/gdal_usgsdem/39109h1_truncated.dem", heights("Earth", 1687.401, 1716.986, 0.02162)},
      {"formats/gdal_usgsdem/4619old_truncated.dem",
       refused("holds samples from -32000 to 120, heights of -32000 to 120 m; no ground of Earth")},
      {"formats/gdal_usgsdem/fema06-140cm_2995441b_truncated.dem", refused("cannot be read: ")},
      {"formats/gdal_usgsdem/record_1025_ending_with_linefeed.dem",
       heights("Earth", 90, 206, 0.6667)},
      {"formats/gdal_usgsdem/usgsdem_with_extra_values_at_end_of_profile.dem",
       heights("Earth", -1, 36, 0.2821)},
      {"formats/gdal_usgsdem/usgsdem_with_spaces_after_byte_864.dem", refused("has 1 x 468 cells")},
      {"formats/gz_dem_nodata.dem", heights("Earth", 682, 2932, 0.9773)},
      // -32768 in 32-bit floating point, without a tag.
      {"formats/gz_dem_unfinished.tif", heights("Earth", -10, 1909, 807 / 1089.0)},
      {"formats/rasterio_float_nan.tif", refused("has no coordinate reference system")},
      {"mars/Phobos_ME_HRSC_DEM_Global_2ppd.tiff", heights("Phobos", -2940, 2917)},
      {"mars/gale_hirise_1m_missionDEM.tif", heights("Mars", -4472.670, -4437.883)},
      {"moon/LDEM_4.IMG", refused("its label '")},
      // The samples are radii, of 0.5 m a digit.
      {"moon/LDEM_4.LBL", heights("Moon", -8878.5, 10504)},
      {"moon/aristarchus_IMP_4p76m_height_slope_rock.tif", heights("Moon", -1393.268, -1297.310)},
      {"moon/coordflux_100pts_outline33_centerlast_R1_F1_stdlimbdark.txt",
       refused("cannot be opened: ")},
      {"moon/gz_dem_moon_87p5N.tif", heights("Moon", -212.296, -205.440)},
      {"moon/nobile_rim2_ldem_6_cut_1m.tif", heights("Moon", 1006.281, 1090.224)},
  };
  return files;
}

void expect_read(const std::string& file, const Read& expected) {
  const RasterReader reader({file}, {});
  EXPECT_EQ(reader.own_body().name, expected.body);
  const Raster& raster = reader.raster();
  const std::vector<double> heights_m = raster.heights_m({0, 0, raster.columns(), raster.rows()});
  double low_m = INFINITY, high_m = -INFINITY;
  int valid = 0;
  for (const double height_m : heights_m) {
    if (std::isnan(height_m)) continue;
    ++valid;
    low_m = std::min(low_m, height_m);
    high_m = std::max(high_m, height_m);
  }
  EXPECT_NEAR(low_m, expected.low_m, 6e-4);
  EXPECT_NEAR(high_m, expected.high_m, 6e-4);
  EXPECT_NEAR(valid, expected.valid_share * static_cast<double>(heights_m.size()),
              5e-5 * static_cast<double>(heights_m.size()) + 0.5);
}

// Ground at, and around, every sample lies within the range of the samples: no cliff of nodata.
void expect_no_cliff(const std::string& file, const Read& expected) {
  const RasterReader reader({file}, {});
  const Raster& raster = reader.raster();
  const Geodetic site = raster.map().place({raster.columns() / 2.0, raster.rows() / 2.0}).value();
  const Ground ground(raster_terrain(file), SiteFrame(reader.own_body(), site), 0);
  const double margin_m = 0.25 * (expected.high_m - expected.low_m) + 0.01;  // cubics overshoot
  int found = 0;
  for (int i = 0; i <= 30; ++i) {
    for (int j = 0; j <= 30; ++j) {
      const auto place = raster.map().place({i * raster.columns() / 30.0 - 0.3,  //
                                             j * raster.rows() / 30.0 - 0.3});
      if (!place) continue;
      const auto height_m = ground.elevation_m(*place);
      if (!height_m) continue;
      ++found;
      EXPECT_GE(*height_m, expected.low_m - margin_m);
      EXPECT_LE(*height_m, expected.high_m + margin_m);
    }
  }
  // Ground needs four neighbours; a file cut off after a few samples has none.
  EXPECT_TRUE(found > 0 || expected.valid_share < 0.1);
}

TEST(ReferenceRasters, are_read_right_or_refused_with_a_reason) {
  LSOS_NEEDS_REFERENCE("dem");
  for (const auto& [name, answer] : expected()) {
    SCOPED_TRACE(name);
    const std::string file = reference_file("dem/" + name);
    ASSERT_TRUE(std::filesystem::exists(file));
    try {
      expect_read(file, answer.read);
      EXPECT_EQ(answer.refusal, "");
      expect_no_cliff(file, answer.read);
    } catch (const InputError& error) {
      EXPECT_NE(answer.refusal, "") << error.what();
      EXPECT_THAT(error.what(), HasSubstr(answer.refusal));
      EXPECT_THAT(error.what(), HasSubstr("raster '" + file + "'"));
    }
  }
}

TEST(ReferenceRasters, are_all_of_the_folder) {
  namespace fs = std::filesystem;
  LSOS_NEEDS_REFERENCE("dem");
  const fs::path folder = reference_file("dem");
  std::vector<std::string> missing;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = fs::relative(entry.path(), folder);
    if (!entry.is_regular_file() || entry.path().extension() == ".csv") continue;
    if (!expected().contains(name)) missing.push_back(name);
  }
  EXPECT_THAT(missing, ::testing::IsEmpty());
}

TEST(ReferenceRasters, open_once_what_was_asked_for_is_said) {
  LSOS_NEEDS_REFERENCE("dem/formats/gdal_usgsdem/4619old_truncated.dem");
  const std::string file = reference_file("dem/formats/gdal_usgsdem/4619old_truncated.dem");
  RasterSurface surface{file};
  surface.nodata = -32000;
  const RasterReader reader(surface, {});
  const Raster& raster = reader.raster();
  for (const double height_m : raster.heights_m({0, 0, raster.columns(), raster.rows()})) {
    EXPECT_TRUE(std::isnan(height_m) || height_m >= 0) << height_m;
  }
}

}  // namespace
}  // namespace lsos
