// `lsos-host light`: a map of how much of the Sun the ground sees, and how steeply; or for how long
// in a span of time.
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/console.h"
#include "base/output_file.h"
#include "base/parsed.h"
#include "base/quantity.h"
#include "base/rounded_distance.h"
#include "base/rounding.h"
#include "base/units.h"
#include "base/worker_pool.h"
#include "lua/app/commands.h"
#include "lua/app/common_options.h"
#include "lua/app/instrument_answer.h"
#include "lua/app/place_options.h"
#include "lua/app/progress.h"
#include "lua/app/terrain_source.h"
#include "planet/sunlight.h"
#include "terrain/raster/raster_export.h"
#include "view/exposure/ground_light.h"
#include "view/exposure/light_times.h"

namespace lsos {

namespace {

struct LightOptions {
  TerrainOptions terrain;       // of these name, raster, planet, site, seed, window, resolution
  std::string at;               // UTC
  std::string from, to, every;  // UTC, UTC, a duration; instead of `at`
  std::string file;             // OUT.tif
  bool is_quiet = false;
  int threads = 1;
};

// More moments than this are a slip of the pen.
constexpr std::int64_t moments_max = 100'000;
constexpr double least_every_s = 1e-3;  // times are whole microseconds

struct LightQuestion {
  Instant at;
  Instant from, to;
  SimTime every{};
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

bool is_span(const LightOptions& options) {
  return !options.from.empty() || !options.to.empty() || !options.every.empty();
}

Instant read_utc(const char* option, const std::string& text, Faults& faults) {
  const Parsed<Instant> at = parse_utc(text);
  if (!at) faults.error({}, fmt::format("{} {}: {}", option, text, at.why));
  return at.value.value_or(Instant{});
}

// Reads the span of time, or adds its faults.
void read_span(const LightOptions& options, LightQuestion& question, Faults& all) {
  Faults faults;
  if (!options.at.empty()) {
    faults.error({}, "--at: is for one moment, and --from, --to and --every for many: one of them");
  }
  for (const auto& [option, text] :
       {std::pair{"--from", &options.from}, std::pair{"--to", &options.to},
        std::pair{"--every", &options.every}}) {
    if (!text->empty()) continue;
    faults.error({}, fmt::format("{}: is missing; a span of time takes --from UTC --to UTC "
                                 "--every DURATION",
                                 option));
  }
  if (!options.from.empty()) question.from = read_utc("--from", options.from, faults);
  if (!options.to.empty()) question.to = read_utc("--to", options.to, faults);
  double every_s = 0;
  if (!options.every.empty()) {
    const Parsed<double> every = parse_quantity(options.every, *find_unit("s"));
    if (!every) faults.error({}, fmt::format("--every {}: {}", options.every, every.why));
    every_s = every.value.value_or(0);
  }
  if (!faults.has_errors()) {
    const double span_s = seconds(question.to - question.from);
    const double least_s = std::max(least_every_s, span_s / moments_max);
    if (span_s <= 0) {
      faults.error({}, fmt::format("--to {}: must be later than --from", options.to));
    } else if (every_s < least_s || every_s > span_s) {
      faults.error({}, fmt::format("--every {}: {:.3g} s to {:.6g} s are allowed in that span",
                                   options.every, least_s, span_s));
    }
    question.every = from_seconds(every_s);
  }
  all.add(faults.sorted());
}

LightQuestion light_question(const LightOptions& options) {
  Faults faults;
  LightQuestion question;
  const TerrainOptions& terrain = options.terrain;
  if (is_span(options)) {
    read_span(options, question, faults);
  } else if (options.at.empty()) {
    faults.error({}, "light: no time is given; --at UTC, or --from UTC --to UTC --every DURATION");
  } else {
    question.at = read_utc("--at", options.at, faults);
  }
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

// A map in the making: the ground, its grid, and the threads that compute its cells.
struct LightMap {
  const Ground& ground;
  const MapGrid& grid;
  double resolution_m;
  const LightOptions& options;
  WorkerPool pool;
  Progress progress;
  int rows_done = 0;
  std::int64_t cells = 0;  // with ground
  LightOverEnd over_end;

  LightMap(const Ground& ground_of_map, const MapGrid& grid_of_map, const LightOptions& asked)
      : ground(ground_of_map),
        grid(grid_of_map),
        resolution_m(cell_m(grid, ground.site().body())),
        options(asked),
        pool(asked.threads),
        progress(asked.is_quiet) {}

  std::size_t parts() const { return static_cast<std::size_t>(options.threads); }
  // Calls cell(part, k) for each place of a row, from several threads.
  template <class Cell>
  void for_row(std::span<const std::optional<Geodetic>> places, const Cell& cell) {
    pool.for_each(parts(), [&](std::size_t part) {
      for (std::size_t k = part; k < places.size(); k += parts()) {
        if (places[k]) cell(part, k);
      }
    });
    progress.show(static_cast<double>(++rows_done) / grid.rows);
  }
  void write(const std::vector<MapBand>& bands, const MapRow& row) {
    write_map(options.file, grid, ground.site().body(), bands, row);
    progress.finish();
  }
  AnswerRow answer() const {
    return {{"file", options.file},
            {"columns", grid.columns},
            {"rows", grid.rows},
            {"body", ground.site().body().name},
            {"cells_without_value", std::int64_t{grid.columns} * grid.rows - cells}};
  }
};

double mean(double sum, std::int64_t count) {
  return computed(count > 0 ? sum / static_cast<double>(count) : missing);
}

AnswerRow light_at(LightMap& map, Instant at) {
  const SiteFrame& site = map.ground.site();
  std::vector<GroundLightProbe> probes;  // one a part of a row, so one a thread
  for (std::size_t k = 0; k < map.parts(); ++k) probes.emplace_back(map.ground, map.resolution_m);
  double lit = 0;
  const MapRow row = [&](std::span<const std::optional<Geodetic>> places) {
    std::vector<double> values(2 * places.size(), missing);
    std::vector<std::optional<GroundEnd>> ends(places.size());
    std::vector<double> sun_rad(places.size());
    map.for_row(places, [&](std::size_t part, std::size_t k) {
      const Sunlight sun = sunlight(site.body(), *places[k], at, 0);
      const Vec3 p_S_m = site.p_S_m(*places[k]);
      const auto found =
          probes[part].at(*places[k], direction_S(site, p_S_m, sun.seen), sun.disc_rad);
      if (!found) return;
      values[k] = found->sun_fraction * (1 - sun.eclipsed);
      values[places.size() + k] = found->incidence;
      ends[k] = found->end;
      sun_rad[k] = sun.seen.elevation_rad;
    });
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (std::isnan(values[k])) continue;
      ++map.cells;
      lit += values[k];
      if (values[k] > 0) map.over_end.add(ends[k], sun_rad[k]);
    }
    return values;
  };
  map.write({{"share of the Sun's disc seen", ""}, {"cosine of incidence", ""}}, row);
  AnswerRow answer = map.answer();
  answer["utc"] = format_utc(at);
  answer["mean_sun_fraction"] = mean(lit, map.cells);
  return answer;
}

AnswerRow light_times(LightMap& map, const LightQuestion& question) {
  const std::vector<SunMoment> moments = sun_moments(question.from, question.to, question.every);
  std::vector<LightTimesProbe> probes;
  for (std::size_t k = 0; k < map.parts(); ++k) {
    probes.emplace_back(map.ground, map.resolution_m, moments);
  }
  double lit = 0, longest_dark_s = 0, longest_lit_s = 0;
  const MapRow row = [&](std::span<const std::optional<Geodetic>> places) {
    std::vector<std::optional<LightTimes>> found(places.size());
    map.for_row(places,
                [&](std::size_t part, std::size_t k) { found[k] = probes[part].at(*places[k]); });
    std::vector<double> values(3 * places.size(), missing);
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (!found[k]) continue;
      const LightTimes& times = *found[k];
      values[k] = times.mean_fraction;
      values[places.size() + k] = times.longest_dark_s;
      values[2 * places.size() + k] = times.longest_lit_s;
      ++map.cells;
      lit += times.mean_fraction;
      longest_dark_s = std::max(longest_dark_s, times.longest_dark_s);
      longest_lit_s = std::max(longest_lit_s, times.longest_lit_s);
      if (times.longest_lit_s > 0) map.over_end.add(times.end, times.end_sun_rad);
    }
    return values;
  };
  map.write(
      {{"mean share of the Sun's disc seen", ""}, {"longest dark", "s"}, {"longest lit", "s"}},
      row);
  AnswerRow answer = map.answer();
  answer["from_utc"] = format_utc(question.from);
  answer["to_utc"] = format_utc(question.to);
  answer["moments"] = moments.size();
  answer["mean_sun_fraction"] = mean(lit, map.cells);
  answer["longest_dark_s"] = computed(map.cells > 0 ? longest_dark_s : missing);
  answer["longest_lit_s"] = computed(map.cells > 0 ? longest_lit_s : missing);
  return answer;
}

int light_command(const LightOptions& options) {
  LightQuestion question = light_question(options);
  const TerrainSource source = terrain_source(options.terrain);
  check_grid(source, question.window, options.terrain.resolution_m);
  if (!question.site) {
    question.site = question.window ? question.window->centre() : middle(source);
    print_default_site(source, *question.site);
  }
  const std::unique_ptr<Ground> ground = ground_of(source, *question.site, options.terrain.seed);
  print_advice(*ground);
  const int bands = is_span(options) ? 3 : 2;
  const MapGrid grid = map_grid(source, question.window, options.terrain.resolution_m, bands);
  check_reach(grid, *ground);
  LightMap map(*ground, grid, options);
  AnswerRow answer = is_span(options) ? light_times(map, question) : light_at(map, question.at);
  if (map.over_end.is_any()) {
    const std::string warning = map.over_end.warning();
    print_message("warning: {}\n", warning);
    answer["ground_reaches_m"] = std::round(map.over_end.mean_m());
    answer["warnings"] = {warning};
  }
  print_answer(AnswerRow::array({answer}), options.terrain.style);
  return 0;
}

}  // namespace

std::function<int()> prepare_light(CommandOptions& command) {
  const auto options = std::make_shared<LightOptions>();
  add_ground(command, options->terrain);
  command.add_option("--at", options->at, "UTC: 2026-07-01T00:00:00Z");
  command.add_option("--from", options->from, "UTC; with --to and --every: of a span of time");
  command.add_option("--to", options->to, "UTC, not itself a moment");
  command.add_option("--every", options->every, "How often the Sun is looked at: 1 h, 600");
  command.add_option("-o,--output", options->file, "The GeoTIFF to write").required();
  add_threads(command, options->threads, "Threads that work on it");
  command.add_flag("--quiet", options->is_quiet, "No progress");
  add_style(command, options->terrain.style);
  return [options] { return light_command(*options); };
}

}  // namespace lsos
