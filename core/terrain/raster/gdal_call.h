// Silent calls into GDAL, whose errors become text for this program's messages.
#pragma once

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal.h>
#include <ogr_spatialref.h>

#include <memory>
#include <string>

#include "access/refusal.h"

class GDALDataset;

namespace lsos {

struct CloseDataset {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;

// Scope in which GDAL prints nothing on this thread.
class GdalSilence {
 public:
  GdalSilence() {
    CPLErrorReset();
    forget_refusal();
    CPLPushErrorHandler(CPLQuietErrorHandler);
  }
  ~GdalSilence() { CPLPopErrorHandler(); }
  GdalSilence(const GdalSilence&) = delete;
  GdalSilence& operator=(const GdalSilence&) = delete;

  // Why a file was not allowed to be opened on this thread, else GDAL's last message, "" when there
  // is none.
  static std::string message() {
    return last_refusal().empty() ? CPLGetLastErrorMsg() : last_refusal();
  }
};

// Bounds GDAL's cache of raster blocks for the whole program; by default it takes a twentieth of
// the machine's memory. Called once, after GDAL's drivers are registered. A row of tiles of a
// raster 100,000 cells wide, stored as strips, is 29 MB. A user's own GDAL_CACHEMAX stays.
inline void bound_block_cache() {
  constexpr GIntBig budget_bytes = GIntBig{128} << 20;
  if (CPLGetConfigOption("GDAL_CACHEMAX", nullptr) == nullptr) GDALSetCacheMax64(budget_bytes);
}

inline std::string wkt_of(const OGRSpatialReference& crs) {
  char* wkt = nullptr;
  const char* const options[] = {"FORMAT=WKT2_2019", nullptr};
  crs.exportToWkt(&wkt, options);
  std::string text = wkt != nullptr ? wkt : "";
  CPLFree(wkt);
  return text;
}

}  // namespace lsos
