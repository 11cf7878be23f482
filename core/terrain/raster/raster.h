// An open raster of heights: opened, its band chosen, its place on the body known, its samples
// understood; or refused with a reason. Serves one thread at a time, its map any.
#pragma once

#include <memory>
#include <string>

#include "terrain/raster/files_as_opened.h"
#include "terrain/raster/height_band.h"
#include "terrain/raster/raster_body.h"
#include "terrain/raster/raster_map.h"
#include "terrain/raster/raster_name.h"
#include "terrain/spec/raster_surface.h"

class GDALDataset;

namespace lsos {

class Raster {
 public:
  // Opens the raster on `body`, or on its own where that is null. Throws InputError at `place`.
  Raster(const RasterSurface& surface, const Place& place, const Body* body);
  ~Raster();

  // The raster's own body: one of all_bodies() or a sphere, with the name of the CRS.
  const Body& own_body() const { return own_body_.body; }
  const RasterMap& map() const { return *map_; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  bool goes_around() const { return map_->period_px() == columns_; }

  const HeightBand& band() const { return *band_; }
  const FilesAsOpened& files() const { return files_; }
  // Heights, m, or classes as they are, row by row; NaN where missing. On a level above 0 the
  // window counts 2^level columns and rows as one.
  std::vector<double> heights_m(const RasterBlock& window, int level = 0) const {
    return band_->heights_m(window, limit_m_, level);
  }

 private:
  RasterName name_;
  std::unique_ptr<GDALDataset> dataset_;
  FilesAsOpened files_;
  MapBody own_body_;
  int columns_;
  int rows_;
  double limit_m_;
  std::unique_ptr<RasterMap> map_;
  std::unique_ptr<HeightBand> band_;
};

}  // namespace lsos
