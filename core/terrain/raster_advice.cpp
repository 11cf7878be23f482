#include "terrain/raster_advice.h"

#include <fmt/format.h>
#include <gdal_priv.h>

#include "terrain/gdal_call.h"

namespace lsos {

namespace {

// Four bytes each: 400 MB to go through for a look at all of it.
constexpr double most_cells_without_overviews = 1e8;

}  // namespace

std::string raster_advice(GDALRasterBand& band, const std::string& file) {
  const GdalSilence silence;
  const double cells = static_cast<double>(band.GetXSize()) * band.GetYSize();
  if (cells <= most_cells_without_overviews || band.GetOverviewCount() > 0) return {};
  return fmt::format(
      "raster '{}' has {} x {} cells and no overviews, so that a look from afar reads all of it; "
      "make them once with: gdaladdo -r average {} 2 4 8 16",
      file, band.GetXSize(), band.GetYSize(), file);
}

}  // namespace lsos
