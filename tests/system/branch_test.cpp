// Branches: runs that leave another run at a moment.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <nlohmann/json.hpp>

#include "system/run_folder.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class Branch : public ::testing::Test {
 protected:
  Branch() {
    plan_ = folder_.write("plan.kml", kml(marks_));
    const Outcome outcome = run({plan_, "-o", trunk_, "--checkpoint-every", "20 s", "--no-report"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    digest_ = summary(trunk_)["log_sha256"];
  }

  Outcome branch(Words options) {
    Words words = {"branch", trunk_, "-o", branch_, "--no-report", "--force"};
    words.insert(words.end(), options.begin(), options.end());
    return run(words);
  }

  std::string refusal(const Words& options) {
    const Outcome outcome = branch(options);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
    EXPECT_FALSE(fs::exists(branch_)) << "nothing is left";
    return outcome.err;
  }

  // The plan with a field of an event set to something else.
  std::string plan_with(int sequence, const std::string& field, const std::string& value) {
    std::vector<Mark> marks = marks_;
    for (Mark& mark : marks) {
      const auto is_it = [&](const auto& f) {
        return f.first == "Sequence" && f.second == std::to_string(sequence);
      };
      if (std::ranges::none_of(mark.fields, is_it)) continue;
      std::erase_if(mark.fields, [&](const auto& f) { return f.first == field; });
      mark.fields.emplace_back(field, value);
    }
    return folder_.write("other.kml", kml(marks));
  }

  TempFolder folder_;
  std::vector<Mark> marks_ = short_drive();
  std::string plan_, digest_;
  std::string trunk_ = folder_ / "trunk", branch_ = folder_ / "branch";
};

TEST_F(Branch, that_changes_nothing_is_the_trunk) {
  const Outcome outcome = branch({"--at", "70 s"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(summary(branch_)["log_sha256"], digest_);
  EXPECT_EQ(summary(branch_)["branch"]["time_s"], 70);
  EXPECT_EQ(summary(branch_)["branch"]["log_sha256"], digest_);
  EXPECT_EQ(summary(branch_)["branch"]["of"], trunk_);
  EXPECT_EQ(summary(branch_)["warnings"], summary(trunk_)["warnings"]);
  EXPECT_EQ(branch({"--at", "33.35 s", "--plan", plan_}).exit_code, 0);
  EXPECT_EQ(summary(branch_)["log_sha256"], digest_);
  EXPECT_EQ(summary(trunk_)["log_sha256"], digest_) << "the trunk stays as it was";
}

TEST_F(Branch, goes_on_with_later_events_of_another_plan) {
  const nlohmann::json before = summary(trunk_)["events"];
  const Outcome outcome = branch({"--at", "SEV1/20", "--plan", plan_with(20, "Duration", "100")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const nlohmann::json after = summary(branch_)["events"];
  EXPECT_EQ(after[0], before[0]);
  EXPECT_EQ(after[1]["start_s"], before[1]["start_s"]);
  EXPECT_EQ(after[1]["end_s"].get<double>() - after[1]["start_s"].get<double>(), 100);
  const std::string rows = "select group_concat(time_s) from samples where time_s <= " +
                           std::to_string(before[0]["end_s"].get<double>());
  EXPECT_EQ(query(branch_ + "/log.gpkg", rows), query(trunk_ + "/log.gpkg", rows));
  // The whole of it can be had from the changed plan as well.
  const Outcome whole = run({folder_ / "other.kml", "-o", folder_ / "whole", "--no-report"});
  EXPECT_EQ(whole.exit_code, 0);
  EXPECT_EQ(summary(folder_ / "whole")["log_sha256"], summary(branch_)["log_sha256"]);
}

// The rover does not wait for the time of an event that is gone.
TEST_F(Branch, goes_on_at_once_behind_a_waiting_event_that_the_plan_leaves_out) {
  std::vector<Mark> marks{
      mission(), sev("SEV1", "0,0"), event("Pause", "SEV1", 10, {{"Duration", "60"}}),
      event("Pause", "SEV1", 20, {{"Duration", "60"}, {"StartTime", "2026-01-01T00:30:00Z"}}),
      event("Pause", "SEV1", 30, {{"Duration", "60"}})};
  folder_.write("plan.kml", kml(marks));
  ASSERT_EQ(run({plan_, "-o", trunk_, "--checkpoint-every", "20 s", "--no-report"}).exit_code, 0);
  marks.erase(marks.begin() + 3);
  const std::string other = folder_.write("other.kml", kml(marks));
  const Outcome outcome = branch({"--at", "3 min", "--plan", other});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const nlohmann::json events = summary(branch_)["events"];
  ASSERT_EQ(events.size(), 2u);
  EXPECT_DOUBLE_EQ(events[1]["start_s"].get<double>(), 180.1);
  EXPECT_EQ(query(branch_ + "/log.gpkg", "select group_concat(sequence) from events"), "10,30")
      << "nothing is left of what came of it in the trunk";
}

// The first checkpoint of a branch must hold the routes that are planned for it: a script of
// changes takes the mission up a second time, and a kill may come before the next checkpoint.
TEST_F(Branch, logs_the_routes_that_another_plan_needs) {
  std::vector<Mark> marks{
      mission(), sev("SEV1", "0,0"), event("Pause", "SEV1", 10, {{"Duration", "100"}}),
      event("PathPlanRoute", "SEV1", 20, {{"ArrivalRadius", "2"}}, line("0.0003,0 0.0005,0"))};
  folder_.write("plan.kml", kml(marks));
  ASSERT_EQ(run({plan_, "-o", trunk_, "--checkpoint-every", "20 s", "--no-report"}).exit_code, 0);
  marks.back() = event("PathPlanRoute", "SEV1", 20, {{"ArrivalRadius", "2"}},
                       line("0.0003,0.0003 0.0005,0.0003"));
  const std::string other = folder_.write("other.kml", kml(marks));
  const std::string nothing = folder_.write("nothing.lua", "local a = 1\n");
  const std::string routes = "select count(*) from planned_paths where time_s = 50";
  for (const Words& options : {Words{}, Words{"--with", nothing}}) {
    Words words{"--at", "50 s", "--plan", other};
    words.insert(words.end(), options.begin(), options.end());
    ASSERT_EQ(branch(words).exit_code, 0);
    EXPECT_EQ(query(branch_ + "/log.gpkg", routes), "2") << options.size();
  }
}

// What a script adds and changes must be made again by `resume` as the branch had it.
TEST_F(Branch, can_be_killed_and_resumed) {
  const std::string script =
      folder_.write("change.lua",
                    "sim:set_soil('ApolloLoose')\n"
                    "sim:shade('SEV1', 0.5)\n"
                    "sim:dispatch('SEV1', 'PathPlanRoute', { at = { 1500, 300 } })\n");
  const Words words{"--at",
                    "SEV1/20",
                    "--plan",
                    plan_with(20, "Duration", "100"),
                    "--with",
                    script,
                    "--checkpoint-every",
                    "1 s"};
  ASSERT_EQ(branch(words).exit_code, 0);
  const nlohmann::json whole = summary(branch_);
  EXPECT_NE(query(branch_ + "/log.gpkg", "select count(*) from planned_paths"), "0");
  Words all{"branch", trunk_, "-o", branch_, "--no-report", "--force"};
  all.insert(all.end(), words.begin(), words.end());
  Process process(program(all));
  const std::string log = branch_ + "/log.gpkg";
  const auto has_begun = [&] {
    return process.err_so_far().find("leaves") != std::string::npos &&
           std::stoi(query(log, "select count(*) from lsos_checkpoints")) >= 3;
  };
  while (process.is_running() && !has_begun()) ::usleep(2000);
  ASSERT_TRUE(process.is_running()) << process.wait().err;
  process.signal(SIGKILL);
  process.wait();
  const Outcome resumed = run({"resume", branch_, "--no-report"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_EQ(summary(branch_)["log_sha256"], whole["log_sha256"]);
  EXPECT_EQ(summary(branch_)["warnings"], whole["warnings"]);
  EXPECT_EQ(summary(branch_)["branch"], whole["branch"]);
}

TEST_F(Branch, finds_renumbered_events_by_their_labels) {
  std::vector<Mark> marks = marks_;
  for (Mark& mark : marks) mark.name = "the " + mark.type;
  folder_.write("plan.kml", kml(marks));
  ASSERT_EQ(run({plan_, "-o", trunk_, "--checkpoint-every", "20 s", "--no-report"}).exit_code, 0);
  digest_ = summary(trunk_)["log_sha256"];
  for (Mark& mark : marks) {
    for (auto& [name, value] : mark.fields) {
      if (name == "Sequence" && value == "10") value = "5";
    }
  }
  const std::string other = folder_.write("other.kml", kml(marks));
  const Outcome outcome = branch({"--at", "70 s", "--plan", other});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(summary(branch_)["log_sha256"], digest_) << "it is the same plan";
}

TEST_F(Branch, goes_on_with_what_a_script_changes) {
  const std::string script =
      folder_.write("change.lua",
                    "sim:dispatch('SEV1', 'Pause', { Duration = '40 s' })\n"
                    "sim:fault('SEV1', { what = 'battery', share = 0.5 })\n");
  const Outcome outcome = branch({"--at", "70 s", "--with", script});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(summary(branch_)["events"].size(), summary(trunk_)["events"].size() + 1);
  EXPECT_EQ(query(branch_ + "/log.gpkg", "select count(*) from notes where name = 'fault'"), "1");
  EXPECT_THAT(read_text(branch_ + "/plan.kml"), HasSubstr("Pause"));
}

// A rover whose telemetry says what was simulated goes on as it would have.
TEST_F(Branch, goes_on_from_what_was_measured) {
  const std::string log = trunk_ + "/log.gpkg", other_log = branch_ + "/log.gpkg";
  const std::string columns =
      "select time_s || ',' || lon_deg || ',' || lat_deg || ',' || heading_rad || ',' || charge "
      "from samples ";
  const std::string simulated = query(log, columns + "where time_s = 10");
  const std::string rows = "time_s,lon_deg,lat_deg,heading_rad,charge\n" + simulated + "\n";
  const std::string table = folder_.write("same.csv", rows);
  const Outcome same = branch({"--at", "10 s", "--measured", table});
  ASSERT_EQ(same.exit_code, 0) << same.err;
  EXPECT_THAT(same.err, HasSubstr("same.csv:2: SEV1 goes on from rest, where it drove at"));
  const std::string last = "select distance_m from samples order by time_s desc limit 1";
  EXPECT_NEAR(std::stod(query(other_log, last)), std::stod(query(log, last)), 0.5);
  const nlohmann::json before = summary(trunk_)["events"], after = summary(branch_)["events"];
  EXPECT_NEAR(after[0]["end_s"].get<double>(), before[0]["end_s"].get<double>(), 5);
}

// Noise about a full battery is no fault, but is told.
TEST_F(Branch, tells_that_more_charge_was_measured_than_a_battery_holds) {
  const std::string table = folder_.write("t.csv", "time_s,charge (%)\n8,103\n");
  const Outcome outcome = branch({"--at", "10 s", "--measured", table});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string text = "SEV1: a charge of 103.00 % was measured; it goes on with 100 %";
  EXPECT_THAT(outcome.err, HasSubstr("warning: " + text));
  EXPECT_THAT(summary(branch_)["warnings"].dump(), HasSubstr(text));
}

TEST_F(Branch, goes_on_to_the_same_waypoints_from_a_measured_place) {
  const std::string log = trunk_ + "/log.gpkg", other_log = branch_ + "/log.gpkg";
  // 0.001 degrees of latitude are 30.3 m on the Moon.
  const std::string table = folder_.write(
      "measured.csv",
      "utc,rover_id,lon_deg,lat_deg,charge (%),Speed (km/h)\n"
      "2026-01-01T00:00:04Z,SEV1,0.0001,0,70,4\n2026-01-01T00:00:08Z,SEV1,0.0002,-0.001,62.5,4\n"
      "2026-01-01T00:00:20Z,SEV1,5,5,10,4\n");
  const Outcome outcome = branch({"--at", "10 s", "--measured", table});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("measured.csv:3: SEV1 goes on"));
  EXPECT_THAT(outcome.err, HasSubstr("with 62.50 % charge instead of"));
  const auto first = [&](const std::string& column) {
    return std::stod(query(other_log, "select " + column +
                                          " from samples where time_s > 10 "
                                          "order by time_s limit 1"));
  };
  EXPECT_NEAR(first("lon_deg"), 0.0002, 1e-4);
  EXPECT_NEAR(first("lat_deg"), -0.001, 1e-4);
  EXPECT_NEAR(first("charge"), 0.625, 1e-3);
  const std::string driven = "select max(distance_m) from samples where time_s <= 10";
  EXPECT_NEAR(first("distance_m"), std::stod(query(log, driven)), 5) << "a jump is no drive";
  const nlohmann::json before = summary(trunk_)["events"], after = summary(branch_)["events"];
  EXPECT_EQ(after[0]["status"], before[0]["status"]);
  EXPECT_GT(after[0]["end_s"], before[0]["end_s"]);
  const std::string end =
      "select round(lon_deg, 5) || ' ' || round(lat_deg, 5) from samples order by "
      "time_s desc limit 1";
  EXPECT_EQ(query(other_log, end), query(log, end));
  const std::string noted =
      "select json_extract(fields, '$.charge') from notes where "
      "name = 'measured'";
  EXPECT_NEAR(std::stod(query(other_log, noted)), 0.625, 1e-6);
}

TEST_F(Branch, refuses_telemetry_from_which_it_cannot_go_on) {
  fs::remove_all(branch_);
  const auto refusal_of = [&](const std::string& rows) {
    return refusal({"--at", "10 s", "--measured", folder_.write("t.csv", rows)});
  };
  EXPECT_THAT(refusal({"--at", "10 s", "--measured", "nowhere.csv"}),
              HasSubstr("nowhere.csv: cannot be opened: No such file"));
  EXPECT_THAT(refusal_of("time_s,charge\n20,0.5\n"),
              HasSubstr("has no place, heading or charge of any rover up to 0:00:10"));
  EXPECT_THAT(refusal_of("time_s,speed_mps\n2,0.5\n"), HasSubstr("has no place, heading or"));
  EXPECT_THAT(refusal_of("time_s,charge\n2,1.5\n"),
              HasSubstr("t.csv:2: charge: 1.5 is out of range"));
}

// This is found only when the branch has begun.
TEST_F(Branch, leaves_nothing_when_a_rover_was_measured_where_it_cannot_be) {
  const std::string table = folder_.write("t.csv", "time_s,lon_deg,lat_deg\n8,180,0\n");
  EXPECT_THAT(
      refusal({"--at", "10 s", "--measured", table}),
      HasSubstr("SEV1 cannot go on from 180.000000,0.000000: that is 5458.2 km from where "
                "it is simulated, farther than it can have driven; are longitude and latitude"));
}

// What was measured counts where another run begins with the end of this one.
TEST_F(Branch, goes_on_from_what_was_measured_at_the_end) {
  const std::string end_s = query(trunk_ + "/log.gpkg", "select max(time_s) from samples");
  const std::string table =
      folder_.write("t.csv", "time_s,lon_deg,lat_deg,charge\n" + end_s + ",0.0002,-0.001,0.5\n");
  const Outcome outcome = branch({"--at", end_s + " s", "--measured", table});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto last = [&](const std::string& column) {
    return std::stod(query(branch_ + "/log.gpkg",
                           "select " + column + " from samples order by time_s desc limit 1"));
  };
  EXPECT_NEAR(last("lat_deg"), -0.001, 1e-5);
  EXPECT_NEAR(last("charge"), 0.5, 1e-3);
  EXPECT_NEAR(last("time_s"), std::stod(end_s), 10);
}

TEST_F(Branch, that_fails_to_begin_leaves_an_earlier_run_as_it_was) {
  ASSERT_EQ(branch({"--at", "70 s"}).exit_code, 0);
  const std::string script = folder_.write("change.lua", "sim:shade('SEV9', 0.5)\n");
  EXPECT_EQ(branch({"--at", "70 s", "--with", script}).exit_code, 2);
  EXPECT_EQ(summary(branch_)["log_sha256"], digest_);
  EXPECT_EQ(run({"verify", branch_}).exit_code, 0);
}

TEST_F(Branch, does_not_replace_the_run_that_its_trunk_begins_from) {
  const std::string second = folder_ / "second";
  std::vector<Mark> marks = marks_;
  for (Mark& mark : marks) {
    for (auto& [name, value] : mark.fields) {
      if (name == "StartTime" && mark.type == "MissionInfo") value = "2026-01-02T00:00:00Z";
    }
  }
  const std::string plan = folder_.write("second.kml", kml(marks));
  const Outcome begun =
      run({plan, "--from", trunk_, "-o", second, "--checkpoint-every", "20 s", "--no-report"});
  ASSERT_TRUE(fs::exists(second + "/log.gpkg")) << begun.err;
  const Outcome outcome = run({"branch", second, "--at", "30 s", "-o", trunk_});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("holds the run with whose end this one begins"));
  EXPECT_EQ(summary(trunk_)["log_sha256"], digest_);
}

TEST_F(Branch, refuses_a_script_that_goes_back_to_a_saved_state) {
  fs::remove_all(branch_);
  const std::string state = folder_ / "state";
  const std::string script =
      folder_.write("back.lua", fmt::format("sim:save('{}')\nsim:load('{}')\n", state, state));
  EXPECT_THAT(refusal({"--at", "70 s", "--with", script}),
              HasSubstr("cannot be gone back to: the log of a branch goes on from its moment"));
}

TEST_F(Branch, tells_what_was_changed_there) {
  const std::string script = folder_.write("dust.lua", "sim:shade('SEV1', 0.5)\n");
  const Outcome outcome = branch({"--at", "70 s", "--with", script});
  EXPECT_THAT(outcome.out + outcome.err, HasSubstr("from 1 min 10 s on, with " + script));
  EXPECT_EQ(summary(branch_)["branch"]["changes"], "with " + script);
}

TEST_F(Branch, refuses_a_script_that_lets_time_pass) {
  fs::remove_all(branch_);
  const std::string script = folder_.write("late.lua", "sim:run_for(5)\nsim:shade('SEV1', 0.5)\n");
  EXPECT_THAT(refusal({"--at", "70 s", "--with", script}), HasSubstr("late.lua: lets time pass"));
}

TEST_F(Branch, refuses_what_cannot_be) {
  fs::remove_all(branch_);
  EXPECT_THAT(refusal({}), HasSubstr("--at: a time or an event of the run is required"));
  EXPECT_THAT(refusal({"--at", "yesterday"}), HasSubstr("--at yesterday: neither a time"));
  EXPECT_THAT(refusal({"--at", "3 d"}), HasSubstr("--at 3 d: the run is from"));
  EXPECT_THAT(refusal({"--at", "SEV1/10"}), HasSubstr("begins with the mission"));
  EXPECT_THAT(refusal({"--at", "70 s", "--with", "nowhere.lua"}), HasSubstr("no such file"));
  EXPECT_THAT(refusal({"--at", "70 s", "--plan", plan_with(10, "Speed", "0.2")}),
              HasSubstr("SEV1/10 'Route 10' differs from what has begun"));
  std::vector<Mark> marks = marks_;
  marks.push_back(sev("SEV2", "0.001,0.001"));
  std::erase_if(marks, [](const Mark& mark) { return mark.type == "Route"; });
  const std::string other = folder_.write("other.kml", kml(marks));
  const std::string text = refusal({"--at", "70 s", "--plan", other});
  EXPECT_THAT(text, HasSubstr("Rover 'SEV2' is not in the mission that runs"));
  EXPECT_THAT(text, HasSubstr("SEV1/10 'Route 10' is missing: it has begun, and stays"));
}

TEST_F(Branch, needs_checkpoints) {
  ASSERT_EQ(run({plan_, "-o", trunk_, "--no-report"}).exit_code, 0);
  EXPECT_THAT(refusal({"--at", "70 s"}), HasSubstr("keeps no checkpoint"));
}

TEST_F(Branch, tells_where_a_script_of_changes_fails) {
  const std::string script = folder_.write("change.lua", "local a = 1\nsim:shade('SEV9', 0.5)\n");
  const Outcome outcome = branch({"--at", "70 s", "--with", script});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_FALSE(fs::exists(branch_)) << "nothing is left";
  EXPECT_THAT(outcome.err, HasSubstr("change.lua:2:"));
  EXPECT_THAT(outcome.err, HasSubstr("there is no rover 'SEV9'"));
}

}  // namespace
}  // namespace lsos::test
