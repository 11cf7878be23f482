// `lsos-host sun`: Sun and Earth in the sky of a place, for an engineer who wants to check them.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/units.h"
#include "lua/commands.h"
#include "lua/console.h"
#include "lua/places.h"
#include "planet/sky.h"

namespace lsos {

namespace {

using nlohmann::ordered_json;

Instant moment(const std::string& text, Faults& faults) {
  const Parsed<Instant> at = parse_utc(text);
  if (!at) faults.error({}, fmt::format("--at {}: {}", text, at.why));
  return at.value.value_or(Instant{});
}

ordered_json angle_or_null(const std::optional<double>& angle_rad) {
  return angle_rad ? ordered_json(degrees(*angle_rad)) : ordered_json(nullptr);
}

template <class T>
ordered_json or_null(const std::optional<T>& value) {
  return value ? ordered_json(*value) : ordered_json(nullptr);
}

ordered_json row(const Body& body, const Geodetic& site, Instant at) {
  const Sky seen = sky(body, site, at);
  const auto of_earth = [&](double SkyPosition::*angle) {
    return seen.earth ? std::optional((*seen.earth).*angle) : std::nullopt;
  };
  return {{"utc", format_utc(at)},
          {"body", body.name},
          {"lon_deg", lon_deg(site)},
          {"lat_deg", lat_deg(site)},
          {"azimuth_deg", degrees(seen.sun.azimuth_rad)},
          {"elevation_deg", degrees(seen.sun.elevation_rad)},
          {"elevation_refracted_deg", angle_or_null(seen.sun_refracted_rad)},
          {"angular_diameter_deg", degrees(2 * seen.sun_disc_rad)},
          {"distance_m", seen.sun_distance_m},
          {"sub_solar_lon_deg", lon_deg(seen.sub_solar)},
          {"sub_solar_lat_deg", lat_deg(seen.sub_solar)},
          {"eclipsed", or_null(seen.eclipsed)},
          {"earth_azimuth_deg", angle_or_null(of_earth(&SkyPosition::azimuth_rad))},
          {"earth_elevation_deg", angle_or_null(of_earth(&SkyPosition::elevation_rad))},
          {"earth_distance_m", or_null(seen.earth_distance_m)}};
}

}  // namespace

int sun_command(const SunOptions& options) {
  Faults faults;
  const Body* body = option_body("--planet", options.planet, faults);
  const auto site = option_site("--site", options.site, faults);
  std::vector<Instant> moments;
  for (const std::string& text : options.at) moments.push_back(moment(text, faults));
  faults.throw_if_errors();
  auto rows = ordered_json::array();
  for (const Instant at : moments) rows.push_back(row(*body, *site, at));
  print_result("{}\n", rows.dump(2));
  return 0;
}

}  // namespace lsos
