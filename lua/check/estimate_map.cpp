#include "lua/check/estimate_map.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/sim_time.h"
#include "product/balloon.h"
#include "product/overlay_icons.h"
#include "product/rover_track.h"

namespace lsos {

namespace {

// Colours that differ also for the colour-blind (Okabe and Ito, 2008), as alpha, blue, green, red.
struct Outcome {
  const char* id;
  const char* color_abgr;
  double line_width;
  OverlayIcon icon;
};
constexpr Outcome plenty{"lsos-charge-60", "ff739e00", 4, OverlayIcon::disc};
constexpr Outcome some{"lsos-charge-30", "ff42e4f0", 4, OverlayIcon::disc};
constexpr Outcome little{"lsos-charge-0", "ff005ed5", 4, OverlayIcon::disc};
constexpr Outcome unpowered{"lsos-no-charge", "ff969696", 4, OverlayIcon::disc};
constexpr Outcome failing{"lsos-fails", "ff1c19d7", 6, OverlayIcon::cross};
constexpr Outcome outcomes[] = {plenty, some, little, unpowered, failing};

const Outcome& outcome_of(const EventEstimate& event) {
  const bool is_cut_off = event.status == EventStatus::incomplete;
  if (is_cut_off || event.status == EventStatus::failed) return failing;
  if (!event.charge_end) return unpowered;
  return *event.charge_end >= 0.6 ? plenty : *event.charge_end >= 0.3 ? some : little;
}

std::string style_id(const Outcome& outcome, bool has_label) {
  return std::string(outcome.id) + (has_label ? "" : "-unlabelled");
}

KmlStyle style_of(const Outcome& outcome, bool has_label) {
  KmlStyle style;
  style.id = style_id(outcome, has_label);
  style.line_color_abgr = style.icon_color_abgr = outcome.color_abgr;
  style.line_width = outcome.line_width;
  style.icon_href = server_icon(outcome.icon);
  style.icon_scale = 0.7;
  style.label_scale = has_label ? 0.8 : 0;
  return style;
}

std::string utc(Instant start, double time_s) { return format_utc(start + from_seconds(time_s)); }

std::string label_of(const EventEstimate& event, const Plan& plan) {
  std::string label = plan.rovers.size() > 1 ? event.rover_id + " " : "";
  label += fmt::format("#{} {}", event.sequence, event.type);
  if (event.end_s) label += " " + utc(plan.mission.start_time, *event.end_s).substr(11, 5);
  if (event.charge_end) label += fmt::format(" {:.0f} %", 100 * *event.charge_end);
  if (event.status == EventStatus::incomplete) return label + " is cut off";
  return label + (event.status == EventStatus::failed ? " fails" : "");
}

// Paths that are planned, in the order of their waypoints.
std::map<PlanEvent::Reference, std::vector<Geodetic>> planned_lines(const Simulation& simulation) {
  std::map<PlanEvent::Reference, std::map<std::int64_t, const PlannedLeg*>> legs;
  for (const RoverRoutesAhead& routes : simulation.routes_ahead()) {
    for (const LegAhead& ahead : routes.legs) {
      if (ahead.leg.is_found())
        legs[{routes.rover_id, ahead.sequence}][ahead.waypoint] = &ahead.leg;
    }
  }
  std::map<PlanEvent::Reference, std::vector<Geodetic>> lines;
  for (const auto& [event, by_waypoint] : legs) {
    std::vector<Geodetic>& line = lines[event];
    for (const auto& [waypoint, leg] : by_waypoint) {
      for (const Vec3& p_S_m : leg->path_S_m) {
        line.push_back(simulation.ground().site().geodetic(p_S_m));
      }
    }
    line = simplified_line(*simulation.plan().mission.planet, line);
  }
  return lines;
}

// Whether the rover's next event ends where this one does.
bool has_later_here(const EventEstimate& event, const EventCourses& courses, const Plan& plan) {
  const auto next = std::next(courses.find({event.rover_id, event.sequence}));
  if (next == courses.end() || next->first.rover_id != event.rover_id) return false;
  const Geodetic& here = courses.at({event.rover_id, event.sequence}).end;
  constexpr double same_place_m = 1;
  return surface_distance_m(*plan.mission.planet, here, next->second.end) < same_place_m;
}

}  // namespace

EventCourses event_courses(const Simulation& simulation, const Declarations& declarations) {
  EventCourses courses;
  const auto planned = planned_lines(simulation);
  for (const FleetRover& rover : simulation.fleet().rovers) {
    Geodetic last = rover_of(simulation.plan(), rover.agent->id())->start;
    const std::vector<EventMachine>& events = rover.sequence.events();
    for (std::size_t i = 0; i < events.size(); ++i) {
      const EventRecord& record = rover.sequence.records().all()[i];
      const PlanEvent& event = events[i].event;
      if (!event.is_enabled || !record.start || !record.end) continue;
      EventCourse& course = courses[{event.rover_id, event.sequence}];
      course.end = record.place;
      const auto line = planned.find({event.rover_id, event.sequence});
      if (line != planned.end()) {
        course.line = line->second;
      } else if (declarations.events.at(event.type).drives && record.distance_m > 0) {
        course.line = {last};
        const bool is_drawn = event.geometry.kind != GeometryKind::polygon;
        if (is_drawn) {
          course.line.insert(course.line.end(), event.geometry.points.begin(),
                             event.geometry.points.end());
        }
        if (course.line.size() == 1) course.line.push_back(record.place);
      }
      last = record.place;
    }
  }
  return courses;
}

KmlDocument estimate_map(const Plan& plan, const MissionEstimate& estimate,
                         const EventCourses& courses, const std::string& notes) {
  KmlDocument document;
  for (const Outcome& outcome : outcomes) {
    for (const bool has_label : {true, false}) {
      document.styles.push_back(style_of(outcome, has_label));
    }
  }
  const Instant start = plan.mission.start_time;
  std::map<int, KmlFolder> days;
  for (const EventEstimate& event : estimate.events) {
    const auto course = courses.find({event.rover_id, event.sequence});
    if (course == courses.end() || !event.start_s || !event.end_s) continue;
    const int day = 1 + static_cast<int>(*event.end_s / day_length_s);
    KmlFolder& folder = days[day];
    if (folder.folders.empty()) {
      folder.name =
          fmt::format("Day {}, {}", day, utc(start, (day - 1) * day_length_s).substr(0, 10));
      folder.folders.emplace_back().name = "Lines by charge";
    }
    KmlPlacemark mark;
    mark.name = label_of(event, plan);
    mark.description = balloon(event, start);
    mark.style_id = outcome_of(event).id;
    mark.begin_utc = utc(start, *event.start_s);
    mark.end_utc = utc(start, *event.end_s);
    if (course->second.line.size() > 1) {
      KmlPlacemark line = mark;
      line.geometry = {KmlGeometryKind::line, course->second.line};
      folder.folders.front().placemarks.push_back(std::move(line));
    }
    // A label stays once it is reached, but those of one place would lie on each other.
    mark.style_id = style_id(outcome_of(event), !has_later_here(event, courses, plan));
    mark.begin_utc = mark.end_utc;
    mark.end_utc.clear();
    mark.geometry = {KmlGeometryKind::point, {course->second.end}};
    folder.placemarks.push_back(std::move(mark));
  }
  KmlFolder& all = document.folders.emplace_back();
  all.name = "Estimate";
  all.description = notes;
  for (auto& [day, folder] : days) {
    if (folder.folders.front().placemarks.empty()) folder.folders.clear();
    all.folders.push_back(std::move(folder));
  }
  return document;
}

}  // namespace lsos
