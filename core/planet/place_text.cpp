#include "planet/place_text.h"

#include <fmt/format.h>

#include <cmath>

#include "base/quantity.h"
#include "base/units.h"

namespace lsos {

Parsed<Geodetic> parse_lon_lat(const std::string& text) {
  const std::size_t comma = text.find(',');
  const auto number = [&](std::size_t from, std::size_t count) {
    return comma == std::string::npos ? Parsed<double>{}
                                      : parse_quantity(text.substr(from, count), *find_unit("deg"));
  };
  const Parsed<double> lon_rad = number(0, comma), lat_rad = number(comma + 1, std::string::npos);
  if (!lon_rad || !lat_rad) return {{}, "LON,LAT is wanted, in degrees"};
  const double lon_deg = degrees(*lon_rad.value), lat_deg = degrees(*lat_rad.value);
  if (lon_deg >= -180 && lon_deg <= 360 && std::abs(lat_deg) <= 90) {
    return {geodetic_from_degrees(lon_deg, lat_deg), ""};
  }
  const bool is_swapped = std::abs(lon_deg) <= 90 && lat_deg >= -180 && lat_deg <= 360;
  return {{},
          fmt::format("a longitude of -180..360 and a latitude of -90..90 deg are allowed{}",
                      is_swapped ? "; longitude comes first" : "")};
}

std::string lon_lat_text(const Geodetic& place) {
  return fmt::format("{:.12g},{:.12g}", lon_deg(place), lat_deg(place));
}

}  // namespace lsos
