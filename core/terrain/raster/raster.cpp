#include "terrain/raster/raster.h"

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <cmath>
#include <limits>

#include "terrain/raster/raster_open.h"

namespace lsos {

Raster::Raster(const RasterSurface& surface, const Place& place, const Body* body)
    : name_{place, surface.file},
      dataset_(open_raster(surface, name_)),
      files_(*dataset_),
      own_body_(body_of(crs_of(*dataset_, surface, name_), name_)),
      columns_(dataset_->GetRasterXSize()),
      rows_(dataset_->GetRasterYSize()) {
  GDALRasterBand& band = chosen_band(*dataset_, surface, name_);
  const OGRSpatialReference crs = crs_of(*dataset_, surface, name_);
  if (body != nullptr) check_body(crs, *body, name_);
  const Body& on = body != nullptr ? *body : own_body_.body;
  map_ = std::make_unique<RasterMap>(crs, geotransform_of(*dataset_, name_), columns_, on, name_);
  // Columns that repeat the first ones, as on a globe from -180 to 180 on grid lines, are left out.
  const double period = map_->period_px();
  if (period > 0 && period < columns_ && period == std::floor(period)) {
    columns_ = static_cast<int>(period);
  }
  limit_m_ = surface.has_classes ? std::numeric_limits<double>::infinity() : ground_limit_m(on);
  band_ = std::make_unique<HeightBand>(interpret_band(band, surface, on, name_));
}

Raster::~Raster() = default;

}  // namespace lsos
