#include "product/study/study_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "product/packed_numbers.h"
#include "product/report_document.h"
#include "product/report_map.h"
#include "product/report_page.h"
#include "product/study/study_json.h"
#include "study/proportion.h"

namespace lsos {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

double end_of(const StudyResults& results) {
  double end_s = 0;
  for (const StudyBand& band : results.bands) {
    if (!band.times_s.empty()) end_s = std::max(end_s, band.times_s.back());
  }
  for (const StudyArrival& arrival : results.arrivals) {
    if (arrival.end_s) end_s = std::max(end_s, arrival.end_s->p95);
  }
  return end_s;
}

// A rover at the medians of its longitude and latitude: what the page's map moves along.
ReportRover median_rover(const std::string& id, const std::string& type, std::size_t place,
                         const StudyResults& results, const SiteFrame& site) {
  const StudyBand* lon = results.band(id, "lon_deg");
  const StudyBand* lat = results.band(id, "lat_deg");
  const std::size_t count = lon == nullptr || lat == nullptr ? 0 : lon->times_s.size();
  ReportScope scope;
  scope.quantities.clear();
  ReportRover rover(id, {count, 0, 0}, scope);
  rover.type = type;
  rover.colour = web_colour(place);
  constexpr std::size_t places_max = 1000;
  const std::size_t stride = 1 + count / places_max;
  double heading_rad = 0;
  Vec2 last_m(not_modelled, not_modelled);
  for (std::size_t k = 0; k < count; k += stride) {
    const Vec3 p_S_m =
        site.p_S_m(geodetic_from_degrees(lon->p50[k], lat->p50[k], site.origin().height_m));
    const Vec2 step_m = Vec2(p_S_m.x(), p_S_m.y()) - last_m;
    constexpr double still_m = 0.01;
    if (step_m.allFinite() && step_m.norm() > still_m) {
      heading_rad = std::atan2(step_m.x(), step_m.y());
    }
    last_m = {p_S_m.x(), p_S_m.y()};
    rover.position.add(lon->times_s[k],
                       std::array{p_S_m.x(), p_S_m.y(), lon->p50[k], lat->p50[k], heading_rad});
  }
  rover.position.finish();
  rover.last_s = count == 0 ? 0 : lon->times_s.back();
  return rover;
}

ReportData data_of(const StudyPageRequest& request, const StudyResults& results,
                   const SiteFrame& site) {
  ReportData data;
  data.start = request.plan.mission.start_time;
  data.end_s = end_of(results);
  data.activities = request.plan.activities;
  for (const PlanRover& planned : request.plan.rovers) {
    data.rovers.push_back(
        median_rover(planned.id, planned.type, data.rovers.size(), results, site));
  }
  add_drawn(request.plan, site, data);
  return data;
}

// Corners of all that the map must hold besides: where the cases were.
ReportLine bounds_line(const CaseCourses& courses) {
  ReportLine bounds;
  for (const RoverCourses& of : courses.rovers) {
    for (std::size_t k = 0; k < of.x_m.size(); ++k) {
      if (std::isfinite(of.x_m[k])) bounds.push_back({of.x_m[k], of.y_m[k]});
    }
  }
  return bounds;
}

// What of each case can be opened, relative to the page; "" where nothing is there.
Json files_of(const std::string& folder, const std::vector<std::int64_t>& numbers,
              std::size_t shown) {
  Json files = Json::array();
  for (std::size_t i = 0; i < shown; ++i) {
    std::string found;
    for (const char* name : {"report.html", "plan.kml"}) {
      if (found.empty() && fs::exists(case_folder(folder, numbers[i]) + "/" + name)) found = name;
    }
    files.push_back(found);
  }
  return files;
}

// How many cases there are of each kind.
Json counts_json(const StudyPageRequest& request, const StudyResults& results) {
  std::size_t completed = 0, not_run = 0;
  for (const std::string& status : results.texts(results.column("status"))) {
    completed += status == "completed" ? 1 : 0;
    not_run += status == not_run_status ? 1 : 0;
  }
  const std::size_t run = results.cases.size() - not_run;
  const ShareInterval interval = share_interval(completed, run);
  return {{"wanted", request.cases},
          {"gathered", results.cases.size()},
          {"run", run},
          {"completed", completed},
          {"not_run", not_run},
          {"completed_low", interval.low},
          {"completed_high", interval.high}};
}

Json study_json(const StudyPageRequest& request, const StudyResults& results,
                const CaseCourses& courses, const std::vector<std::int64_t>& numbers_of_cases,
                const SiteFrame& site) {
  const std::size_t shown = std::min(results.cases.size(), study_page_cases_max);
  const std::vector<StudyNumber> numbers = study_numbers(results);
  const Influence found = influence(results, numbers, request.is_independent);
  Json parameters = Json::array();
  for (const std::size_t column : found.parameters) {
    parameters.push_back(results.columns[column].name);
  }
  return {{"name", request.name},
          {"doc", request.doc},
          {"sampling", request.sampling},
          {"seed", request.seed},
          {"has_one_start", request.has_one_start},
          {"stopped", request.stopped},
          {"counts", counts_json(request, results)},
          {"shown", shown},
          {"columns", table_json(results, shown)},
          {"files", files_of(request.folder, numbers_of_cases, shown)},
          {"outcomes", outcomes_json(results)},
          {"bands", bands_json(results)},
          {"arrivals", arrivals_json(results, courses, site)},
          {"ends", ends_json(results, site)},
          {"courses", courses_json(courses)},
          {"spread_share", spread_share},
          {"numbers", numbers_json(results, numbers)},
          {"parameters", parameters},
          {"influence", influence_json(found)},
          {"has_shares", request.is_independent},
          {"significance_cases_min", significance_cases_min},
          {"first_order_cases_min", first_order_cases_min},
          {"false_rate", false_rate}};
}

}  // namespace

SiteFrame study_site(const StudyPageRequest& request) {
  if (request.ground) return request.ground->site();
  return SiteFrame(*request.plan.mission.planet, site_of(request.plan));
}

Json study_document(const StudyPageRequest& request) {
  const StudyResults results = read_study_results(request.folder);
  const SiteFrame site = study_site(request);
  CourseLimits limits;
  limits.cases = study_page_cases_max;
  const CaseCourses courses = read_courses(request.folder, results, site, limits);
  const ReportData data = data_of(request, results, site);
  ReportExtras extras;
  extras.left_out = request.left_out;
  if (request.ground) {
    const auto shadow_at = request.has_one_start ? std::optional(SimTime{}) : std::nullopt;
    extras.map =
        report_map(*request.ground, data, shadow_at, request.threads, bounds_line(courses));
  }
  Json document = report_document(data, request.plan, site, "", extras);
  document["study"] = study_json(request, results, courses, results.case_numbers(), site);
  return document;
}

std::string study_page(const StudyPageRequest& request) {
  return report_page(study_document(request), PageKind::study);
}

}  // namespace lsos
