// `lsos-host sun`: positions of Sun and Earth in the sky of a place, so that an engineer can check
// them.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/parsed.h"
#include "base/rounding.h"
#include "base/units.h"
#include "lua/app/commands.h"
#include "lua/app/common_options.h"
#include "lua/app/instrument_answer.h"
#include "lua/app/place_options.h"
#include "planet/sky.h"

namespace lsos {

namespace {

struct SunOptions {
  std::string planet;
  std::string site;             // "LON,LAT[,HEIGHT]"
  std::vector<std::string> at;  // UTC
  AnswerStyle style = AnswerStyle::by_output;
};

Instant moment(const std::string& text, Faults& faults) {
  const Parsed<Instant> at = parse_utc(text);
  if (!at) faults.error({}, fmt::format("--at {}: {}", text, at.why));
  return at.value.value_or(Instant{});
}

AnswerRow angle_or_null(const std::optional<double>& angle_rad) {
  return angle_rad ? AnswerRow(computed(degrees(*angle_rad))) : AnswerRow(nullptr);
}

AnswerRow number_or_null(const std::optional<double>& value, int decimals) {
  return value ? AnswerRow(with_decimals(*value, decimals)) : AnswerRow(nullptr);
}

AnswerRow row(const Body& body, const Geodetic& site, Instant at) {
  const Sky seen = sky(body, site, at);
  const auto of_earth = [&](double SkyPosition::*angle) {
    return seen.earth ? std::optional((*seen.earth).*angle) : std::nullopt;
  };
  constexpr int millimetres = 3, shares = 9;  // decimals
  return {{"utc", format_utc(at)},
          {"body", body.name},
          {"lon_deg", entered_deg(lon_deg(site))},
          {"lat_deg", entered_deg(lat_deg(site))},
          {"azimuth_deg", computed(degrees(seen.sun.azimuth_rad))},
          {"elevation_deg", computed(degrees(seen.sun.elevation_rad))},
          {"elevation_refracted_deg", angle_or_null(seen.sun_refracted_rad)},
          {"angular_diameter_deg", computed(degrees(2 * seen.sun_disc_rad))},
          {"distance_m", with_decimals(seen.sun_distance_m, millimetres)},
          {"sub_solar_lon_deg", computed(lon_deg(seen.sub_solar))},
          {"sub_solar_lat_deg", computed(lat_deg(seen.sub_solar))},
          {"eclipsed", number_or_null(seen.eclipsed, shares)},
          {"earth_azimuth_deg", angle_or_null(of_earth(&SkyPosition::azimuth_rad))},
          {"earth_elevation_deg", angle_or_null(of_earth(&SkyPosition::elevation_rad))},
          {"earth_distance_m", number_or_null(seen.earth_distance_m, millimetres)}};
}

int sun_command(const SunOptions& options) {
  Faults faults;
  const Body* body = option_body("--planet", options.planet, faults);
  const auto site = option_site("--site", options.site, faults);
  // Greatest height of a site, m. Nothing stands so high; a larger number is usually the body's
  // radius.
  constexpr double highest_m = 100e3;
  if (site && std::abs(site->height_m) > highest_m) {
    faults.error({}, fmt::format("--site {}: the height after LON,LAT is above the reference "
                                 "surface, and {:g} m at most",
                                 options.site, highest_m));
  }
  std::vector<Instant> moments;
  for (const std::string& text : options.at) moments.push_back(moment(text, faults));
  faults.throw_if_errors();
  AnswerRow rows = AnswerRow::array();
  for (const Instant at : moments) rows.push_back(row(*body, *site, at));
  print_answer(rows, options.style);
  return 0;
}

}  // namespace

std::function<int()> prepare_sun(CommandOptions& command) {
  const auto options = std::make_shared<SunOptions>();
  command.add_option("--planet", options->planet, "Moon, Mars or Earth").required();
  command.add_option("--site", options->site, "LON,LAT[,HEIGHT] in degrees and m").required();
  command.add_option("--at", options->at, "UTC, one or several: 2026-07-01T00:00:00Z,...")
      .required()
      .separated_by(',');
  add_style(command, options->style);
  return [options] { return sun_command(*options); };
}

}  // namespace lsos
