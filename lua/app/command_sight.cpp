// `lsos-host sight`: whether places see each other over the ground, maps of what one sees, and its
// horizon.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/console.h"
#include "base/rounded_distance.h"
#include "base/rounding.h"
#include "base/units.h"
#include "base/worker_pool.h"
#include "lua/app/commands.h"
#include "lua/app/common_options.h"
#include "lua/app/horizon_answer.h"
#include "lua/app/instrument_answer.h"
#include "lua/app/progress.h"
#include "lua/app/sight_options.h"
#include "mission/light/sight.h"
#include "terrain/raster/raster_export.h"
#include "view/ground/ground_end.h"
#include "view/ground/viewshed.h"

namespace lsos {

namespace {

// Throws InputError where `from` is too far from the site, around which the ground is sampled.
void check_near_site(const Body& body, const Geodetic& site, const PlaceOption& from) {
  constexpr double reach_rad = 0.1;
  const double reach_m = reach_rad * body.equatorial_radius_m;
  const double away_m = surface_distance_m(body, site, from.place);
  if (away_m <= reach_m) return;
  throw InputError({}, fmt::format("--site: lies {:.0f} km from {}; up to {:.0f} km are allowed",
                                   away_m / 1000, from.option, reach_m / 1000));
}

// The place with its height above the reference surface; a fault where there is no ground.
// `resolution_m`: resolution at which the ground is sampled.
std::optional<Geodetic> on_ground(const Ground& ground, const PlaceOption& asked,
                                  double resolution_m, Faults& faults) {
  Geodetic place = asked.place;
  if (const auto height_m = ground.elevation_m(place, resolution_m)) {
    // A height this large and this close to the ground's elevation is no mast's by chance.
    constexpr double least_m = 50, near_m = 5;
    if (place.height_m > least_m && std::abs(place.height_m - *height_m) < near_m) {
      print_message(
          "warning: {}: H = {:g} m is above the ground, which lies at {:.0f} m there: is "
          "it the ground's own elevation?\n",
          asked.option, place.height_m, *height_m);
    }
    place.height_m += *height_m;
    return place;
  }
  faults.error({}, fmt::format("{}: there is no ground; the terrain does not reach there, or its "
                               "samples are missing",
                               asked.option));
  return {};
}

// Length of the straight line, and its azimuth and elevation in the sky of `from`.
AnswerRow sight_row(const SiteFrame& site, const Vec3& from_S_m, const Vec3& to_S_m) {
  const Vec3 line_m = to_S_m - from_S_m;
  const double east_m = line_m.dot(site.east_S(from_S_m));
  const double north_m = line_m.dot(site.north_S(from_S_m));
  const double up_m = line_m.dot(site.up_S(from_S_m));
  const double level_m = std::hypot(east_m, north_m);
  AnswerRow line{{"distance_m", computed(line_m.norm())},
                 {"azimuth_deg", nullptr},
                 {"elevation_deg", nullptr}};
  constexpr double least_m = 1e-6;  // a shorter line has no direction
  if (level_m > least_m) {
    const double azimuth_deg = degrees(std::atan2(east_m, north_m));
    const double from_north_deg = azimuth_deg < 0 ? azimuth_deg + 360 : azimuth_deg;
    line["azimuth_deg"] = from_north_deg < 360 ? computed(from_north_deg) : 0;
  }
  if (line_m.norm() > least_m) line["elevation_deg"] = computed(degrees(std::atan2(up_m, level_m)));
  return line;
}

// Adds a warning where a visible target is seen across ground that is not known.
void add_end(const PlaceOption& to, const std::optional<GroundEnd>& end, AnswerRow& line) {
  if (!end || line["visible"] == 0) return;
  const std::string warning = fmt::format(
      "{}: the ground on the line is not known from {} away on; what stands there may hide it; "
      "--beyond lays a coarser terrain around it",
      to.option, rounded_distance(end->reaches_m));
  print_message("warning: {}\n", warning);
  line["ground_reaches_m"] = std::round(end->reaches_m);
  line["warnings"] = {warning};
}

// Lines of sight, rendered as in missions.
AnswerRow lines(const Ground& ground, const SightQuestion& question) {
  Faults faults;
  const auto from = on_ground(ground, *question.from, 0, faults);
  std::vector<Vec3> to_S_m;
  for (const PlaceOption& asked : question.to) {
    const auto place = on_ground(ground, asked, 0, faults);
    if (place) to_S_m.push_back(ground.site().p_S_m(*place));
  }
  faults.throw_if_errors();
  const Vec3 from_S_m = ground.site().p_S_m(*from);
  Renderer renderer;
  Sight sight(ground, renderer);
  GroundEndProbe end(ground);
  AnswerRow answer = AnswerRow::array();
  for (std::size_t k = 0; k < to_S_m.size(); ++k) {
    const Vec3& p_S_m = to_S_m[k];
    AnswerRow line{{"visible", sight.line(from_S_m, p_S_m, {}).is_seen ? 1 : 0}};
    line.update(sight_row(ground.site(), from_S_m, p_S_m));
    add_end(question.to[k], end.between(from_S_m, p_S_m), line);
    answer.push_back(line);
  }
  return answer;
}

using Places = std::vector<std::optional<Geodetic>>;

// Calls work(part, k) for each place of a row, from several threads.
template <class Work>
void for_row(WorkerPool& pool, int threads, const Places& places, const Work& work) {
  const auto parts = static_cast<std::size_t>(threads);
  pool.for_each(parts, [&](std::size_t part) {
    for (std::size_t k = part; k < places.size(); k += parts) {
      if (places[k]) work(part, k);
    }
  });
}

// Finds the heights of the ground in the cells of the map. Next to missing samples the ground has
// no height; there the raster's own samples are used.
void find_heights(const TerrainSource& source, const Ground& ground, double resolution_m,
                  const SightOptions& options, WorkerPool& pool, MapHeights& heights) {
  const RasterReader* own = options.terrain.resolution_m ? nullptr : source.reader();
  std::vector<Ground::Probe> probes;  // one for each part of a row, hence for each thread
  for (int k = 0; k < options.threads; ++k) probes.emplace_back(ground, resolution_m);
  constexpr double close_m = 64;
  Places places(heights.row(0).size());
  for (int row = 0; row < heights.rows(); ++row) {
    for (std::size_t k = 0; k < places.size(); ++k) {
      places[k] = heights.map().place({static_cast<double>(k), static_cast<double>(row)});
    }
    const std::span<float> heights_m = heights.row(row);
    for_row(pool, options.threads, places, [&](std::size_t part, std::size_t k) {
      // Probes are fast where cells are close together, but they do not reach around the body.
      std::optional<double> height_m;
      if (resolution_m < close_m) {
        const GroundSample sample = probes[part].sample(ground.site().p_S_m(*places[k]));
        if (sample.is_ground()) height_m = sample.elevation_m;
      }
      if (!height_m) height_m = ground.elevation_m(*places[k], resolution_m);
      if (height_m) heights_m[k] = static_cast<float>(*height_m);
    });
    for (std::size_t k = 0; k < places.size() && own != nullptr; ++k) {
      if (!places[k] || !std::isnan(heights_m[k])) continue;
      const auto point = own->at(*places[k]);
      if (point && point->height_m) heights_m[k] = static_cast<float>(*point->height_m);
    }
  }
}

// Position of the observer, above the map's own ground where the map covers it.
Geodetic eye_of(const Ground& ground, const MapHeights& heights, const PlaceOption& from,
                double resolution_m) {
  if (const auto height_m = heights.height_m(from.place)) {
    return {from.place.lon_rad, from.place.lat_rad, *height_m + from.place.height_m};
  }
  Faults faults;
  const auto eye = on_ground(ground, from, resolution_m, faults);
  faults.throw_if_errors();
  return *eye;
}

void check_flat(const ViewSector& sector, const Viewshed& view) {
  if (sector.farthest_m <= view.reach_m()) return;
  throw InputError({}, fmt::format("--flat: the map reaches {:.0f} km from --from; up to {:.0f} km "
                                   "are allowed: give a --window",
                                   sector.farthest_m / 1000, view.reach_m() / 1000));
}

// Estimates the share of a map's visible places that are seen across ground that is not known. It
// samples at most some 4000 lines of sight, since each is marched on its own.
class SeenOverEnd {
 public:
  SeenOverEnd(const Ground& ground, const Vec3& eye_S_m, std::size_t cells, double cell_m)
      : probe_(ground),
        eye_S_m_(eye_S_m),
        margin_m_(2 * cell_m),
        every_(ground.has_end() ? std::max<std::size_t>(1, cells / lines) : 0) {}

  // To be called for each visible place.
  void add(const Vec3& target_S_m) {
    if (every_ == 0 || ++seen_ % every_ != 0) return;
    ++asked_;
    if (probe_.between(eye_S_m_, target_S_m, margin_m_)) ++over_;
  }
  std::optional<std::string> warning() const {
    if (over_ == 0) return {};
    return fmt::format(
        "{:.0f} % of what is seen is seen over ground that is not known; what "
        "stands there may hide it; --beyond lays a coarser terrain around it",
        std::max(1.0, std::floor(100.0 * over_ / asked_)));
  }

 private:
  static constexpr std::size_t lines = 4000;

  GroundEndProbe probe_;
  Vec3 eye_S_m_;
  double margin_m_;    // next to missing samples there is no ground, but the raster has cells
  std::size_t every_;  // 0: the ground has no end
  std::size_t seen_ = 0;
  int asked_ = 0, over_ = 0;
};

AnswerRow viewshed(const TerrainSource& source, const Ground& ground, const SightQuestion& question,
                   const SightOptions& options) {
  const SiteFrame& site = ground.site();
  constexpr int values_of_cell = 2;  // height and visibility
  const MapGrid grid =
      map_grid(source, question.window, options.terrain.resolution_m, values_of_cell);
  const double resolution_m = cell_m(grid, *source.body);
  WorkerPool pool(options.threads);
  MapHeights heights(grid, *source.body);
  find_heights(source, ground, resolution_m, options, pool, heights);
  const Geodetic eye = eye_of(ground, heights, *question.from, resolution_m);
  const ViewSector sector = sector_of(grid, site, eye);
  Viewshed view(ground, &heights, {eye, resolution_m, options.is_flat}, sector);
  if (options.is_flat) check_flat(sector, view);
  const auto parts = static_cast<std::size_t>(options.threads);
  Progress progress(options.is_quiet);
  std::atomic<std::size_t> marched = 0;
  pool.for_each(parts, [&](std::size_t part) {
    GroundProbes probes = view.probes();
    for (std::size_t ray = part; ray < view.ray_count(); ray += parts) {
      view.march(ray, probes);
      const double share = static_cast<double>(++marched) / static_cast<double>(view.ray_count());
      if (part == 0) progress.show(share);
    }
  });
  progress.finish();

  double seen = 0, cells = 0;
  SeenOverEnd over_end(ground, site.p_S_m(eye), std::size_t{1} * grid.columns * grid.rows,
                       resolution_m);
  int row = 0;
  const MapRow is_seen = [&](std::span<const std::optional<Geodetic>> of_row) {
    const Places places(of_row.begin(), of_row.end());
    const std::span<const float> heights_m = heights.row(row++);
    const auto target_S_m = [&](std::size_t k) {
      return site.p_S_m({places[k]->lon_rad, places[k]->lat_rad, heights_m[k] + question.target_m});
    };
    std::vector<double> values(places.size(), missing);
    for_row(pool, options.threads, places, [&](std::size_t, std::size_t k) {
      if (std::isnan(heights_m[k])) return;
      values[k] = view.sees(target_S_m(k)) ? 1 : 0;
    });
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (std::isnan(values[k])) continue;
      ++cells;
      seen += values[k];
      if (values[k] != 0) over_end.add(target_S_m(k));
    }
    return values;
  };
  write_map(options.file, grid, *source.body, {{"seen", ""}}, is_seen);
  AnswerRow answer{{"file", options.file},
                   {"columns", grid.columns},
                   {"rows", grid.rows},
                   {"body", source.body->name},
                   {"seen_share", computed(cells > 0 ? seen / cells : missing)}};
  if (const auto warning = over_end.warning()) {
    print_message("warning: {}\n", *warning);
    answer["warnings"] = {*warning};
  }
  return answer;
}

int sight_command(const SightOptions& options) {
  const SightQuestion question = question_of(options);
  const TerrainSource source = terrain_source(options.terrain);
  const bool is_map = !options.file.empty();
  if (is_map) check_grid(source, question.window, options.terrain.resolution_m);
  const Geodetic site = question.site.value_or(question.from->place);
  if (!question.site) print_default_site(source, site);
  check_near_site(*source.body, site, *question.from);
  const std::unique_ptr<Ground> ground =
      ground_of(source, {site.lon_rad, site.lat_rad, 0}, options.terrain.seed);
  print_advice(*ground);
  AnswerRow answer;
  if (options.is_horizon) {
    answer = horizon_answer(*ground, question.from->place, options.step_deg.value_or(1));
  } else if (is_map) {
    answer = AnswerRow::array({viewshed(source, *ground, question, options)});
  } else {
    answer = lines(*ground, question);
  }
  print_answer(answer, options.terrain.style);
  return 0;
}

}  // namespace

std::function<int()> prepare_sight(CommandOptions& command) {
  const auto options = std::make_shared<SightOptions>();
  add_ground(command, options->terrain);
  command.add_option("--from", options->from, "LON,LAT,H: degrees; m above ground").required();
  command.add_option("--to", options->to, "LON,LAT,H; may be repeated").repeated();
  command.add_option("--height", options->height_m, "Target height in each cell, m above ground");
  command.add_option("-o,--output", options->file, "The GeoTIFF to write: 1 seen, 0 not");
  command.add_flag("--flat", options->is_flat, "The map as if the body did not curve");
  command.add_flag("--horizon", options->is_horizon, "Elevation of the horizon by azimuth");
  command.add_option("--step", options->step_deg, "Of the horizon's azimuths, deg (1)");
  add_threads(command, options->threads, "Threads that work on it");
  command.add_flag("--quiet", options->is_quiet, "No progress");
  add_style(command, options->terrain.style);
  return [options] { return sight_command(*options); };
}

}  // namespace lsos
