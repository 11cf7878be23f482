#include "lua/app/place_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/quantity.h"
#include "planet/place_text.h"

namespace lsos {

std::optional<std::vector<double>> option_numbers(const std::string& option,
                                                  const std::string& text, std::size_t count,
                                                  const std::string& form, Faults& faults) {
  std::vector<double> numbers;
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const auto number = parse_quantity(text.substr(begin, end - begin), *find_unit("deg"));
    if (!number) break;
    numbers.push_back(degrees(*number.value));
    begin = end + 1;
  }
  if (begin <= text.size() || numbers.size() != count) {
    faults.error({}, fmt::format("{} {}: {} is wanted, in degrees", option, text, form));
    return {};
  }
  return numbers;
}

std::vector<std::string> option_parts(const std::string& text) {
  std::vector<std::string> parts{""};
  for (const char c : text) {
    if (c == ',') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

std::optional<Geodetic> option_place(const std::string& option, const std::string& text,
                                     Faults& faults) {
  const Parsed<Geodetic> place = parse_lon_lat(text);
  if (!place) faults.error({}, fmt::format("{} {}: {}", option, text, place.why));
  return place.value;
}

std::optional<Geodetic> option_site(const std::string& option, const std::string& text,
                                    Faults& faults) {
  if (std::ranges::count(text, ',') < 2) return option_place(option, text, faults);
  const std::size_t last = text.rfind(',');
  auto site = option_place(option, text.substr(0, last), faults);
  const auto height = parse_quantity(text.substr(last + 1), *find_unit("m"));
  if (!height) {
    faults.error({}, fmt::format("{} {}: the height after LON,LAT: {}", option, text, height.why));
    return {};
  }
  if (site) site->height_m = *height.value;
  return site;
}

std::optional<MapWindow> option_window(const std::string& text, Faults& faults) {
  const auto n =
      option_numbers("--window", text, 4, "LON0,LAT0,LON1,LAT1 (west, south, east, north)", faults);
  if (!n) return {};
  const MapWindow window{(*n)[0], (*n)[1], (*n)[2], (*n)[3]};
  const auto is_lon = [](double lon_deg) { return lon_deg >= -180 && lon_deg <= 360; };
  const bool is_ordered = std::abs(window.south_deg) <= 90 && std::abs(window.north_deg) <= 90 &&
                          window.south_deg < window.north_deg;
  if (is_lon(window.west_deg) && is_lon(window.east_deg) && is_ordered && window.width_deg() > 0 &&
      window.width_deg() <= 360) {
    return window;
  }
  faults.error({}, fmt::format("--window {}: west, south, east, north: longitudes of -180..360, "
                               "at most 360 apart, and latitudes of -90..90 deg, the southern "
                               "first, are allowed",
                               text));
  return {};
}

const Body* option_body(const std::string& option, const std::string& name, Faults& faults) {
  if (const Body* body = find_body(name)) return body;
  std::vector<std::string> names;
  for (const Body& body : all_bodies()) names.emplace_back(body.name);
  faults.error({}, fmt::format("{} {}: {} are allowed{}", option, name, fmt::join(names, ", "),
                               did_you_mean(name, names)));
  return nullptr;
}

}  // namespace lsos
