#include "product/overlay_marks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>
#include <variant>

#include "base/replaced.h"
#include "base/units.h"
#include "planet/meridian.h"
#include "product/balloon.h"
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

KmlGeometry point(const Geodetic& place) { return {KmlGeometryKind::point, {place}}; }

}  // namespace

std::optional<KmlLookAt> look_at(const Body& body, const std::vector<Geodetic>& places) {
  constexpr double least_m = 300, ranges = 2.2;  // multiple of the distance to the farthest place
  if (places.empty()) return {};
  double farthest_m = 0;
  for (const Geodetic& place : places) {
    farthest_m = std::max(farthest_m, surface_distance_m(body, places.front(), place));
  }
  return KmlLookAt{places.front(), std::max(least_m, ranges * farthest_m)};
}

std::string xml_time(Instant instant) {
  const std::string utc = format_utc(instant);
  return utc.find(":60.") == std::string::npos ? utc : "";
}

std::vector<KmlSchema> overlay_schemas() {
  return {schema<SampleRow>(), schema<EventRow>(), schema<PlannedPathRow>(), schema<NoteRow>(),
          track_schema()};
}

OverlayMarks drawn_lines(const Plan& plan, const std::string& rover_id, const RoverStyle& style) {
  OverlayMarks marks;
  for (const PlanEvent& event : plan.events) {
    std::vector<Geodetic> points = event.geometry.points;
    if (event.rover_id != rover_id || points.size() < 2) continue;
    if (event.geometry.kind == GeometryKind::polygon) points.push_back(points.front());
    KmlPlacemark line;
    line.name = fmt::format("{} {} (plan)", rover_id, event.label);
    line.style_id = style.plan_id;
    line.geometry = {KmlGeometryKind::line, unwrapped_longitudes(std::move(points))};
    marks.push_back({{}, line});
    for (std::vector<Geodetic> hole : event.geometry.holes) {
      hole.push_back(hole.front());
      line.name = fmt::format("{} {} (plan, kept out of)", rover_id, event.label);
      line.geometry = {KmlGeometryKind::line, unwrapped_longitudes(std::move(hole))};
      marks.push_back({{}, line});
    }
  }
  return marks;
}

// Planned lines are white, to contrast with the driven line in the rover's colour.
OverlayMarks planned_lines(const std::vector<PlannedPathRow>& paths, Instant start,
                           const std::string& rover_id, const RoverStyle& style) {
  OverlayMarks marks;
  for (const PlannedPathRow& path : paths) {
    if (path.rover_id != rover_id) continue;
    KmlPlacemark line =
        placemark(path, start,
                  fmt::format("{} event {} to waypoint {} (planned{})", rover_id, path.sequence,
                              path.leg, path.attempt > 0 ? " again" : ""));
    line.description = balloon(path);
    line.style_id = style.planned_id;
    line.geometry = {KmlGeometryKind::line, unwrapped_longitudes(path.line)};
    marks.push_back({path.time, std::move(line)});
  }
  return marks;
}

OverlayMarks driven_lines(const RoverTrack& track, Instant start, const std::string& rover_id,
                          const RoverStyle& style) {
  OverlayMarks marks;
  const std::vector<RoverTrack::Piece> pieces = track.driven();
  for (const RoverTrack::Piece& piece : pieces) {
    KmlPlacemark line;
    line.name = rover_id + " driven";
    line.style_id = style.driven_id;
    line.geometry = {KmlGeometryKind::line, unwrapped_longitudes(piece.line)};
    // A time slider shows those of several days that have begun.
    if (pieces.size() > 1) line.begin_utc = xml_time(start + piece.from);
    marks.push_back({piece.from, std::move(line)});
  }
  return marks;
}

OverlayMarks event_points(const std::vector<EventRow>& events, Instant start,
                          const std::string& rover_id) {
  OverlayMarks marks;
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
    marks.push_back({known_from, std::move(mark)});
  }
  return marks;
}

OverlayMarks sample_points(const RoverTrack& track, Instant start, const std::string& rover_id,
                           const RoverStyle& style) {
  OverlayMarks marks;
  for (const SampleRow& row : track.samples()) {
    KmlPlacemark mark = placemark(row, start, fmt::format("{} {} s", rover_id, seconds(row.time)));
    mark.description = balloon(row, start);
    mark.style_id = style.sample_id;
    if (std::isfinite(row.heading_rad)) mark.icon_heading_deg = degrees(row.heading_rad);
    mark.when_utc = xml_time(start + row.time);
    mark.geometry = point(row.place);
    marks.push_back({row.time, std::move(mark)});
  }
  return marks;
}

OverlayMarks moving_point(const RoverTrack& track, Instant start, const std::string& rover_id,
                          const RoverStyle& style) {
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
  if (rows.empty()) return {};
  return {{{}, std::move(mark)}};
}

OverlayMarks note_points(const ThinnedNotes& notes, Instant start) {
  OverlayMarks marks;
  for (const NoteRow& note : notes.rows) {
    // It shows where the warning began, so it stays on the map.
    const bool is_warning = note.name == "warn_when";
    KmlPlacemark mark =
        placemark(note, start, is_warning ? "WarnWhen holds" : replaced(note.name, "_", " "));
    mark.description = balloon(note, start);
    if (is_warning) mark.style_id = warning_style_id;
    (is_warning ? mark.begin_utc : mark.when_utc) = xml_time(start + note.time);
    mark.geometry = point(note.place);
    marks.push_back({note.time, std::move(mark)});
  }
  return marks;
}

}  // namespace lsos
