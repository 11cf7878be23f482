// `lsos-host light`: a map of how much of the Sun the ground sees, and how steeply.
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/console.h"
#include "base/output_file.h"
#include "base/parsed.h"
#include "base/rounded_distance.h"
#include "base/rounding.h"
#include "base/units.h"
#include "base/worker_pool.h"
#include "lua/app/commands.h"
#include "lua/app/common_options.h"
#include "lua/app/instrument_answer.h"
#include "lua/app/place_options.h"
#include "lua/app/terrain_source.h"
#include "planet/sunlight.h"
#include "terrain/raster/raster_export.h"
#include "view/exposure/ground_light.h"

namespace lsos {

namespace {

struct LightOptions {
  TerrainOptions terrain;  // of these name, raster, planet, site, seed, window, resolution
  std::string at;          // UTC
  std::string file;        // OUT.tif
  int threads = 1;
};

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

struct Question {
  Instant at;
  std::optional<Geodetic> site;
  std::optional<MapWindow> window;
};

// Statistics of places that are lit across the end of the ground, where unknown ground may hide the
// Sun.
class LightOverEnd {
 public:
  // To be called for each lit place, with the Sun's elevation there.
  void add(const std::optional<GroundEnd>& end, double sun_rad) {
    ++lit_;
    if (!end) return;
    ++over_;
    reaches_m_ += end->reaches_m;
    if (end->matters_m <= matters_m_) return;
    matters_m_ = end->matters_m;
    sun_rad_ = sun_rad;
  }
  bool is_any() const { return over_ > 0; }
  double mean_m() const { return reaches_m_ / over_; }
  std::string warning() const {
    return fmt::format(
        "the ground ends before the horizon that counts: {} away on average, while "
        "ground up to {} away may hide a Sun {:.1f} deg high; {:.0f} % of what is "
        "lit is lit over that end; --beyond lays a coarser terrain around it",
        rounded_distance(mean_m()), rounded_distance(matters_m_), degrees(sun_rad_),
        std::max(1.0, std::floor(100 * over_ / lit_)));
  }

 private:
  double lit_ = 0, over_ = 0;  // numbers of places
  double reaches_m_ = 0;       // summed over the places counted in over_
  double matters_m_ = 0;       // largest of these places
  double sun_rad_ = 0;         // elevation of the Sun at that place
};

Question question_of(const LightOptions& options) {
  Faults faults;
  Question question;
  const TerrainOptions& terrain = options.terrain;
  const Parsed<Instant> at = parse_utc(options.at);
  if (!at) faults.error({}, fmt::format("--at {}: {}", options.at, at.why));
  question.at = at.value.value_or(Instant{});
  if (!terrain.site.empty()) question.site = option_place("--site", terrain.site, faults);
  if (!terrain.window.empty()) question.window = option_window(terrain.window, faults);
  check_resolution(terrain, faults);
  check_output("-o", options.file, {".tif", ".tiff"}, {options.terrain.name}, faults);
  faults.throw_if_errors();
  return question;
}

// Throws InputError where the map extends beyond the reach of its site, as no light can be computed
// there.
void check_reach(const MapGrid& grid, const Ground& ground) {
  const SiteFrame& site = ground.site();
  const RasterMap map = grid.map(site.body());
  constexpr int parts = 64;
  double farthest_m = 0;
  for (int j = 0; j <= parts; ++j) {
    for (int i = 0; i <= parts; ++i) {
      const auto place =
          map.place({(grid.columns - 1.0) * i / parts, (grid.rows - 1.0) * j / parts});
      if (!place || ground.reaches(site.p_S_m(*place))) continue;
      farthest_m = std::max(farthest_m, surface_distance_m(site.body(), site.origin(), *place));
    }
  }
  if (farthest_m == 0) return;
  throw InputError(
      {}, fmt::format("light: the map reaches {:.0f} degrees from its site {:.4f},{:.4f}; up to 60 "
                      "are allowed: give a smaller --window, or a --site in its middle",
                      degrees(farthest_m / site.body().equatorial_radius_m), lon_deg(site.origin()),
                      lat_deg(site.origin())));
}

int light_command(const LightOptions& options) {
  Question question = question_of(options);
  const TerrainSource source = terrain_source(options.terrain);
  check_grid(source, question.window, options.terrain.resolution_m);
  if (!question.site) question.site = question.window ? question.window->centre() : middle(source);
  const std::unique_ptr<Ground> ground = ground_of(source, *question.site, options.terrain.seed);
  print_advice(*ground);
  constexpr int bands = 2;
  const MapGrid grid = map_grid(source, question.window, options.terrain.resolution_m, bands);
  check_reach(grid, *ground);
  const double resolution_m = cell_m(grid, *source.body);

  WorkerPool pool(options.threads);
  std::vector<GroundLightProbe> probes;  // one a part of a row, so one a thread
  const auto parts = static_cast<std::size_t>(options.threads);
  for (std::size_t k = 0; k < parts; ++k) probes.emplace_back(*ground, resolution_m);
  double lit = 0;
  std::int64_t cells = 0;  // with ground
  LightOverEnd over_end;
  const MapRow row = [&](std::span<const std::optional<Geodetic>> places) {
    std::vector<double> values(2 * places.size(), missing);
    std::vector<std::optional<GroundEnd>> ends(places.size());
    std::vector<double> sun_rad(places.size());
    pool.for_each(parts, [&](std::size_t part) {
      for (std::size_t k = part; k < places.size(); k += parts) {
        if (!places[k]) continue;
        const Sunlight sun = sunlight(*source.body, *places[k], question.at, 0);
        const Vec3 p_S_m = ground->site().p_S_m(*places[k]);
        const auto found =
            probes[part].at(*places[k], direction_S(ground->site(), p_S_m, sun.seen), sun.disc_rad);
        if (!found) continue;
        values[k] = found->sun_fraction * (1 - sun.eclipsed);
        values[places.size() + k] = found->incidence;
        ends[k] = found->end;
        sun_rad[k] = sun.seen.elevation_rad;
      }
    });
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (std::isnan(values[k])) continue;
      ++cells;
      lit += values[k];
      if (values[k] > 0) over_end.add(ends[k], sun_rad[k]);
    }
    return values;
  };
  write_map(options.file, grid, *source.body,
            {{"share of the Sun's disc seen", ""}, {"cosine of incidence", ""}}, row);
  AnswerRow answer{
      {"file", options.file},
      {"columns", grid.columns},
      {"rows", grid.rows},
      {"utc", format_utc(question.at)},
      {"body", source.body->name},
      {"mean_sun_fraction", computed(cells > 0 ? lit / static_cast<double>(cells) : missing)},
      {"cells_without_value", std::int64_t{grid.columns} * grid.rows - cells}};
  if (over_end.is_any()) {
    const std::string warning = over_end.warning();
    print_message("warning: {}\n", warning);
    answer["ground_reaches_m"] = std::round(over_end.mean_m());
    answer["warnings"] = {warning};
  }
  print_answer(AnswerRow::array({answer}), options.terrain.style);
  return 0;
}

}  // namespace

std::function<int()> prepare_light(CommandOptions& command) {
  const auto options = std::make_shared<LightOptions>();
  add_ground(command, options->terrain);
  command.add_option("--at", options->at, "UTC: 2026-07-01T00:00:00Z").required();
  command.add_option("-o,--output", options->file, "The GeoTIFF to write").required();
  add_threads(command, options->threads, "Threads that work on it");
  add_style(command, options->terrain.style);
  return [options] { return light_command(*options); };
}

}  // namespace lsos
