#include "product/overlay.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <set>
#include <utility>

#include "base/error.h"
#include "base/files.h"
#include "base/units.h"
#include "plan/kml_writer.h"
#include "planet/meridian.h"
#include "product/balloon.h"
#include "product/overlay_style.h"
#include "product/rover_track.h"
#include "product/thinned_notes.h"
#include "record/columns.h"

namespace lsos {

namespace {

// The prefix keeps plan readers from taking these Placemarks for events ("Sample").
template <class Row>
std::string schema_id;
template <>
const std::string schema_id<SampleRow> = "lsos_samples";
template <>
const std::string schema_id<EventRow> = "lsos_events";
template <>
const std::string schema_id<PlannedPathRow> = "lsos_planned_paths";
template <>
const std::string schema_id<NoteRow> = "lsos_notes";
const std::string track_schema_id = "lsos_track";

// Columns of the samples that viewers plot along the track.
constexpr std::array track_columns{"elevation_m", "speed_mps",     "slope_rad",
                                   "charge",      "energy_rate_w", "solar_w"};

const char* kml_type(ColumnType type) {
  switch (type) {
    case ColumnType::integer:
      return "int";
    case ColumnType::real:
      return "double";
    case ColumnType::utc:
    case ColumnType::text:
      break;
  }
  return "string";
}

template <class Row>
KmlSchema schema() {
  KmlSchema schema{schema_id<Row>, schema_id<Row>, {}};
  for (const Column<Row>& column : columns<Row>()) {
    schema.fields.push_back({std::string(column.name), kml_type(column.type), ""});
  }
  return schema;
}

KmlSchema track_schema() {
  KmlSchema schema{track_schema_id, track_schema_id, {}};
  for (const char* column : track_columns) schema.array_fields.push_back({column, "float", ""});
  return schema;
}

// Seven digits, as the log has all of them; places keep all, as 1e-8 degrees are a millimetre.
std::string shown_text(std::string_view name, const ColumnValue& value) {
  const auto* number = std::get_if<double>(&value);
  if (number == nullptr || name.ends_with("_deg")) return to_text(value);
  return fmt::format("{:.7g}", *number);
}

// A Placemark with every column of the row that is not NULL.
template <class Row>
KmlPlacemark placemark(const Row& row, Instant start, std::string name) {
  KmlPlacemark placemark;
  placemark.name = std::move(name);
  placemark.schema_id = schema_id<Row>;
  for (const Column<Row>& column : columns<Row>()) {
    const ColumnValue value = column.value(row, start);
    if (std::holds_alternative<std::monostate>(value)) continue;
    placemark.data.emplace_back(column.name, shown_text(column.name, value));
  }
  return placemark;
}

KmlFolder named_folder(std::string name) {
  KmlFolder folder;
  folder.name = std::move(name);
  return folder;
}

KmlGeometry point(const Geodetic& place) { return {KmlGeometryKind::point, {place}}; }

// XML's calendar has no second 60: within a leap second the result is "", no time to show.
std::string xml_time(Instant instant) {
  const std::string utc = format_utc(instant);
  return utc.find(":60.") == std::string::npos ? utc : "";
}

KmlFolder drawn_lines(const Plan& plan, const std::string& rover_id, const RoverStyle& style) {
  KmlFolder folder = named_folder(rover_id + " plan");
  for (const PlanEvent& event : plan.events) {
    std::vector<Geodetic> points = event.geometry.points;
    if (event.rover_id != rover_id || points.size() < 2) continue;
    if (event.geometry.kind == GeometryKind::polygon) points.push_back(points.front());
    KmlPlacemark line;
    line.name = fmt::format("{} {} (plan)", rover_id, event.label);
    line.style_id = style.plan_id;
    line.geometry = {KmlGeometryKind::line, unwrapped_longitudes(std::move(points))};
    folder.placemarks.push_back(line);
    for (std::vector<Geodetic> hole : event.geometry.holes) {
      hole.push_back(hole.front());
      line.name = fmt::format("{} {} (plan, kept out of)", rover_id, event.label);
      line.geometry = {KmlGeometryKind::line, unwrapped_longitudes(std::move(hole))};
      folder.placemarks.push_back(line);
    }
  }
  return folder;
}

// Planned lines are white, to contrast with the driven line in the rover's colour.
KmlFolder planned_lines(const std::vector<PlannedPathRow>& paths, Instant start,
                        const std::string& rover_id, const RoverStyle& style) {
  KmlFolder folder = named_folder(rover_id + " planned");
  for (const PlannedPathRow& path : paths) {
    if (path.rover_id != rover_id) continue;
    KmlPlacemark line =
        placemark(path, start,
                  fmt::format("{} event {} to waypoint {} (planned{})", rover_id, path.sequence,
                              path.leg, path.attempt > 0 ? " again" : ""));
    line.description = balloon(path);
    line.style_id = style.planned_id;
    line.geometry = {KmlGeometryKind::line, unwrapped_longitudes(path.line)};
    folder.placemarks.push_back(std::move(line));
  }
  return folder;
}

KmlFolder driven_line(const RoverTrack& track, const std::string& rover_id,
                      const RoverStyle& style) {
  KmlFolder folder = named_folder(rover_id + " driven");
  KmlPlacemark line;
  line.name = rover_id + " driven";
  line.style_id = style.driven_id;
  line.geometry = {KmlGeometryKind::line, unwrapped_longitudes(track.line())};
  if (line.geometry.points.size() >= 2) folder.placemarks.push_back(std::move(line));
  return folder;
}

KmlFolder event_points(const std::vector<EventRow>& events, Instant start,
                       const std::string& rover_id) {
  KmlFolder folder = named_folder(rover_id + " events");
  // Only the first event at a place and failed events are labelled: all labels would overlap.
  std::set<std::pair<long, long>> labelled;
  const auto is_first_at = [&](const Geodetic& place) {
    constexpr double parts = 1e6;  // of a radian: 2 m on the Moon
    return labelled.insert({std::lround(parts * place.lon_rad), std::lround(parts * place.lat_rad)})
        .second;
  };
  for (const EventRow& event : events) {
    if (event.rover_id != rover_id) continue;
    KmlPlacemark mark = placemark(event, start, event.label);
    mark.description = balloon(event, start);
    const bool is_first = !event.place || is_first_at(*event.place);
    const bool has_label = is_first || event.status == EventStatus::failed;
    mark.style_id = status_style_id(event.status, has_label);
    // The mark shows how the event ended, so it appears at that time and stays on the map.
    const auto& known_from = event.end ? event.end : event.start;
    if (known_from) mark.begin_utc = xml_time(start + *known_from);
    if (event.place) mark.geometry = point(*event.place);
    folder.placemarks.push_back(std::move(mark));
  }
  return folder;
}

KmlFolder sample_points(const RoverTrack& track, Instant start, const std::string& rover_id,
                        const RoverStyle& style) {
  KmlFolder folder = named_folder(rover_id + " samples");
  for (const SampleRow& row : track.samples()) {
    KmlPlacemark mark = placemark(row, start, fmt::format("{} {} s", rover_id, seconds(row.time)));
    mark.description = balloon(row, start);
    mark.style_id = style.sample_id;
    if (std::isfinite(row.heading_rad)) mark.icon_heading_deg = degrees(row.heading_rad);
    mark.when_utc = xml_time(start + row.time);
    mark.geometry = point(row.place);
    folder.placemarks.push_back(std::move(mark));
  }
  return folder;
}

KmlFolder moving_point(const RoverTrack& track, Instant start, const std::string& rover_id,
                       const RoverStyle& style) {
  KmlFolder folder = named_folder(rover_id + " track");
  KmlPlacemark mark;
  mark.name = rover_id;
  mark.style_id = style.track_id;
  mark.schema_id = track_schema_id;
  const std::vector<SampleRow> samples = track.track();
  std::vector<const SampleRow*> rows;
  for (const SampleRow& row : samples) {
    std::string utc = xml_time(start + row.time);
    if (utc.empty()) continue;
    mark.track.when_utc.push_back(std::move(utc));
    mark.track.points.push_back(row.place);
    rows.push_back(&row);
  }
  for (const Column<SampleRow>& column : columns<SampleRow>()) {
    if (std::ranges::find(track_columns, column.name) == track_columns.end()) continue;
    std::vector<std::string> texts;
    bool is_known = false;
    for (const SampleRow* row : rows) {
      const ColumnValue value = column.value(*row, start);
      const auto* number = std::get_if<double>(&value);
      is_known |= number != nullptr;
      // A value that is not modelled, or not at this time, must not become 0.
      texts.push_back(number == nullptr ? "nan" : fmt::format("{:.6g}", *number));
    }
    if (is_known) mark.track.arrays.emplace_back(column.name, std::move(texts));
  }
  if (!rows.empty()) folder.placemarks.push_back(std::move(mark));
  return folder;
}

KmlFolder note_points(const ThinnedNotes& notes, Instant start) {
  KmlFolder folder = named_folder("notes");
  if (notes.rows.size() < notes.in_log) {
    folder.name = fmt::format("notes ({} of {})", notes.rows.size(), notes.in_log);
  }
  for (const NoteRow& note : notes.rows) {
    KmlPlacemark mark = placemark(note, start, note.name);
    mark.description =
        fmt::format("{} at {} s: {}", note.rover_id, seconds(note.time), note.fields_json);
    mark.when_utc = xml_time(start + note.time);
    mark.geometry = point(note.place);
    folder.placemarks.push_back(std::move(mark));
  }
  return folder;
}

// A view from above that holds all places, centred on the first.
class LookAtBounds {
 public:
  void add(const Geodetic& place) {
    if (!first_) first_ = place;
    places_.push_back(place);
  }
  std::optional<KmlLookAt> look_at(const Body& body) const {
    constexpr double least_m = 300, ranges = 2.2;  // multiple of the distance to the farthest place
    if (!first_) return {};
    double farthest_m = 0;
    for (const Geodetic& place : places_) {
      farthest_m = std::max(farthest_m, surface_distance_m(body, *first_, place));
    }
    return KmlLookAt{*first_, std::max(least_m, ranges * farthest_m)};
  }

 private:
  std::optional<Geodetic> first_;
  std::vector<Geodetic> places_;
};

std::map<std::string, RoverTrack> tracks(const LogReader& log, const Plan& plan,
                                         const std::vector<EventRow>& events) {
  const MissionInfo& mission = plan.mission;
  LSOS_ASSERT(mission.planet != nullptr);
  const std::map<std::string, SampleTotals> totals = log.sample_totals();
  // Half of a track's points are spaced by distance driven, half by time.
  const int half = overlay_track_max / 2;
  const SimTime interval = sample_interval(log.last_sample_time(), half, mission.log_interval,
                                           mission.parked_log_interval);
  std::map<std::string, RoverTrack> tracks;
  for (const auto& [id, of_rover] : totals) {
    const auto marks = [&, &id = id, &of_rover = of_rover](int most) {
      return DriveMarks(of_rover, events, id, static_cast<std::size_t>(most));
    };
    const bool is_whole = of_rover.rows <= static_cast<std::size_t>(overlay_track_max);
    tracks.try_emplace(id, *mission.planet, marks(overlay_samples_max), marks(half),
                       is_whole ? SimTime{} : interval);
  }
  log.for_each_sample([&](const SampleRow& row) {
    const auto track = tracks.find(row.rover_id);
    if (track != tracks.end()) track->second.add(row);  // absent: it appeared while the run goes on
  });
  return tracks;
}

}  // namespace

std::string overlay_kml(const LogReader& log, const Plan& plan, IconPlace icon_href) {
  const Instant start = log.start();
  const std::vector<EventRow> events = log.events();

  KmlDocument document;
  document.name = fmt::format("{}, simulated", std::filesystem::path(plan.file).stem().string());
  document.description = fmt::format("simulated from {}", format_utc(start));
  document.target = target_of(*plan.mission.planet);
  const std::vector<PlannedPathRow> paths = log.planned_paths();
  document.schemas = {schema<SampleRow>(), schema<EventRow>(), schema<PlannedPathRow>(),
                      schema<NoteRow>(), track_schema()};
  std::size_t i = 0;
  for (const EventStatus status :
       {EventStatus::completed, EventStatus::failed, EventStatus::incomplete, EventStatus::skipped,
        EventStatus::not_started, EventStatus::disabled}) {
    for (const bool has_label : {true, false}) {
      document.styles.push_back(status_style(status, has_label, icon_href));
    }
  }
  LookAtBounds bounds;
  for (const auto& [rover_id, track] : tracks(log, plan, events)) {
    const RoverStyle style(i++);
    style.add_to(document.styles, icon_href);
    for (const SampleRow& row : track.samples()) bounds.add(row.place);
    KmlFolder rover = named_folder(rover_id);
    rover.open = true;
    rover.folders = {
        drawn_lines(plan, rover_id, style),          planned_lines(paths, start, rover_id, style),
        driven_line(track, rover_id, style),         event_points(events, start, rover_id),
        moving_point(track, start, rover_id, style), sample_points(track, start, rover_id, style)};
    document.folders.push_back(std::move(rover));
  }
  document.folders.push_back(note_points(thinned_notes(log), start));
  document.look_at = bounds.look_at(*plan.mission.planet);
  return write_kml(document);
}

void write_overlay(const std::string& run_dir, const Plan& plan) {
  write_file(run_dir + "/overlay.kml", overlay_kml(LogReader(run_dir + "/log.gpkg"), plan));
}

void write_packed_overlay(const std::string& run_dir, const Plan& plan) {
  write_file(
      run_dir + "/overlay.kmz",
      pack_kmz(overlay_kml(LogReader(run_dir + "/log.gpkg"), plan, packed_icon), packed_icons()));
}

}  // namespace lsos
