#include "plan/mission_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/quantity.h"
#include "base/resolved_path.h"
#include "plan/suggestions.h"
#include "planet/place_text.h"

namespace lsos {

namespace {

namespace fs = std::filesystem;

// The interval, if it is a multiple of the exchange period.
std::optional<SimTime> whole_exchanges(double interval_s) {
  const double exchanges = interval_s / seconds(exchange_period);
  const double nearest = std::round(exchanges);
  if (std::abs(exchanges - nearest) > 1e-9 * nearest) return {};
  return exchange_period * static_cast<std::int64_t>(nearest);
}

std::optional<SimTime> read_interval(FieldReader& fields, const FieldValues& values,
                                     const std::string& key, const std::string& name) {
  const double* interval_s = find_value<double>(values, key);
  if (interval_s == nullptr) return {};
  const std::optional<SimTime> interval = whole_exchanges(*interval_s);
  if (!interval) fields.error(name, "must be a multiple of 0.1 s");
  return interval;
}

// Resolves the text of `field`, Terrain or TerrainBeyond: a terrain script, else a raster.
TerrainName read_terrain(FieldReader& fields, const std::string& field, const std::string& text,
                         const ReadContext& context) {
  TerrainName terrain{text, false, text};
  const std::vector<std::string>& names = context.declarations.terrains;
  if (std::ranges::find(names, text) != names.end()) return terrain;
  if (const auto broken = context.declarations.broken_terrains.find(text);
      broken != context.declarations.broken_terrains.end()) {
    fields.add(broken->second);
    fields.error(field, "its script is broken");
    return terrain;
  }
  const std::string path = resolved_path(fs::path(context.plan_file).parent_path().string(), text);
  std::error_code error;
  // Paths in GDAL's virtual file systems name rasters inside archives; GDAL checks that they exist.
  if (text.starts_with("/vsi") || fs::is_regular_file(path, error)) {
    terrain.name = path;
    terrain.is_raster = true;
    return terrain;
  }
  std::string hint = Suggestions(names)(text);
  if (hint.empty()) hint = fmt::format("; there are {}", listed(names));
  fields.error(field, fmt::format("is neither the name of a terrain nor a file relative to the "
                                  "plan{}",
                                  hint));
  return terrain;
}

}  // namespace

Place place_of(const SourcePlacemark& placemark, const ReadContext& context) {
  return {placemark.file.empty() ? context.source_file : placemark.file, placemark.line};
}

Subject subject_of(const PlanPlacemark& ours, const std::string& id_field,
                   const ReadContext& context) {
  const std::string& type = ours.data.schema;
  Subject subject{place_of(*ours.placemark, context), type};
  if (!ours.placemark->name.empty()) {
    subject.name += " " + quoted(ours.placemark->name);
    return subject;
  }
  const auto id = std::ranges::find(ours.data.fields, id_field, &SourceField::name);
  if (id != ours.data.fields.end() && !id->text.empty()) subject.name += " " + shown(id->text);
  return subject;
}

MissionInfo read_mission(const std::vector<PlanPlacemark>& missions, const ReadContext& context,
                         PlanGaps& gaps, std::vector<std::string>& defaults) {
  MissionInfo mission;
  gaps.start_time = true;
  if (missions.empty()) {
    context.faults.error({context.source_file, 0},
                         "has no MissionInfo; exactly one is wanted: a Placemark with "
                         "<SchemaData schemaUrl=\"#MissionInfo\">");
    return mission;
  }
  mission.place = place_of(*missions[0].placemark, context);
  for (std::size_t i = 1; i < missions.size(); ++i) {
    const Place place = place_of(*missions[i].placemark, context);
    context.faults.error(place, fmt::format("MissionInfo: a second one; the first is at {}",
                                            line_text(mission.place, place.file)));
  }
  FieldReader fields({mission.place, "MissionInfo"}, missions[0].data, context.faults);
  fields.check_names({mission_fields()});
  const FieldValues values = fields.read(mission_fields(), &defaults);

  if (const auto* planet = find_value<std::string>(values, "planet")) {
    mission.planet = find_body(*planet);
  }
  if (const auto* start = find_value<Instant>(values, "start_time")) {
    mission.start_time = *start;
    gaps.start_time = false;
  }
  if (const auto* terrain = find_value<std::string>(values, "terrain")) {
    mission.terrain = read_terrain(fields, "Terrain", *terrain, context);
  }
  if (const auto* beyond = find_value<std::string>(values, "terrain_beyond")) {
    mission.terrain_beyond = read_terrain(fields, "TerrainBeyond", *beyond, context);
  }
  if (const auto* soil = find_value<std::string>(values, "soil")) mission.soil = *soil;
  if (const auto* variant = find_value<std::string>(values, "soil_variant")) {
    mission.soil_variant = *variant;
  }
  if (const auto* home = find_value<std::string>(values, "case_of")) {
    mission.case_of = *home;
    const std::string folder = fs::path(context.source_file).parent_path().string();
    const std::string named = resolved_path(folder, *home);
    std::error_code unreadable;
    if (!fs::is_regular_file(named, unreadable)) {
      fields.error(case_of_field, fmt::format("there is no plan {}, beside which the scripts and "
                                              "rasters of this one lie",
                                              named));
    } else if (context.plan_file != named) {
      fields.error(case_of_field,
                   fmt::format("{} is not the file of which this is a case, by its CaseOfSha256; "
                               "lsos-host sweep makes the cases of a changed plan",
                               named));
    }
  }
  if (const auto* site = find_value<std::string>(values, "site_origin")) {
    const Parsed<Geodetic> place = parse_lon_lat(*site);
    if (!place) fields.error(site_field, place.why);
    mission.site = place.value;
  }
  if (const auto* seed = find_value<std::int64_t>(values, "seed")) {
    mission.seed = static_cast<std::uint64_t>(*seed);
  }
  mission.log_interval =
      read_interval(fields, values, "log_interval_s", "LogInterval").value_or(mission.log_interval);
  mission.parked_log_interval =
      read_interval(fields, values, "parked_log_interval_s", "ParkedLogInterval")
          .value_or(std::max(mission.parked_log_interval, mission.log_interval));
  if (mission.parked_log_interval < mission.log_interval) {
    fields.error("ParkedLogInterval",
                 fmt::format("must be at least the LogInterval, {}",
                             format_quantity(seconds(mission.log_interval), *find_unit("s"))));
  }
  if (fields.find("ParkedLogInterval") == nullptr) {
    defaults.push_back(
        fmt::format("MissionInfo: ParkedLogInterval = {}",
                    format_quantity(seconds(mission.parked_log_interval), *find_unit("s"))));
  }
  if (const auto* longest_s = find_value<double>(values, "max_duration_s")) {
    mission.max_duration = from_seconds(*longest_s);
    mission.has_max_duration = true;
  }
  if (const SourceField* field = fields.find("OnFailure")) {
    mission.on_failure = {field->text, field->line};
  }
  return mission;
}

}  // namespace lsos
