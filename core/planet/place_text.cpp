#include "planet/place_text.h"

#include <fmt/format.h>

#include <cmath>

#include "base/quantity.h"
#include "base/text.h"
#include "base/units.h"

namespace lsos {

namespace {

// In degrees. A number without a unit is taken as it stands: it must not change by going through
// radians, as places of coordinates do not.
std::optional<double> read_degrees(std::string_view text) {
  text = trimmed(text);
  const bool is_bare = text.find_last_of("0123456789.") + 1 == text.size();
  const Parsed<double> number = parse_quantity(text, *find_unit(is_bare ? "1" : "deg"));
  if (!number) return {};
  return is_bare ? *number.value : degrees(*number.value);
}

// The shortest text of a number of degrees that `is_same`.
template <class IsSame>
std::string shortest_degrees(double number_deg, const IsSame& is_same) {
  constexpr int digits_least = 6, digits_exact = 17;
  for (int digits = digits_least; digits <= digits_exact; ++digits) {
    const std::string text = fmt::format("{:.{}g}", number_deg, digits);
    if (is_same(text)) return text;
  }
  // The conversion from radians may have missed by a bit or two.
  double above = number_deg, below = number_deg;
  for (int i = 0; i < 4; ++i) {
    above = std::nextafter(above, 1000);
    below = std::nextafter(below, -1000);
    for (const double near : {above, below}) {
      for (int digits = digits_exact - 2; digits <= digits_exact; ++digits) {
        const std::string text = fmt::format("{:.{}g}", near, digits);
        if (is_same(text)) return text;
      }
    }
  }
  return fmt::format("{:.{}g}", number_deg, digits_exact);
}

}  // namespace

Parsed<Geodetic> parse_lon_lat(const std::string& text) {
  const std::size_t comma = text.find(',');
  const auto part = [&](std::size_t from, std::size_t count) {
    return comma == std::string::npos ? std::nullopt : read_degrees(text.substr(from, count));
  };
  const std::optional<double> lon_deg = part(0, comma), lat_deg = part(comma + 1, text.size());
  if (!lon_deg || !lat_deg) return {{}, "LON,LAT is wanted, in degrees, such as 31.5,20.25"};
  if (*lon_deg >= -180 && *lon_deg <= 360 && std::abs(*lat_deg) <= 90) {
    return {geodetic_from_degrees(*lon_deg, *lat_deg), ""};
  }
  const bool is_swapped = std::abs(*lon_deg) <= 90 && *lat_deg >= -180 && *lat_deg <= 360;
  return {{},
          fmt::format("a longitude of -180..360 and a latitude of -90..90 deg are allowed{}",
                      is_swapped ? "; longitude comes first" : "")};
}

std::string lon_lat_text(const Geodetic& place) {
  const auto read = [](const std::string& lon, const std::string& lat) {
    return parse_lon_lat(lon + "," + lat).value.value_or(Geodetic{});
  };
  return shortest_degrees(
             lon_deg(place),
             [&](const std::string& lon) { return read(lon, "0").lon_rad == place.lon_rad; }) +
         "," + shortest_degrees(lat_deg(place), [&](const std::string& lat) {
           return read("0", lat).lat_rad == place.lat_rad;
         });
}

}  // namespace lsos
