// Shared by the terrain tests: sites, rasters written as text, and a normal found by differences.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <unistd.h>

#include "support/reference_data.h"
#include "terrain/ground.h"

namespace lsos {

inline SiteFrame site_on(std::string_view body, double lon_deg, double lat_deg,
                         double height_m = 0) {
  return {*find_body(body), geodetic_from_degrees(lon_deg, lat_deg, height_m)};
}

inline TerrainSpec plane_terrain(double height_m, double slope_rad = 0, double azimuth_rad = 0) {
  TerrainSpec spec;
  spec.layers = {PlaneSurface{height_m, slope_rad, azimuth_rad}};
  return spec;
}

inline TerrainSpec raster_terrain(const std::string& file, int band = 1) {
  TerrainSpec spec;
  spec.place = {"terrain/x.lua", 3};
  spec.layers = {RasterSurface{file, band}};
  return spec;
}

// A raster as an ESRI ASCII grid with a GDAL virtual raster on top, which gives it any CRS,
// geotransform and band description. Rows are written from the top. write() returns the VRT's path.
struct TextRaster {
  std::string crs;           // anything that GDAL reads; "" for none
  std::string geotransform;  // six numbers with commas; "" for none
  std::string band;          // XML inside the band: NoDataValue, Scale, Offset, UnitType
  std::vector<std::vector<double>> rows;
  std::string type = "Float64";  // type of the samples

  std::string write(const std::string& name) const {
    const std::string folder = ::testing::TempDir() + "lsos_terrain_" + std::to_string(::getpid()) +
                               "_" +
                               ::testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::create_directories(folder);
    std::ofstream grid(folder + "/" + name + ".asc");
    grid.precision(17);
    grid << "ncols " << rows[0].size() << "\nnrows " << rows.size()
         << "\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
    for (const auto& row : rows) {
      for (double value : row) grid << value << ' ';
      grid << '\n';
    }
    std::ofstream vrt(folder + "/" + name + ".vrt");
    vrt << "<VRTDataset rasterXSize='" << rows[0].size() << "' rasterYSize='" << rows.size()
        << "'>";
    if (!crs.empty()) vrt << "<SRS>" << crs << "</SRS>";
    if (!geotransform.empty()) vrt << "<GeoTransform>" << geotransform << "</GeoTransform>";
    vrt << "<VRTRasterBand dataType='" << type << "' band='1'>" << band
        << "<SimpleSource><OpenOptions><OOI key='DATATYPE'>Float64</OOI></OpenOptions>"
        << "<SourceFilename relativeToVRT='1'>" << name << ".asc</SourceFilename>"
        << "<SourceBand>1</SourceBand></SimpleSource></VRTRasterBand></VRTDataset>";
    return folder + "/" + name + ".vrt";
  }
};

// Rows of heights f(column, row).
template <class F>
std::vector<std::vector<double>> rows_of(int columns, int rows, const F& f) {
  std::vector<std::vector<double>> result(rows, std::vector<double>(columns));
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) result[row][column] = f(column, row);
  }
  return result;
}

// Gradient of the gap in space by central differences: the normal of the implicit surface.
inline Vec3 normal_by_differences(Ground::Probe& probe, const Vec3& p_S_m, double step_m) {
  Vec3 gradient;
  for (int i = 0; i < 3; ++i) {
    const Vec3 step = step_m * Vec3::Unit(i);
    gradient[i] = probe.sample(p_S_m + step).gap_m - probe.sample(p_S_m - step).gap_m;
  }
  return gradient.normalized();
}

// Point of the surface below p.
inline Vec3 on_surface(const Ground& ground, Ground::Probe& probe, const Vec3& p_S_m) {
  return p_S_m - probe.sample(p_S_m).gap_m * ground.site().up_S(p_S_m);
}

}  // namespace lsos
