// The shipped plans of weeks, each run once: what they are there to show, in the log and in what a
// planner looks at.
#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "system/golden.h"
#include "system/run_folder.h"
#include "system/source_files.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;

constexpr double megabyte = 1e6;

struct LongRun {
  TempFolder folder;
  Outcome outcome;
  fs::path log() const { return fs::path(folder / "run") / "log.gpkg"; }
  double number(const std::string& sql) const { return std::stod(query(log(), sql)); }
};

void run_plan(LongRun& of, const std::string& plan) {
  of.outcome = run({repository() / "plans" / plan, "-o", of.folder / "run", "--quiet"});
}

void expect_sound(const LongRun& of) {
  EXPECT_EQ(of.outcome.exit_code, 0) << of.outcome.out << of.outcome.err;
  EXPECT_EQ(query(of.log(), "select count(*) from events where status <> 'completed'"), "0")
      << "every event ends, and none is skipped";
  EXPECT_EQ(query(of.log(), "select count(*) from samples where charge < 0.2"), "0")
      << "no battery comes near its reserve";
  // What flows in and out of a battery is what it holds more or less at the end.
  EXPECT_LT(of.number("select max(abs(last.energy_j - first.energy_j - (last.solar_j + "
                      "last.external_j - last.load_j - last.drive_j - last.loss_j)) / last.load_j) "
                      "from samples last join samples first using (rover_id) where first.time_s = "
                      "0 and last.time_s = (select max(time_s) from samples s where s.rover_id = "
                      "last.rover_id)"),
            1e-6);
  EXPECT_LT(static_cast<double>(fs::file_size(of.folder / "run/overlay.kml")), 20 * megabyte);
  EXPECT_LT(static_cast<double>(fs::file_size(of.folder / "run/report.html")), 10 * megabyte);
}

TEST(LongPlan, two_weeks_in_arizona) {
  LongRun of;
  run_plan(of, "drats.kml");
  expect_sound(of);
  // Samples begin at 08:00 local time; 22:00 to 04:00 is 14 to 20 hours later.
  EXPECT_EQ(query(of.log(),
                  "select count(*) from samples where solar_w > 0 and cast(time_s as int) % 86400 "
                  "between 14 * 3600 and 20 * 3600"),
            "0")
      << "there is no sunlight at night";
  EXPECT_GT(of.number("select min(d) from (select max(distance_m) d from samples group by "
                      "rover_id)"),
            35e3)
      << "several kilometres a day";
  EXPECT_EQ(query(of.log(), "select count(*) from events where type = 'Rendezvous'"), "2");
  EXPECT_LT(of.number("select max(p.distance_m) from pairs p join events e on p.time_s = "
                      "(select min(time_s) from pairs where from_id = 'A' and to_id = 'B' and "
                      "time_s >= e.end_s) where e.type = 'Rendezvous' and p.from_id = 'A' and "
                      "p.to_id = 'B'"),
            45)
      << "they meet";
  EXPECT_TRUE(summary(of.folder / "run")["warnings"].empty());
  expect_golden("drats.kml", of.log());
}

// Elevation of Earth at noon of each day of the campaign, above the habitat, by the command `sun`.
std::vector<double> earth_elevations_deg(int days) {
  std::string times;
  for (int day = 1; day <= days; ++day) {
    times += (times.empty() ? "2027-01-" : ",2027-01-") + std::string(day < 10 ? "0" : "") +
             std::to_string(day) + "T18:00:00Z";
  }
  const Outcome outcome = run({"sun", "--planet", "Moon", "--site", "46.3,-89.843", "--at", times});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  std::vector<double> elevations_deg;
  for (const nlohmann::json& at : nlohmann::json::parse(outcome.out)) {
    elevations_deg.push_back(at["earth_elevation_deg"]);
  }
  return elevations_deg;
}

TEST(LongPlan, four_weeks_at_the_pole) {
  LongRun of;
  run_plan(of, "lunar_campaign.kml");
  expect_sound(of);
  EXPECT_GT(of.number("select min(d) from (select max(distance_m) d from samples where rover_id "
                      "like 'SEV%' group by rover_id)"),
            100e3);
  // Earth is hidden while it is 2 degrees or more below the horizon, and seen from some rover on
  // each day on which it stands 2 degrees above.
  const std::vector<double> earth_deg = earth_elevations_deg(28);
  for (std::size_t day = 0; day < earth_deg.size(); ++day) {
    const std::string from_s = std::to_string(86400 * day),
                      to_s = std::to_string(86400 * (day + 1));
    const double seen = of.number(
        "select max(visible) from pairs where to_id = 'Earth' and time_s "
        "between " +
        from_s + " and " + to_s);
    if (std::abs(earth_deg[day]) < 2) continue;
    EXPECT_EQ(seen, earth_deg[day] > 0 ? 1 : 0) << "day " << day + 1;
  }
  EXPECT_EQ(query(of.log(),
                  "select group_concat(label) from (select label from events where type "
                  "= 'Rendezvous' order by end_s)"),
            "Meeting, day 7,Meeting, day 14,Meeting, day 21,Meeting, day 28");
  EXPECT_TRUE(summary(of.folder / "run")["warnings"].empty());
  expect_golden("lunar_campaign.kml", of.log());
}

}  // namespace
}  // namespace lsos::test
