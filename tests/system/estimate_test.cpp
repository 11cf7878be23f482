// What `check` expects of each event, against what the simulation makes of it.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "system/plan_run.h"
#include "system/source_files.h"

namespace lsos::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

// The figures that core/mission/README.md states.
constexpr double end_within = 0.1, energy_within = 0.15, charge_within = 0.05;
// Energy of an event, J, below which a share of it says little.
constexpr double energy_least_j = 36e3;

json checked(const TempFolder& folder, const std::vector<Mark>& plan) {
  const Outcome outcome =
      run({"check", folder.write("checked.kml", kml(plan)), "--json", "--quiet"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  return json::parse(outcome.out);
}

struct Limits {
  double low = 0, high = 0;
};

Limits limits(const json& value) {
  if (value.is_number()) return {value, value};
  return {value.at("low"), value.at("high")};
}

double middle(const json& value) { return (limits(value).low + limits(value).high) / 2; }

// Charge of a rover at a time of the run.
double charge_at(const PlanRun& run, const std::string& rover_id, double time_s) {
  double charge = not_modelled;
  for (const SampleRow& sample : run.samples()) {
    if (sample.rover_id == rover_id && seconds(sample.time) <= time_s) charge = sample.charge;
  }
  return charge;
}

void expect_as_simulated(const std::vector<Mark>& plan) {
  const PlanRun run(plan);
  const json estimate = checked(run.folder, plan).at("estimate");
  const json events = run.summary().at("events");
  ASSERT_EQ(estimate.size(), events.size());
  for (std::size_t k = 0; k < events.size(); ++k) {
    const json &event = events[k], &expected = estimate[k];
    const std::string label = event.at("label");
    EXPECT_EQ(expected.at("label"), label);
    EXPECT_EQ(event.at("status"), "completed") << label;
    const double start_s = event.at("start_s"), end_s = event.at("end_s");
    EXPECT_NEAR(middle(expected.at("start_s")), start_s, end_within * start_s) << label;
    EXPECT_NEAR(middle(expected.at("end_s")), end_s, end_within * end_s) << label;
    const double distance_m = event.at("distance_m"), used_j = event.at("energy_used_j");
    EXPECT_NEAR(expected.at("distance_m").get<double>(), distance_m, 1 + 0.01 * distance_m)
        << label;
    EXPECT_NEAR(middle(expected.at("energy_used_j")), used_j,
                energy_within * std::max(energy_least_j, used_j))
        << label;
    const double charge = charge_at(run, event.at("rover_id"), end_s);
    EXPECT_NEAR(middle(expected.at("charge_end")), charge, charge_within) << label;
    EXPECT_LE(middle(expected.at("charge_min")), middle(expected.at("charge_end")));
  }
}

std::vector<Mark> a_day_out() {
  return {mission({{"LogInterval", "1"}}),
          sev("A", "31,12"),
          event("Route", "A", 1, {}, line("31.005,12 31.005,12.005 31.01,12.005")),
          event("EVA", "A", 2, {{"ActivityDuration", "1 h"}}),
          event("Recharge", "A", 3, {{"EnergyRate", "2 kW"}, {"Duration", "30 min"}}),
          event("PathPlanRoute", "A", 4, {}, point("31,12")),
          event("StowSP", "A", 5),
          event("Pause", "A", 6, {{"Duration", "2 h"}})};
}

// Within 15 % although it is little: time in which limbs settle, and what their motors take.
TEST(Estimate, of_a_stance_has_the_work_of_the_limbs) {
  const std::vector<Mark> plan = {
      mission({{"LogInterval", "1"}}),
      {"Rover", {{"RoverId", "A"}, {"RoverType", "ATHLETE"}}, point("31,12")},
      event("SetPosture", "A", 1, {{"Stance", "Stow"}}),
      event("SetPosture", "A", 2, {{"Stance", "Drive"}}),
      event("SetPosture", "A", 3, {{"Height", "0.6 m"}, {"Duration", "60 s"}})};
  const PlanRun run(plan);
  const json estimate = checked(run.folder, plan).at("estimate");
  const json events = run.summary().at("events");
  ASSERT_EQ(estimate.size(), 3u);
  for (std::size_t k = 0; k < events.size(); ++k) {
    const json &event = events[k], &expected = estimate[k];
    const double used_j = event.at("energy_used_j"), end_s = event.at("end_s");
    EXPECT_NEAR(middle(expected.at("energy_used_j")), used_j, energy_within * used_j) << k;
    EXPECT_NEAR(middle(expected.at("end_s")), end_s, 0.05 * end_s) << k;
  }
}

TEST(Estimate, of_times_energy_and_charge_is_near_what_is_simulated) {
  expect_as_simulated(a_day_out());
}

TEST(Estimate, of_rovers_that_wait_for_each_other_is_near_what_is_simulated) {
  expect_as_simulated(two_rovers());
}

TEST(Estimate, knows_whether_sun_and_earth_are_seen) {
  const TempFolder folder;
  const json estimate = checked(folder, a_day_out()).at("estimate");
  EXPECT_GT(middle(estimate[1].at("sunlit_share")), 0.9);
  EXPECT_EQ(middle(estimate[1].at("earth_visible_share")), 1);
  EXPECT_EQ(middle(estimate[5].at("sunlit_share")), 0);  // the panels are stowed
}

// Share of a time in which the Sun reaches the panel of the only rover, by the rows of a run: as if
// each held until the next, and as if each held since the one before.
Limits sunlit_between(const PlanRun& run, double begin_s, double end_s) {
  double held_s = 0, had_s = 0, last_s = 0;
  bool was_lit = false;
  for (const PanelRow& row : run.log().panels()) {
    const double time_s = seconds(row.time);
    const double passed_s = std::min(time_s, end_s) - std::max(last_s, begin_s);
    const bool is_lit = row.sun_fraction > 0 && row.incidence > 0;
    if (passed_s > 0 && was_lit) held_s += passed_s;
    if (passed_s > 0 && is_lit) had_s += passed_s;
    last_s = time_s;
    was_lit = is_lit;
  }
  const auto [low_s, high_s] = std::minmax(held_s, had_s);
  const double all_s = end_s - begin_s;
  return {low_s / all_s, high_s / all_s};
}

TEST(Estimate, follows_panels_while_they_turn) {
  const auto turned_north = [](int sequence) {
    return event("SteerSP", "A", sequence,
                 {{"Mode", "point"}, {"Azimuth", "0"}, {"Elevation", "0"}});
  };
  const std::vector<Mark> plan{
      mission({{"LogInterval", "1"}, {"ParkedLogInterval", "1"}}),
      Mark{"Rover",
           {{"RoverId", "A"}, {"RoverType", "SEV"}, {"InitialCharge", "0.5"}},
           point("31,12")},
      turned_north(1), event("SteerSP", "A", 2, {{"Mode", "track"}}), turned_north(3)};
  const PlanRun run(plan);
  const json estimate = checked(run.folder, plan).at("estimate");
  const json events = run.summary().at("events");
  for (const std::size_t k : {std::size_t{1}, std::size_t{2}}) {
    const double solar_j = events[k].at("solar_j");
    EXPECT_GT(events[k].at("end_s").get<double>() - events[k].at("start_s").get<double>(), 40);
    EXPECT_NEAR(middle(estimate[k].at("solar_j")), solar_j, 0.1 * solar_j) << k;
    const Limits lit = sunlit_between(run, events[k].at("start_s"), events[k].at("end_s"));
    const Limits expected = limits(estimate[k].at("sunlit_share"));
    EXPECT_LT(expected.high - expected.low, 0.15) << k;
    // Nothing is known of the time between two rows of the log.
    EXPECT_LE(expected.low, lit.high) << k;
    EXPECT_GE(expected.high, lit.low) << k;
  }
}

TEST(Estimate, of_a_drive_behind_another_rover_ends_behind_it) {
  const TempFolder folder;
  const json estimate =
      checked(folder, {mission(), sev("A", "31,12"), sev("B", "30.999,12"),
                       event("Route", "A", 1, {}, point("31.01,12")),
                       event("Follow", "B", 1, {{"Leader", "A"}, {"Distance", "20"}})})
          .at("estimate");
  const double ahead_m = estimate[0].at("distance_m"), behind_m = estimate[1].at("distance_m");
  // B begins 29.7 m behind A, and ends 20 m behind it.
  EXPECT_NEAR(behind_m, ahead_m + 9.7, 2);
  EXPECT_NEAR(middle(estimate[1].at("end_s")), middle(estimate[0].at("end_s")), 1);
}

TEST(Estimate, warns_of_a_battery_that_does_not_last) {
  const TempFolder folder;
  const json answer =
      checked(folder, {mission(),
                       Mark{"Rover",
                            {{"RoverId", "A"}, {"RoverType", "SEV"}, {"InitialCharge", "0.2"}},
                            point("31,12")},
                       event("StowSP", "A", 1),
                       event("Consume", "A", 2, {{"Power", "20 kW"}, {"Duration", "3 h"}})});
  ASSERT_EQ(answer.at("faults").size(), 2) << answer.at("faults");
  EXPECT_THAT(answer["faults"][0]["what"].get<std::string>(), HasSubstr("its panels are stowed"));
  EXPECT_THAT(answer["faults"][1]["what"].get<std::string>(),
              HasSubstr("Consume 'Consume 2': by the estimate it fails at 2026-01-01T0"));
  EXPECT_TRUE(answer["is_valid"]);
}

TEST(Estimate, of_a_wait_for_a_condition_takes_no_time) {
  const TempFolder folder;
  const json estimate = checked(folder, {mission(), sev("A", "31,12"),
                                         event("Pause", "A", 1,
                                               {{"Duration", "300 d"},
                                                {"StopWhen", "time_s &gt; 17280000"},
                                                {"OnFailure", "skip"}})})
                            .at("estimate");
  EXPECT_NEAR(middle(estimate[0].at("end_s")), 17280000, 0.02 * 17280000);
}

TEST(Estimate, is_a_table_a_line_an_event_and_csv) {
  const TempFolder folder;
  const std::string plan = folder.write("plan.kml", kml(a_day_out()));
  const Outcome outcome = run({"check", plan, "--csv", folder / "events.csv", "--quiet"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("A 2 'EVA 2'"));
  const std::string csv = read_text(folder / "events.csv");
  EXPECT_THAT(csv, HasSubstr("rover_id,sequence,type,label,start_s,end_s,"));
  EXPECT_THAT(csv, HasSubstr("\nA,2,EVA,EVA 2,"));
  EXPECT_EQ(std::ranges::count(csv, '\n'), 7);
}

TEST(Estimate, says_what_becomes_of_an_event) {
  const TempFolder folder;
  const std::string plan = folder.write(
      "plan.kml", kml({mission(), sev("A", "31,12"), event("Pause", "A", 1, {{"Duration", "60"}}),
                       event("Pause", "A", 2, {{"Duration", "60"}, {"SkipWhen", "time_s &gt; 1"}}),
                       event("Pause", "A", 3, {{"Duration", "60"}, {"Timeout", "20"}}),
                       event("Pause", "A", 4, {{"Duration", "60"}})}));
  const Outcome outcome = run({"check", plan, "--csv", folder / "events.csv", "--quiet"});
  EXPECT_THAT(outcome.out, ::testing::ContainsRegex("A 2 'Pause 2' .*  is skipped\n"));
  EXPECT_THAT(outcome.out, ::testing::ContainsRegex("A 3 'Pause 3' .*  fails\n"));
  EXPECT_THAT(outcome.out, ::testing::ContainsRegex("A 4 'Pause 4' .*  never begins\n"));
  EXPECT_THAT(outcome.out, HasSubstr("start and end as day and hh:mm since the mission's start"));
  const std::string csv = read_text(folder / "events.csv");
  EXPECT_THAT(
      csv,
      HasSubstr(",charge_min_high,status,reason,start_utc,end_utc,start_s_low,start_s_high\n"));
  EXPECT_THAT(
      csv, HasSubstr(",failed,timed out after 20 s; 40 s of it were left,2026-01-01T00:01:00.000Z,"
                     "2026-01-01T00:01:20.000Z,60,60\n"));
  EXPECT_THAT(csv, HasSubstr(",not_started,'Pause 3' failed,,,,\n"));
  const json answer = json::parse(run({"check", plan, "--json", "--quiet"}).out);
  std::vector<std::string> statuses;
  for (const json& event : answer.at("estimate")) statuses.push_back(event.at("status"));
  EXPECT_THAT(statuses, ::testing::ElementsAre("completed", "skipped", "failed", "not_started"));
  EXPECT_EQ(answer["estimate"][2]["reason"], "timed out after 20 s; 40 s of it were left");
}

TEST(Estimate, says_that_a_plan_with_errors_has_no_files) {
  const TempFolder folder;
  const std::string plan = folder.write(
      "plan.kml", kml({mission(), sev("A", "31,12"), event("Pause", "A", 1, {{"Duraton", "60"}})}));
  const Outcome outcome = run({"check", plan, "--csv", folder / "events.csv", "--quiet"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("events.csv: is not written, as the plan has errors"));
}

TEST(Estimate, prints_the_legend_of_its_timeline) {
  const TempFolder folder;
  const std::string plan = folder.write("plan.kml", kml(short_drive()));
  EXPECT_THAT(run({"check", plan, "--timeline", "--quiet"}).out, HasSubstr("D drive, E EVA"));
}

TEST(Estimate, is_kept_beside_the_results_of_a_run_whose_log_it_does_not_change) {
  const TempFolder folder;
  const std::string plan = folder.write(
      "plan.kml", kml({mission(), sev("A", "31,12"), event("Route", "A", 1, {}, point("31.001,12")),
                       event("Pause", "A", 2, {{"Duration", "1 h"}})}));
  const auto file = [&](const char* run, const char* name) {
    return (folder / run / name).string();
  };
  ASSERT_EQ(run({plan, "-o", folder / "with", "--quiet"}).exit_code, 0);
  ASSERT_EQ(run({plan, "-o", folder / "without", "--quiet", "--no-estimate"}).exit_code, 0);
  const std::string kept = read_text(file("with", "estimate.json"));
  EXPECT_FALSE(std::filesystem::exists(file("without", "estimate.json")));
  EXPECT_EQ(summary(folder / "with")["log_sha256"], summary(folder / "without")["log_sha256"]);
  const json estimate = json::parse(kept);
  EXPECT_EQ(estimate["events"].size(), 2U);
  EXPECT_EQ(estimate["days"].size(), 1U);
  EXPECT_THAT(read_text(file("with", "report.html")), HasSubstr("\"earth_visible_share\""));
  EXPECT_THAT(read_text(file("without", "report.html")), HasSubstr("\"estimate\":null"));
  // The report makes what the run has not, unless it is told not to.
  ASSERT_EQ(run({"report", folder / "without", "--no-estimate", "--no-pictures"}).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(file("without", "estimate.json")));
  const std::string elsewhere = folder / "page.html";
  ASSERT_EQ(run({"report", folder / "without", "--no-pictures", "-o", elsewhere}).exit_code, 0);
  EXPECT_THAT(read_text(elsewhere), HasSubstr("\"earth_visible_share\""));
  EXPECT_FALSE(std::filesystem::exists(file("without", "estimate.json")));
  ASSERT_EQ(run({"report", folder / "without", "--no-pictures"}).exit_code, 0);
  EXPECT_EQ(read_text(file("without", "estimate.json")), kept);
  EXPECT_THAT(read_text(file("without", "report.html")), HasSubstr("\"earth_visible_share\""));
}

TEST(Estimate, of_shipped_plans_finds_nothing_wrong) {
  for (const std::string plan : {"two_rovers", "solar_stop", "lunar_traverse", "polar_team"}) {
    const TempFolder folder;
    const std::string copy =
        folder.write(plan + ".kml", read_text(repository() / "plans" / (plan + ".kml")));
    const Outcome outcome = run({"check", copy, "--quiet"});
    EXPECT_THAT(outcome.out, Not(HasSubstr("by the estimate"))) << plan;
  }
}

}  // namespace
}  // namespace lsos::test
