// Plans that begin as the run of another plan ended.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>

#include "system/energy_balance.h"
#include "system/moon_ground.h"
#include "system/plan_run.h"

namespace lsos::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* noon = "2026-01-01T00:05:00Z";  // when the first plan ends

Mark until_noon(const std::string& rover, int sequence) {
  return event("Wait", rover, sequence, {{"Until", noon}});
}

Mark afternoon(const Fields& more = {}) {
  Mark mark = mission(more);
  for (auto& [name, text] : mark.fields) {
    if (name == "StartTime") text = noon;
  }
  return mark;
}

// In sunshine, where its panel makes power. An SEV that drives, uses up and deploys.
std::vector<Mark> morning_events() {
  return {event("Route", "R", 1, {}, line(place(15, 0) + " " + place(25, 20))),
          event("DeployCA", "R", 2, {{"Duration", "20"}}),
          event("StowSP", "R", 3, {{"Duration", "10"}}),
          event("DeploySP", "R", 4, {{"Duration", "10"}}),
          event("SteerSP", "R", 5, {{"Mode", "track"}}),
          event("Consume", "R", 6, {{"Resource", "oxygen"}, {"Amount", "2.5"}}),
          until_noon("R", 9)};
}

std::vector<Mark> afternoon_events() {
  return {event("Pause", "R", 11, {{"Duration", "30"}}),
          event("Route", "R", 12, {}, line(place(25, 40) + " " + place(0, 40))),
          event("Consume", "R", 13, {{"Resource", "oxygen"}, {"Amount", "1"}}),
          event("Pause", "R", 14, {{"Duration", "60"}})};
}

std::vector<Mark> with(std::vector<Mark> marks, const std::vector<Mark>& more) {
  marks.insert(marks.end(), more.begin(), more.end());
  return marks;
}

Mark r_at(const std::string& where, const Fields& more = {}) {
  return rover("SEV", "R", where, more);
}

std::vector<Mark> morning() {
  return with({mission(), r_at(place(0, 0), {{"InitialCharge", "0.8"}})}, morning_events());
}

std::vector<Mark> afternoon_plan() {
  return with({afternoon(), r_at(place(25, 20))}, afternoon_events());
}

Words from(const PlanRun& first, const Words& more = {}) {
  Words words{"--from", first.folder / "run"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

template <class Row>
std::vector<Row> at_time(const std::vector<Row>& rows, SimTime time) {
  std::vector<Row> found;
  for (const Row& row : rows) {
    if (row.time == time) found.push_back(row);
  }
  return found;
}

double apart_m(const SampleRow& a, const SampleRow& b) {
  const double north = (a.place.lat_rad - b.place.lat_rad) * moon_radius_m;
  const double east = (a.place.lon_rad - b.place.lon_rad) * moon_radius_m;
  return std::hypot(north, east, a.place.height_m - b.place.height_m);
}

void expect_goes_on(const SampleRow& last, const SampleRow& first) {
  EXPECT_EQ(first.time, SimTime{});
  EXPECT_LT(apart_m(last, first), 2e-3);
  EXPECT_NEAR(first.heading_rad, last.heading_rad, 1e-5);
  // Brakes had held it a little tilted on its springs.
  EXPECT_NEAR(first.pitch_rad, last.pitch_rad, 2e-3);
  EXPECT_NEAR(first.roll_rad, last.roll_rad, 2e-3);
  EXPECT_EQ(first.energy_j, last.energy_j);
  EXPECT_EQ(first.charge, last.charge);
  EXPECT_EQ(first.distance_m, 0);
}

TEST(RunFrom, rovers_begin_as_they_were_left) {
  const PlanRun a(morning());
  ASSERT_EQ(a.outcome.exit_code, 0) << a.outcome.err;
  const PlanRun b(afternoon_plan(), from(a));
  ASSERT_EQ(b.outcome.exit_code, 0) << b.outcome.err;
  EXPECT_EQ(b.outcome.err, "");

  const SampleRow last = a.samples().back();
  expect_goes_on(last, b.samples().front());
  expect_closed(b.samples());
  EXPECT_EQ(last.time, SimTime{300'000'000});

  const auto panels_a = at_time(a.log().panels(), last.time),
             panels_b = at_time(b.log().panels(), {});
  ASSERT_EQ(panels_a.size(), panels_b.size());
  for (std::size_t i = 0; i < panels_a.size(); ++i) {
    EXPECT_NEAR(panels_a[i].elevation_rad, panels_b[i].elevation_rad, 1e-3);
    EXPECT_NEAR(panels_a[i].power_w, panels_b[i].power_w, 1e-3 * panels_a[i].power_w);
  }
  EXPECT_GT(panels_a.at(0).power_w, 0);
  const auto joints_a = at_time(a.log().joints(), last.time),
             joints_b = at_time(b.log().joints(), {});
  ASSERT_EQ(joints_a.size(), joints_b.size());
  int masts = 0;
  for (std::size_t i = 0; i < joints_a.size(); ++i) {
    EXPECT_EQ(joints_a[i].joint, joints_b[i].joint);
    if (!joints_a[i].joint.starts_with("antenna")) continue;
    ++masts;
    EXPECT_GT(joints_a[i].extension_m, 0);
    EXPECT_EQ(joints_a[i].extension_m, joints_b[i].extension_m);
  }
  EXPECT_EQ(masts, 1);
  const auto left_a = at_time(a.log().resources(), last.time),
             left_b = at_time(b.log().resources(), {});
  ASSERT_EQ(left_a.size(), 2u);
  for (std::size_t i = 0; i < left_a.size(); ++i) {
    EXPECT_EQ(left_a[i].resource, left_b[i].resource);
    EXPECT_EQ(left_a[i].amount, left_b[i].amount);
  }
  EXPECT_EQ(left_b[0].amount, 21.5);
}

TEST(RunFrom, one_plan_split_in_two_comes_to_the_same) {
  const PlanRun whole(with(morning(), afternoon_events()));
  const PlanRun a(morning());
  const PlanRun b(afternoon_plan(), from(a));
  ASSERT_EQ(whole.outcome.exit_code, 0) << whole.outcome.err;
  const nlohmann::json all = whole.summary()["rovers"]["R"], one = a.summary()["rovers"]["R"],
                       two = b.summary()["rovers"]["R"];
  const auto expect_sum = [&](const char* quantity, double share) {
    const double sum = one[quantity].get<double>() + two[quantity].get<double>();
    EXPECT_NEAR(sum, all[quantity].get<double>(), share * sum) << quantity;
  };
  expect_sum("distance_m", 1e-3);
  expect_sum("energy_used_j", 1e-3);
  expect_sum("solar_j", 1e-3);
  EXPECT_EQ(two["energy_start_j"], one["energy_end_j"]);
  EXPECT_NEAR(two["energy_end_j"].get<double>(), all["energy_end_j"].get<double>(),
              1e-3 * all["energy_used_j"].get<double>());
  const SampleRow end = b.samples().back(), end_of_whole = whole.samples().back();
  EXPECT_LT(apart_m(end, end_of_whole), 0.02);
  // The frame of the first plan is kept.
  EXPECT_LT((end.p_S_m - end_of_whole.p_S_m).norm(), 0.02);
}

TEST(RunFrom, says_so_and_depends_on_the_run_before) {
  const PlanRun a(morning());
  const PlanRun b(afternoon_plan(), from(a)), alone(afternoon_plan());
  const nlohmann::json summary = b.summary();
  EXPECT_EQ(summary["from"], (a.folder / "run").string());
  EXPECT_FALSE(alone.summary().contains("from"));
  EXPECT_THAT(b.outcome.out, HasSubstr("begins as " + (a.folder / "run").string() + " ended\n"));
  EXPECT_EQ(b.log().run().at("from_log_sha256"), a.summary()["log_sha256"]);
  EXPECT_FALSE(alone.log().run().contains("from_log_sha256"));
  EXPECT_NE(summary["log_sha256"], alone.summary()["log_sha256"]);
  const std::string digest = summary["log_sha256"];
  for (const Words& options : {Words{}, Words{"--threads", "2"}, Words{"--save-every-exchange"}}) {
    EXPECT_EQ(PlanRun(afternoon_plan(), from(a, options)).summary()["log_sha256"], digest);
  }
}

TEST(RunFrom, a_stopped_run_is_resumed_with_what_it_began_from) {
  const PlanRun a(morning());
  const std::string to_and_fro = place(400, 20) + " " + place(25, 20);
  const std::vector<Mark> plan = {afternoon(), r_at(place(25, 20)),
                                  event("Route", "R", 1, {}, line(to_and_fro + " " + to_and_fro))};
  const PlanRun whole(plan, from(a));
  ASSERT_EQ(whole.outcome.exit_code, 0) << whole.outcome.err;
  const TempFolder folder;
  Words words{"run",        folder.write("plan.kml", kml(plan)), "-o", folder / "run", "--quiet",
              "--no-report"};
  const Words more = from(a);
  words.insert(words.end(), more.begin(), more.end());
  Process process(program(words));
  ASSERT_TRUE(wait_for_samples(process, folder / "run"));
  process.signal(SIGTERM);
  ASSERT_EQ(process.wait().exit_code, 143);
  const Outcome resumed = run({"resume", folder / "run", "--quiet", "--no-report"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_EQ(summary(folder / "run")["log_sha256"], whole.summary()["log_sha256"]);
  EXPECT_EQ(summary(folder / "run")["from"], (a.folder / "run").string());
}

TEST(RunFrom, what_is_broken_stays_broken) {
  const auto fault = [](int sequence, const Fields& fields) {
    return event("Fault", "R", sequence, fields);
  };
  const PlanRun a(
      with({mission(), r_at(place(0, 0), {{"InitialCharge", "0.5"}}),
            event("Route", "R", 1, {}, point(place(20, 5))), until_noon("R", 9)},
           {fault(20, {{"What", "wheel"}, {"Part", "front_left_wheel_1"}, {"At", "150"}}),
            fault(21, {{"What", "steering"}, {"Part", "rear_right_steering"}, {"At", "10"}}),
            fault(22, {{"What", "antenna"}, {"At", "160"}}),
            fault(23, {{"What", "battery"}, {"Share", "0.25"}, {"At", "170"}}),
            fault(24, {{"What", "panel"}, {"Share", "0.5"}, {"At", "180"}}),
            fault(25, {{"What", "antenna"}, {"Repair", "true"}, {"At", "200"}})}));
  ASSERT_EQ(a.outcome.exit_code, 0) << a.outcome.err;
  const std::vector<Mark> plan = {afternoon(), r_at(place(20, 5)),
                                  event("Route", "R", 1, {}, point(place(30, 5))),
                                  event("Pause", "R", 2, {{"Duration", "20"}})};
  const PlanRun b(plan, from(a));
  const SampleRow last = a.samples().back(), first = b.samples().front();
  expect_goes_on(last, first);
  expect_closed(b.samples());
  EXPECT_NEAR(first.solar_available_w, last.solar_available_w, 1e-3 * last.solar_available_w);
  const auto faults = [](const PlanRun& run) {
    std::vector<std::string> fields;
    for (const NoteRow& note : run.log().notes()) {
      if (note.name == "fault") fields.push_back(note.fields_json);
    }
    return fields;
  };
  EXPECT_EQ(faults(a).size(), 6u);
  EXPECT_EQ(faults(b), faults(a));
  // The motor that does not turn stands as it did, and the wheel that is locked is dragged.
  const auto angle_rad = [](const PlanRun& run, SimTime time, const std::string& joint) {
    for (const JointRow& row : at_time(run.log().joints(), time)) {
      if (row.joint == joint) return row.angle_rad;
    }
    return not_modelled;
  };
  EXPECT_NEAR(angle_rad(b, {}, "rear_right_steering"),
              angle_rad(a, last.time, "rear_right_steering"), 1e-3);
  EXPECT_NEAR(angle_rad(b, b.samples().back().time, "front_left_wheel_1"),
              angle_rad(b, {}, "front_left_wheel_1"), 0.1);
  EXPECT_EQ(PlanRun(plan, from(a, {"--save-every-exchange"})).summary()["log_sha256"],
            b.summary()["log_sha256"]);
}

TEST(RunFrom, limbs_stand_as_they_stood) {
  const PlanRun a({mission(), rover("ATHLETE", "R", place(0, 0), {{"RoverConfig", "Drive"}}),
                   event("SetPosture", "R", 1, {{"Stance", "Tall"}}), until_noon("R", 9)});
  ASSERT_EQ(a.outcome.exit_code, 0) << a.outcome.err;
  const std::vector<Mark> plan = {afternoon(),
                                  rover("ATHLETE", "R", place(0, 0), {{"RoverConfig", "Drive"}}),
                                  event("PathPlanRoute", "R", 1, {}, point(place(4, 1)))};
  const PlanRun b(plan, from(a));
  ASSERT_EQ(b.outcome.exit_code, 0) << b.outcome.err;
  const SampleRow last = a.samples().back();
  expect_goes_on(last, b.samples().front());
  const auto joints_a = at_time(a.log().joints(), last.time),
             joints_b = at_time(b.log().joints(), {});
  ASSERT_EQ(joints_a.size(), joints_b.size());
  for (std::size_t i = 0; i < joints_a.size(); ++i) {
    if (std::isnan(joints_a[i].angle_rad)) continue;
    EXPECT_NEAR(joints_a[i].angle_rad, joints_b[i].angle_rad, 0.01) << joints_a[i].joint;
  }
  // The leg is planned ahead for that stance, and not again.
  EXPECT_EQ(b.log().planned_paths().size(), 1u);
  EXPECT_EQ(PlanRun(plan, from(a, {"--save-every-exchange"})).summary()["log_sha256"],
            b.summary()["log_sha256"]);
}

TEST(RunFrom, generated_ground_stays_where_it_was) {
  const std::vector<Mark> marks = {on("Craters"), r_at("30,20"),
                                   event("Route", "R", 1, {}, point("30.0008,20.0004"))};
  const PlanRun a(marks);
  ASSERT_EQ(a.outcome.exit_code, 0) << a.outcome.err;
  const SampleRow last = a.samples().back();
  const std::string then =
      query(a.folder / "run" / "log.gpkg", "select utc from samples order by time_s desc limit 1");
  Mark later = on("Craters", {{"LogInterval", "1"}});
  later.fields[1].second = then;
  // The rover's own Placemark is elsewhere, and another comes first.
  const PlanRun b({later, r_at("30.01,20.01"), rover("SEV", "A", "30.0002,20.0002"),
                   event("Route", "R", 1, {}, point("30.0012,20.0004"))},
                  from(a));
  ASSERT_EQ(b.outcome.exit_code, 0) << b.outcome.err;
  const std::string warnings = b.summary()["warnings"].dump();
  EXPECT_THAT(warnings, HasSubstr("Rover 'R': its Placemark at 30.010000,20.010000 is "));
  EXPECT_THAT(warnings, HasSubstr("Rover 'A': it is not in "));
  SampleRow first;
  for (const SampleRow& row : b.samples()) {
    if (row.rover_id == "R" && row.time == SimTime{}) first = row;
  }
  expect_goes_on(last, first);
  EXPECT_NEAR(first.elevation_m, last.elevation_m, 1e-3);
  // What opens the run again finds the same ground.
  const Outcome report =
      run({"picture", b.folder / "run", "--at", "0", "--from", "chase", "-o", b.folder / "x.png"});
  EXPECT_EQ(report.exit_code, 0) << report.err;
  EXPECT_THAT(report.err, Not(HasSubstr("not what it was")));
}

}  // namespace
}  // namespace lsos::test
