#include "mission/light/sky_view.h"

namespace lsos {

SkyView sky_view(const Body& body, const Geodetic& place, Instant utc) {
  const SkyPosition sun = sunlight(body, place, utc, 0).seen;
  const std::optional<SkyPosition> earth = sky(body, place, utc).earth;
  SkyView view{sun.azimuth_rad, sun.elevation_rad, not_modelled, not_modelled};
  if (earth) {
    view.earth_azimuth_rad = earth->azimuth_rad;
    view.earth_elevation_rad = earth->elevation_rad;
  }
  return view;
}

}  // namespace lsos
