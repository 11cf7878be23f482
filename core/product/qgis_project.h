// mission.qgz: a project that opens a run in QGIS, over a hillshade of its ground.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "planet/body.h"
#include "planet/utc.h"

namespace lsos {

struct QgisMap {
  std::string title;
  std::vector<std::string> rovers;  // in byte order of ids
  const Body* body = nullptr;
  std::string log_crs_wkt;  // of log.gpkg
  std::string map_crs_wkt;  // of the hillshade, in m; the project's own
  // Extent shown first, in the map's CRS, m.
  double west_m = 0, south_m = 0, east_m = 0, north_m = 0;
  std::set<std::string> has_drawn;  // rovers with lines drawn in the plan, in overlay.kml beside it
  bool has_hillshade = false;       // as hillshade.tif beside it
  // Range of the time slider.
  Instant start, end;
};

// The bytes of a .qgz file; the same each time.
std::string qgis_project(const QgisMap& map);

}  // namespace lsos
