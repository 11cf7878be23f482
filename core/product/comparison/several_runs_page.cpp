#include "product/comparison/several_runs_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "base/error.h"
#include "product/comparison/several_runs.h"
#include "product/comparison/several_runs_text.h"
#include "product/report_document.h"
#include "product/report_map.h"
#include "product/report_page.h"

namespace lsos {

namespace {

using Json = nlohmann::ordered_json;

// What is kept of one run: eleven runs are then about as large as the page of one with its
// pictures.
constexpr int stretches = 300;
constexpr std::size_t places_max = 1500;

// Dashes of the lines of a run's second rover, third, ...; the first one's are whole.
const std::array<Json, 4> dashes{Json(nullptr), Json::array({6, 3}), Json::array({2, 3}),
                                 Json::array({9, 3, 2, 3})};

bool is_same_place(const Geodetic& a, const Geodetic& b) {
  return a.lon_rad == b.lon_rad && a.lat_rad == b.lat_rad && a.height_m == b.height_m;
}

// The runs' data, and how many rovers and events of it belong to each run.
struct Merged {
  ReportData data;
  std::vector<std::size_t> rovers, events;
};

bool is_same_line(const ReportLine& a, const ReportLine& b) {
  return std::ranges::equal(a, b, [](const ReportPoint& p, const ReportPoint& q) {
    return p.x_m == q.x_m && p.y_m == q.y_m;
  });
}

// What all runs drew alike is drawn once: half transparent lines would hide the ground.
void leave_out_drawn_twice(ReportRover& rover, const std::vector<ReportRover>& before) {
  for (const ReportRover& other : before) {
    if (other.id != rover.id) continue;
    std::erase_if(rover.drawn, [&](const ReportLine& line) {
      return std::ranges::any_of(
          other.drawn, [&](const ReportLine& drawn) { return is_same_line(line, drawn); });
    });
  }
}

Merged merged(const std::vector<RunOfPage>& runs, const SiteFrame& site) {
  Merged all;
  const SiteFrame first_site = site_of(*runs.front().log, runs.front().opened.files.plan);
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const Plan& plan = runs[k].opened.files.plan;
    const SiteFrame log_site = site_of(*runs[k].log, plan);
    ReportScope scope;
    scope.stretches = stretches;
    scope.places_max = places_max;
    // Runs that begin elsewhere log another frame.
    if (!is_same_place(log_site.origin(), first_site.origin())) scope.log_site = &log_site;
    ReportData data = read_report_data(*runs[k].log, plan, site, scope);
    all.rovers.push_back(data.rovers.size());
    all.events.push_back(data.events.size());
    for (ReportRover& rover : data.rovers) {
      rover.colour = run_colour(k);
      leave_out_drawn_twice(rover, all.data.rovers);
    }
    if (k == 0) {
      all.data = std::move(data);
      // These are of one run alone, which has a page of its own.
      all.data.pairs.clear();
      all.data.distances.clear();
      all.data.notes = {};
      continue;
    }
    all.data.end_s = std::max(all.data.end_s, data.end_s);
    std::ranges::move(data.rovers, std::back_inserter(all.data.rovers));
    std::ranges::move(data.events, std::back_inserter(all.data.events));
    all.data.activities.merge(data.activities);
  }
  return all;
}

// Each rover and event of the document gets the index of its run.
void mark_runs(Json& array, const std::vector<std::size_t>& counts) {
  std::size_t at = 0;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    for (std::size_t i = 0; i < counts[k]; ++i) array[at++]["run"] = k;
  }
}

// Names in the keys of plots: "B", or "B SEV1" where there are several rovers.
void name_rovers(Json& rovers) {
  std::set<std::string> ids;
  for (const Json& rover : rovers) ids.insert(rover.at("id").get<std::string>());
  for (Json& rover : rovers) {
    const auto id = rover.at("id").get<std::string>();
    const std::string run = run_name(rover.at("run").get<std::size_t>());
    const auto place = static_cast<std::size_t>(std::distance(ids.begin(), ids.find(id)));
    rover["name"] = ids.size() > 1 ? fmt::format("{} {}", run, id) : run;
    rover["dash"] = dashes[place % dashes.size()];
  }
}

ComparedRun compared_run(const RunOfPage& run) {
  return {run.summary, run.log->run(), run.summary.empty() ? "" : run.log->sha256()};
}

// `first`: the first run, as it is compared with others.
Json run_json(const RunOfPage& run, std::size_t k, const ComparedRun& first) {
  Json summary = Json::parse(run.summary, nullptr, false);
  const bool is_finished = summary.is_object();
  Json json = {{"name", run_name(k)},
               {"folder", run.folder},
               {"colour", run_colour(k)},
               {"plan", run.opened.files.plan.file},
               {"start_utc", format_utc(run.log->start())},
               {"end_s", seconds(run.log->last_sample_time())},
               {"status", is_finished ? summary.at("status") : Json()},
               {"log_sha256", is_finished ? summary.at("log_sha256") : Json()},
               {"totals", is_finished ? summary.at("rovers") : Json()},
               {"made_of", run.log->run()},
               {"is_equal", false},
               {"has_equal_log", false}};
  if (k > 0 && is_finished && !first.summary.empty()) {
    const Comparison found = compare(first, compared_run(run));
    json["is_equal"] = found.is_equal();
    json["has_equal_log"] = found.has_equal_logs();
  }
  return json;
}

void require_one_planet(const std::vector<RunOfPage>& runs) {
  const auto planet = [](const RunOfPage& run) { return run.opened.files.plan.mission.planet; };
  Faults faults;
  for (const RunOfPage& run : runs) {
    if (planet(run)->id == planet(runs.front())->id) continue;
    faults.error({run.folder},
                 fmt::format("is a run on {}, {} one on {}: only runs on one planet "
                             "fit over each other",
                             planet(run)->name, runs.front().folder, planet(runs.front())->name));
  }
  faults.throw_if_errors();
}

}  // namespace

std::string several_runs_page(std::vector<RunOfPage> runs, const ReportRequest& request,
                              const std::vector<std::string>& left_out) {
  LSOS_ASSERT(!runs.empty() && runs.size() <= runs_max);
  require_one_planet(runs);
  for (RunOfPage& run : runs) {
    if (!is_summary(run.summary)) run.summary.clear();
  }
  const RunOfPage& first = runs.front();
  const std::shared_ptr<const Ground> ground = first.opened.ground;
  const Plan& plan = first.opened.files.plan;
  const SiteFrame site = ground ? ground->site() : site_of(*first.log, plan);
  const Merged all = merged(runs, site);
  ReportExtras extras;
  if (ground) extras.map = report_map(*ground, all.data, request.shadow_at, request.threads);
  extras.batteries = report_batteries(first.opened.files);
  extras.left_out = left_out;
  Json document = report_document(all.data, plan, site, first.summary, extras);
  mark_runs(document["rovers"], all.rovers);
  mark_runs(document["events"], all.events);
  name_rovers(document["rovers"]);
  std::vector<RunOutcome> outcomes;
  document["runs"] = Json::array();
  const ComparedRun compared_first = compared_run(first);
  for (std::size_t k = 0; k < runs.size(); ++k) {
    document["runs"].push_back(run_json(runs[k], k, compared_first));
    outcomes.push_back({runs[k].folder, runs[k].log->events(), runs[k].summary});
  }
  document["differing_events"] = events_json(differing_events(outcomes));
  return report_page(document, PageKind::several_runs);
}

}  // namespace lsos
