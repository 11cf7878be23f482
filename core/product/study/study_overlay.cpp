#include "product/study/study_overlay.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/quantity.h"
#include "plan/kml_writer.h"
#include "planet/meridian.h"
#include "product/balloon.h"
#include "product/overlay_marks.h"
#include "product/overlay_style.h"
#include "product/quantity_text.h"
#include "product/study/case_courses.h"

namespace lsos {

namespace {

constexpr std::size_t times_max = 60;    // at which a rover has an ellipse
constexpr std::size_t track_max = 1000;  // places of a moving icon
constexpr std::size_t ends_max = 2000;   // marks of missions that ended badly
constexpr const char* band_schema_id = "lsos_study_track";
constexpr std::array plotted{"charge", "distance_m"};  // along the track, each as a band

// What the Placemarks of all rovers are made of.
struct StudyMarks {
  const StudyPageRequest& request;
  const StudyResults& results;
  const CaseCourses& courses;
  const SiteFrame& site;

  Instant start() const { return request.plan.mission.start_time; }
};

KmlSchema band_schema() {
  KmlSchema schema{band_schema_id, band_schema_id, {}};
  for (const char* quantity : plotted) {
    for (const char* band : {"p5", "p50", "p95"}) {
      schema.array_fields.push_back({fmt::format("{}_{}", quantity, band), "float", ""});
    }
  }
  return schema;
}

// An ellipse as a closed line, on the ground.
std::vector<Geodetic> ring(const SpreadEllipse& ellipse, const SiteFrame& site) {
  constexpr int corners = 48;
  const double cos = std::cos(ellipse.angle_rad), sin = std::sin(ellipse.angle_rad);
  std::vector<Geodetic> places;
  for (int k = 0; k <= corners; ++k) {
    const double turn = 2 * std::numbers::pi * k / corners;
    const double along_m = ellipse.semi_major_m * std::cos(turn);
    const double across_m = ellipse.semi_minor_m * std::sin(turn);
    const Vec2 p_m =
        ellipse.centre_m + Vec2(along_m * cos - across_m * sin, along_m * sin + across_m * cos);
    places.push_back(site.geodetic({p_m.x(), p_m.y(), 0}));
    places.back().height_m = 0;
  }
  return unwrapped_longitudes(std::move(places));
}

std::vector<Geodetic> median_course(const StudyBand& lon, const StudyBand& lat,
                                    const std::vector<std::size_t>& times) {
  std::vector<Geodetic> places;
  for (const std::size_t k : times) {
    places.push_back(geodetic_from_degrees(lon.p50[k], lat.p50[k]));
  }
  return places;
}

// Indices of the times that a track shows: not all of many, and none that a viewer cannot show.
std::vector<std::size_t> track_times(const StudyBand& band, Instant start) {
  const std::size_t stride = 1 + band.times_s.size() / track_max;
  std::vector<std::size_t> times;
  for (std::size_t k = 0; k < band.times_s.size(); k += stride) {
    if (!xml_time(start + from_seconds(band.times_s[k])).empty()) times.push_back(k);
  }
  return times;
}

// The median course, and the bands along it as a viewer plots them.
std::vector<KmlPlacemark> courses_of(const StudyMarks& marks, const std::string& rover_id,
                                     const RoverStyle& style) {
  const StudyBand* lon = marks.results.band(rover_id, "lon_deg");
  const StudyBand* lat = marks.results.band(rover_id, "lat_deg");
  if (lon == nullptr || lat == nullptr || lon->times_s.size() < 2) return {};
  const std::vector<std::size_t> times = track_times(*lon, marks.start());
  KmlPlacemark line;
  line.name = rover_id + " median course";
  line.style_id = style.driven_id;
  line.geometry = {KmlGeometryKind::line, unwrapped_longitudes(median_course(*lon, *lat, times))};
  KmlPlacemark track;
  track.name = rover_id + " (median of places)";
  track.style_id = style.track_id;
  track.schema_id = band_schema_id;
  track.track.points = median_course(*lon, *lat, times);
  for (const std::size_t k : times) {
    track.track.when_utc.push_back(xml_time(marks.start() + from_seconds(lon->times_s[k])));
  }
  for (const char* quantity : plotted) {
    const StudyBand* band = marks.results.band(rover_id, quantity);
    if (band == nullptr || band->times_s.size() != lon->times_s.size()) continue;
    const std::pair<const char*, const std::vector<double>*> all[] = {
        {"p5", &band->p5}, {"p50", &band->p50}, {"p95", &band->p95}};
    for (const auto& [name, values] : all) {
      std::vector<std::string> texts;
      for (const std::size_t k : times) texts.push_back(fmt::format("{:.6g}", (*values)[k]));
      track.track.arrays.emplace_back(fmt::format("{}_{}", quantity, name), std::move(texts));
    }
  }
  return {std::move(line), std::move(track)};
}

// Ellipses that a time slider shows each in its turn.
std::vector<KmlPlacemark> spreads_of(const StudyMarks& marks, const RoverCourses& courses,
                                     const RoverStyle& style) {
  const std::size_t stride = 1 + courses.spreads.size() / times_max;
  std::vector<KmlPlacemark> found;
  for (std::size_t k = 0; k < courses.spreads.size(); k += stride) {
    const auto ellipse = courses.spreads[k].ellipse();
    if (!ellipse || !(ellipse->semi_major_m > 0)) continue;
    const auto at = [&](std::size_t step) {
      return xml_time(marks.start() +
                      from_seconds(static_cast<double>(step) * courses.spread_interval_s));
    };
    KmlPlacemark mark;
    mark.name = fmt::format("{} at {} s", courses.rover_id,
                            static_cast<double>(k) * courses.spread_interval_s);
    mark.description =
        fmt::format("{:.0f} % of {} cases lie in it: {:.3g} by {:.3g} m", 100 * spread_share,
                    ellipse->cases, 2 * ellipse->semi_major_m, 2 * ellipse->semi_minor_m);
    mark.style_id = style.planned_id;
    mark.begin_utc = at(k);
    mark.end_utc = at(k + stride);
    mark.geometry = {KmlGeometryKind::line, ring(*ellipse, marks.site)};
    found.push_back(std::move(mark));
  }
  return found;
}

std::string band_text(const char* name, const std::optional<BandValues>& band) {
  if (!band) return "";
  const auto text = [&](double value) {
    return std::string(name) == "charge" ? fmt::format("{:.3g} %", 100 * value)
                                         : quantity_text(name, value, 4);
  };
  return fmt::format("{} ({} to {})", text(band->p50), text(band->p5), text(band->p95));
}

std::string balloon_of(const StudyArrival& arrival, const std::optional<SpreadEllipse>& ellipse) {
  std::string html;
  const auto add = [&](const char* what, const std::string& text) {
    if (!text.empty()) html += fmt::format("<tr><td>{}<td>{}", what, html_text(text));
  };
  add("Event", fmt::format("{} {}/{}", arrival.type, arrival.rover_id, arrival.sequence));
  add("Completed",
      fmt::format("in {:.3g} % of {} cases", 100 * arrival.share_reached, arrival.cases));
  add("Ended, median (P5 to P95)", band_text("end_s", arrival.end_s));
  add("Charge then", band_text("charge", arrival.charge));
  if (ellipse) {
    add("Place", fmt::format("{:.0f} % of cases within {:.3g} by {:.3g} m", 100 * spread_share,
                             2 * ellipse->semi_major_m, 2 * ellipse->semi_minor_m));
  }
  return "<table>" + html + "</table>";
}

// Where events end: a mark by how many cases completed them, and the ellipse of most places.
std::vector<KmlPlacemark> arrival_marks(const StudyMarks& marks, const std::string& rover_id,
                                        const RoverStyle& style) {
  std::vector<KmlPlacemark> found;
  for (std::size_t i = 0; i < marks.results.arrivals.size(); ++i) {
    const StudyArrival& arrival = marks.results.arrivals[i];
    if (arrival.rover_id != rover_id) continue;
    const auto ellipse = marks.courses.events[i].spread.ellipse();
    if (!ellipse && !arrival.place) continue;
    KmlPlacemark mark;
    mark.name = fmt::format("{}: {:.3g} %", arrival.label, 100 * arrival.share_reached);
    mark.description = balloon_of(arrival, ellipse);
    mark.style_id = status_style_id(arrival.share_reached >= 1  ? EventStatus::completed
                                    : arrival.share_reached > 0 ? EventStatus::incomplete
                                                                : EventStatus::failed,
                                    true);
    Geodetic place = ellipse
                         ? marks.site.geodetic({ellipse->centre_m.x(), ellipse->centre_m.y(), 0})
                         : *arrival.place;
    place.height_m = 0;
    mark.geometry = {KmlGeometryKind::point, {place}};
    found.push_back(std::move(mark));
    if (!ellipse || !(ellipse->semi_major_m > 0)) continue;
    KmlPlacemark line;
    line.name = fmt::format("{} ({:.0f} % of cases)", arrival.label, 100 * spread_share);
    line.style_id = style.driven_id;
    line.geometry = {KmlGeometryKind::line, ring(*ellipse, marks.site)};
    found.push_back(std::move(line));
  }
  return found;
}

std::vector<KmlPlacemark> end_marks(const StudyMarks& marks, const std::string& rover_id) {
  std::vector<KmlPlacemark> found;
  for (const StudyEnd& end : marks.results.ends) {
    if (end.rover_id != rover_id || !end.place || found.size() == ends_max) continue;
    const EventStatus status = event_status(end.status).value_or(EventStatus::failed);
    KmlPlacemark mark;
    mark.name = fmt::format("case {}", end.number);
    mark.description = fmt::format("{} {}{}{}", html_text(end.label), end.status,
                                   end.reason.empty() ? "" : ": ", html_text(end.reason));
    mark.style_id = status_style_id(status, false);
    if (end.time_s) mark.begin_utc = xml_time(marks.start() + from_seconds(*end.time_s));
    mark.geometry = {KmlGeometryKind::point, {*end.place}};
    found.push_back(std::move(mark));
  }
  return found;
}

KmlFolder folder_of_placemarks(std::string name, std::vector<KmlPlacemark> placemarks) {
  KmlFolder folder;
  folder.name = std::move(name);
  folder.placemarks = std::move(placemarks);
  return folder;
}

std::vector<KmlPlacemark> drawn_of(const StudyMarks& marks, const std::string& rover_id,
                                   const RoverStyle& style) {
  std::vector<KmlPlacemark> found;
  for (OverlayMark& mark : drawn_lines(marks.request.plan, rover_id, style)) {
    found.push_back(std::move(mark.placemark));
  }
  return found;
}

void add_styles(KmlDocument& document) {
  for (const EventStatus status : {EventStatus::completed, EventStatus::failed,
                                   EventStatus::incomplete, EventStatus::not_started}) {
    for (const bool has_label : {true, false}) {
      document.styles.push_back(status_style(status, has_label, server_icon));
    }
  }
}

}  // namespace

std::string study_overlay(const StudyPageRequest& request) {
  const StudyResults results = read_study_results(request.folder);
  const SiteFrame site = study_site(request);
  CourseLimits limits;
  limits.cases = 0;
  const CaseCourses courses = read_courses(request.folder, results, site, limits);
  const StudyMarks marks{request, results, courses, site};
  KmlDocument document;
  document.name = fmt::format("{}, a study", request.name);
  document.description =
      fmt::format("{} {} cases; times are from {}{}", html_text(request.doc), results.cases.size(),
                  format_utc(marks.start()), request.has_one_start ? "" : ", though starts vary");
  document.target = target_of(*request.plan.mission.planet);
  document.schemas = {band_schema()};
  add_styles(document);
  std::vector<Geodetic> places;
  std::size_t i = 0;
  for (const PlanRover& rover : request.plan.rovers) {
    const RoverStyle style(i++);
    style.add_to(document.styles, server_icon);
    places.push_back(rover.start);
    for (const StudyArrival& arrival : results.arrivals) {
      if (arrival.rover_id == rover.id && arrival.place) places.push_back(*arrival.place);
    }
    KmlFolder folder = folder_of_placemarks(rover.id, {});
    folder.open = true;
    folder.folders.push_back(
        folder_of_placemarks(rover.id + " plan", drawn_of(marks, rover.id, style)));
    folder.folders.push_back(
        folder_of_placemarks(rover.id + " courses", courses_of(marks, rover.id, style)));
    for (const RoverCourses& of : courses.rovers) {
      if (of.rover_id != rover.id) continue;
      folder.folders.push_back(
          folder_of_placemarks(rover.id + " places in time", spreads_of(marks, of, style)));
    }
    folder.folders.push_back(
        folder_of_placemarks(rover.id + " events", arrival_marks(marks, rover.id, style)));
    folder.folders.push_back(
        folder_of_placemarks(rover.id + " ended badly", end_marks(marks, rover.id)));
    document.folders.push_back(std::move(folder));
  }
  document.look_at = look_at(*request.plan.mission.planet, places);
  return write_kml(document);
}

}  // namespace lsos
