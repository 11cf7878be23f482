// `lsos-host sun`: positions of Sun and Earth in the sky of a place, and the light there, so that
// an engineer can check them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/parsed.h"
#include "base/rounding.h"
#include "base/units.h"
#include "lua/app/commands.h"
#include "lua/app/common_options.h"
#include "lua/app/instrument_answer.h"
#include "lua/app/place_options.h"
#include "planet/sky.h"
#include "planet/sunlight.h"

namespace lsos {

namespace {

struct SunOptions {
  std::string planet;
  std::string site;             // "LON,LAT[,HEIGHT]"
  std::vector<std::string> at;  // UTC
  std::optional<double> optical_depth, albedo;
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

struct AirAndGround {
  double optical_depth = 0, albedo = 0;
};

// The light under a free sky over level ground. Direct light is across the Sun's rays, the rest on
// level ground; what the ground reflects is on a surface that sees nothing else.
void add_light(AnswerRow& row, const Body& body, const Geodetic& site, Instant at,
               const AirAndGround& around) {
  const Sunlight light = sunlight(body, site, at, around.optical_depth, around.albedo);
  const bool is_up = light.seen.elevation_rad + light.disc_rad > 0;
  const double direct_wpm2 = is_up ? light.irradiance_wpm2 * (1 - light.eclipsed) : 0;
  const double all_wpm2 = is_up ? level_wpm2(light) : 0;
  const double sine = std::max(0.0, std::sin(light.seen.elevation_rad));
  constexpr int milliwatts = 3;  // decimals
  row["direct_wpm2"] = with_decimals(direct_wpm2, milliwatts);
  row["diffuse_wpm2"] = with_decimals(std::max(0.0, all_wpm2 - sine * direct_wpm2), milliwatts);
  row["level_wpm2"] = with_decimals(all_wpm2, milliwatts);
  row["reflected_wpm2"] = with_decimals(light.ground_wpm2, milliwatts);
  row["optical_depth"] =
      body.air == Air::clear ? AnswerRow(nullptr) : AnswerRow(around.optical_depth);
  row["albedo"] = around.albedo;
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
  if (options.optical_depth && !(*options.optical_depth >= 0)) {
    faults.error({}, fmt::format("--optical-depth {}: must be at least 0", *options.optical_depth));
  }
  if (options.albedo && !(*options.albedo >= 0 && *options.albedo <= 1)) {
    faults.error({}, fmt::format("--albedo {}: must be 0..1", *options.albedo));
  }
  if (options.optical_depth && body != nullptr && body->air == Air::clear) {
    faults.error({}, "--optical-depth: the air of Earth is taken to be clear");
  }
  faults.throw_if_errors();
  const AirAndGround around{options.optical_depth.value_or(body->assumed_optical_depth),
                            options.albedo.value_or(body->assumed_albedo)};
  AnswerRow rows = AnswerRow::array();
  for (const Instant at : moments) {
    rows.push_back(row(*body, *site, at));
    add_light(rows.back(), *body, *site, at, around);
  }
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
  command.add_option("--optical-depth", options->optical_depth,
                     "Of dust, straight up (0.5 on Mars, 0 on the Moon)");
  command.add_option("--albedo", options->albedo,
                     "Share of light that the ground reflects (Mars 0.25, Earth 0.2, Moon 0)");
  add_style(command, options->style);
  return [options] { return sun_command(*options); };
}

}  // namespace lsos
