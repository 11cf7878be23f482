#include "product/qgis_run.h"

#include <algorithm>
#include <filesystem>

#include "base/files.h"
#include "product/hillshade.h"
#include "product/qgis_project.h"
#include "product/report_data.h"
#include "record/log.h"

namespace lsos {

namespace {

constexpr double extent_margin_share = 0.25, extent_margin_least_m = 40;
constexpr int hillshade_px = 1000;      // along the longer side
constexpr double finest_cell_m = 0.25;  // smaller cells show no more

void widen(MapExtent& extent, double x_m, double y_m) {
  extent.west_m = std::min(extent.west_m, x_m);
  extent.east_m = std::max(extent.east_m, x_m);
  extent.south_m = std::min(extent.south_m, y_m);
  extent.north_m = std::max(extent.north_m, y_m);
}

double longer_m(const MapExtent& extent) {
  return std::max(extent.east_m - extent.west_m, extent.north_m - extent.south_m);
}

// Extent of all that was drawn, planned and driven, and the site's origin, with a margin.
MapExtent extent_of(const ReportData& data) {
  MapExtent extent;
  for (const ReportRover& rover : data.rovers) {
    for (std::size_t k = 0; k < rover.position.size(); ++k) {
      widen(extent, rover.position.column(position_x)[k], rover.position.column(position_y)[k]);
    }
    for (const auto* lines : {&rover.drawn, &rover.planned}) {
      for (const ReportLine& line : *lines) {
        for (const ReportPoint& point : line) widen(extent, point.x_m, point.y_m);
      }
    }
  }
  const double margin_m = std::max(extent_margin_least_m, extent_margin_share * longer_m(extent));
  return {extent.west_m - margin_m, extent.south_m - margin_m, extent.east_m + margin_m,
          extent.north_m + margin_m};
}

}  // namespace

void write_qgis_project(const std::string& run_dir, const MissionModel& files,
                        const Ground& ground) {
  const LogReader log(run_dir + "/log.gpkg");
  const SiteFrame& site = ground.site();
  const ReportData data = read_report_data(log, files.plan, site);
  const MapExtent extent = extent_of(data);
  const double cell_m = std::max(finest_cell_m, longer_m(extent) / hillshade_px);
  QgisMap map;
  map.title = std::filesystem::path(files.plan.file).stem().string();
  for (const PlanRover& rover : files.plan.rovers) map.rovers.push_back(rover.id);
  map.body = &site.body();
  map.log_crs_wkt = geographic_crs(ground);
  map.map_crs_wkt = write_hillshade(run_dir + "/hillshade.tif", ground, extent, cell_m);
  map.west_m = extent.west_m;
  map.south_m = extent.south_m;
  map.east_m = extent.east_m;
  map.north_m = extent.north_m;
  map.has_hillshade = true;
  for (const ReportRover& rover : data.rovers) {
    if (!rover.drawn.empty()) map.has_drawn.insert(rover.id);
  }
  map.start = log.start();
  map.end = log.start() + log.last_sample_time();
  write_file(run_dir + "/mission.qgz", qgis_project(map));
}

}  // namespace lsos
