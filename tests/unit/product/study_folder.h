// A study's folder with invented cases, whose results follow from their parameters by closed forms.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "base/files.h"
#include "base/random.h"
#include "product/study/case_series.h"
#include "product/study/gather.h"
#include "product/study/study_page.h"
#include "unit/record/log_fixture.h"

namespace lsos {

// What ends a <script>, and what XML and HTML take for their own.
inline const std::string hostile = "</script><b>'\"&";

// Normally distributed, by Box and Muller.
inline double normal(RandomStream& random) {
  const double radius = std::sqrt(-2 * std::log(1 - random.uniform()));
  return radius * std::cos(2 * 3.14159265358979323846 * random.uniform());
}

// Two rovers near a place of the Moon, without terrain. Speeds are uniform in 1..2 m/s; a rover
// drives straight east for 600 s, from a place that is normally distributed: 20 m east, 5 m north.
// Every tenth case fails at 300 s.
class StudyFolder {
 public:
  explicit StudyFolder(std::int64_t cases, int events = 2) : cases_(cases), events_(events) {
    std::filesystem::create_directories(folder / "cases");
    plan_.file = plan_.home = "plans/traverse.kml";
    plan_.mission.planet = find_body("Moon");
    plan_.mission.start_time = test_start();
    plan_.rovers.resize(1);
    plan_.rovers[0].id = "SEV1";
    plan_.rovers[0].type = "SEV";
    plan_.rovers[0].start = start();
    RandomStream random(5);
    for (std::int64_t number = 1; number <= cases; ++number) write_case(number, random);
    gather(gather_request());
  }

  static Geodetic start() { return geodetic_from_degrees(-27, -2); }

  StudyPageRequest request() const {
    StudyPageRequest request;
    request.folder = folder.path();
    request.name = "traverse_study " + hostile;
    request.doc = "How far it goes " + hostile + ".";
    request.sampling = "random";
    request.seed = 5;
    request.cases = cases_;
    request.plan = plan_;
    return request;
  }

  TestFolder folder;
  std::vector<double> speeds_mps, least_charges;
  std::vector<Vec2> ends_m;  // of the first event, from the start

 private:
  static constexpr double metres_per_degree = 1737400 * 3.14159265358979323846 / 180;
  static Geodetic place(const Vec2& east_north_m) {
    const double lat_deg = -2 + east_north_m.y() / metres_per_degree;
    const double cos = std::cos(2 * 3.14159265358979323846 / 180);
    return geodetic_from_degrees(-27 + east_north_m.x() / (metres_per_degree * cos), lat_deg);
  }

  GatherRequest gather_request() const {
    using Kind = StudyColumn::Kind;
    GatherRequest request;
    request.folder = folder.path();
    request.crs = moon_crs;
    request.cases = cases_;
    request.rovers = {"SEV1"};
    for (int k = 1; k <= events_; ++k) {
      request.events.push_back({"SEV1", 10 * k, "Route", event_label(k), place({600, 0})});
    }
    request.parameters = {{"SEV1/10.Speed", Kind::parameter, "SEV1/10.Speed", "m/s", "Speed."},
                          {"Noise", Kind::parameter, "Noise", "", "Moves nothing."},
                          {"Soil", Kind::parameter, "Soil", "", "By name.", ColumnType::text},
                          {"MissionInfo.StartTime", Kind::parameter, "MissionInfo.StartTime", "s",
                           "Later by the speed.", ColumnType::text}};
    request.gathered = {{"least charge", Kind::gathered, "SEV1", "", "Least charge."}};
    return request;
  }

  static std::string event_label(int k) {
    return k == 1 ? "Leg 1 " + hostile : "Leg " + std::to_string(k);
  }

  void write_case(std::int64_t number, RandomStream& random) {
    const bool is_failed = number % 10 == 0;
    const double speed_mps = 1 + random.uniform();
    const double least_charge = 1 - 0.3 * speed_mps;
    const Vec2 offset_m(20 * normal(random), 5 * normal(random));
    const Vec2 end_m = offset_m + Vec2(1000, 0);
    const std::string of_case = case_folder(folder.path(), number);
    std::filesystem::create_directories(of_case);
    const double end_s = is_failed ? 300 : 600;
    CaseRecord record;
    record.number = number;
    record.values = {
        {"SEV1/10.Speed", speed_mps},
        {"Noise", random.uniform()},
        {"Soil", std::string(number % 2 == 0 ? "Sand" : "Duricrust")},
        {"MissionInfo.StartTime", format_utc(test_start() + from_seconds(1e5 * speed_mps))}};
    record.gathered = {{"least charge", least_charge}};
    record.status = is_failed ? "failed" : "completed";
    record.reason = is_failed ? "SEV1/20 'Leg 2' failed: stuck " + hostile : "";
    for (int k = 1; k <= events_; ++k) {
      const bool is_bad = is_failed && k > 1;
      record.events.push_back({"SEV1", 10 * k, is_bad ? "failed" : "completed",
                               is_bad ? "stuck " + hostile : "", is_bad ? 300 : 100.0 * k,
                               least_charge, place(end_m)});
    }
    record.log_sha256 = std::string(64, 'a');
    record.sim_s = end_s;
    record.wall_s = record.cpu_s = 1;
    write_file(of_case + "/" + case_file, to_json(record));
    write_file(of_case + "/plan.kml", "<kml/>");
    write_file(of_case + "/summary.json",
               R"({"rovers": {"SEV1": {"distance_m": )" + std::to_string(end_s * speed_mps) +
                   R"(, "energy_end_j": )" + std::to_string(3.6e6 * least_charge) + "}}}");
    SeriesRecorder series(5, {"SEV1"});
    for (double time_s = 0; time_s <= end_s; time_s += 5) {
      SampleRow row;
      row.time = from_seconds(time_s);
      row.rover_id = "SEV1";
      row.charge = 1 - (1 - least_charge) * time_s / end_s;
      row.distance_m = speed_mps * time_s;
      row.place = place(offset_m + Vec2(speed_mps * time_s, 0));
      series.add(row);
    }
    write_file(of_case + "/" + series_file, series.bytes());
    speeds_mps.push_back(speed_mps);
    least_charges.push_back(least_charge);
    ends_m.push_back(end_m);
  }

  std::int64_t cases_;
  int events_;
  Plan plan_;
};

}  // namespace lsos
