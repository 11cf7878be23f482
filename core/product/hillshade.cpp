#include "product/hillshade.h"

#include "terrain/raster/raster_export.h"

namespace lsos {

std::string write_hillshade(const std::string& file, const Ground& ground, const MapExtent& extent,
                            double cell_m) {
  const SiteFrame& site = ground.site();
  const MapGrid grid = grid_about(site.body(), site.origin(), extent.west_m, extent.south_m,
                                  extent.east_m, extent.north_m, cell_m);
  // Detail below the cells would make a shade of noise, and take minutes where they are large.
  Ground::Probe probe = Ground::Probe::with_sparse_detail(ground, cell_m);
  write_raster({file, true}, grid, site.body(), [&](const Geodetic& place) {
    const GroundSample sample = probe.sample(site.p_S_m({place.lon_rad, place.lat_rad, 0}));
    return sample.is_ground() ? sample.elevation_m : not_modelled;
  });
  return grid.crs;
}

std::string geographic_crs(const Ground& ground) { return geographic_wkt(ground.site().body()); }

}  // namespace lsos
