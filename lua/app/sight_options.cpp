#include "lua/app/sight_options.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/output_file.h"
#include "lua/app/place_options.h"

namespace lsos {

namespace {

// Greatest height above the ground, m. A higher observer may see ground that is too far away to be
// sampled around one site.
constexpr double highest_m = 100e3;

void check_height(const std::string& option, double height_m, Faults& faults) {
  if (height_m >= 0 && height_m <= highest_m) return;
  faults.error({}, fmt::format("{}: a height of 0..{:.0f} m above the ground is allowed", option,
                               highest_m));
}

std::optional<PlaceOption> read_place_option(const std::string& option, const std::string& text,
                                             Faults& faults) {
  const std::string asked = fmt::format("{} {}", option, text);
  if (std::ranges::count(text, ',') != 2) {
    faults.error({},
                 fmt::format("{}: LON,LAT,H is wanted: degrees, and m above the ground", asked));
    return {};
  }
  const auto place = option_site(option, text, faults);
  if (!place) return {};
  check_height(asked, place->height_m, faults);
  return PlaceOption{asked, *place};
}

// Adds faults unless either lines of sight or a map is requested.
void check_kind(const SightOptions& options, Faults& faults) {
  const bool is_map = !options.file.empty();
  const auto needs_map = [&](const char* option, bool is_given) {
    if (is_given && !is_map) {
      faults.error({}, fmt::format("{}: is for a map; -o OUT.tif is missing", option));
    }
  };
  needs_map("--height", options.height_m.has_value());
  needs_map("--flat", options.is_flat);
  needs_map("--window", !options.terrain.window.empty());
  needs_map("--resolution", options.terrain.resolution_m.has_value());
  if (is_map && !options.to.empty()) {
    faults.error({},
                 "--to: is for lines of sight, and -o for a map of what is seen: one of them is "
                 "allowed");
  }
  if (is_map && !options.height_m) {
    faults.error({}, "-o: --height H is missing: of what is looked for, m above the ground");
  }
  if (options.is_horizon && (is_map || !options.to.empty())) {
    faults.error({}, "--horizon: is neither for lines of sight nor for a map: one of them");
  }
  if (options.step_deg && !options.is_horizon) faults.error({}, "--step: is for a --horizon");
  if (options.step_deg && !(*options.step_deg >= 0.01 && *options.step_deg <= 90)) {
    faults.error({}, fmt::format("--step {}: 0.01..90 deg are allowed", *options.step_deg));
  }
  if (!is_map && !options.is_horizon && options.to.empty()) {
    faults.error({},
                 "sight: nothing is requested; give --to LON,LAT,H, --height H -o OUT.tif or "
                 "--horizon");
  }
}

}  // namespace

SightQuestion question_of(const SightOptions& options) {
  Faults faults;
  SightQuestion question;
  const TerrainOptions& terrain = options.terrain;
  question.from = read_place_option("--from", options.from, faults);
  for (const std::string& text : options.to) {
    if (const auto place = read_place_option("--to", text, faults)) question.to.push_back(*place);
  }
  check_kind(options, faults);
  question.target_m = options.height_m.value_or(0);
  check_height(fmt::format("--height {}", question.target_m), question.target_m, faults);
  if (!terrain.site.empty()) question.site = option_place("--site", terrain.site, faults);
  if (!terrain.window.empty()) question.window = option_window(terrain.window, faults);
  check_resolution(terrain, faults);
  check_output("-o", options.file, {".tif", ".tiff"}, {options.terrain.name}, faults);
  faults.throw_if_errors();
  return question;
}

}  // namespace lsos
