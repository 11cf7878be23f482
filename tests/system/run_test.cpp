// A small mission, from its plan to the files that the contract requires.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "support/reference_data.h"
#include "system/run_folder.h"
#include "system/source_files.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::MatchesRegex;

class ShortDrive : public ::testing::Test {
 protected:
  ShortDrive() {
    const std::string plan = folder_.write("drive.kml", kml(short_drive()));
    outcome_ = run({plan, "-o", run_.string()});
    summary_ = summary(run_);
  }

  double number(const std::string& sql) const { return std::stod("0" + query(log_, sql)); }

  TempFolder folder_;
  fs::path run_ = folder_ / "run";
  fs::path log_ = run_ / "log.gpkg";
  Outcome outcome_;
  nlohmann::json summary_;
};

TEST_F(ShortDrive, completes) {
  EXPECT_EQ(outcome_.exit_code, 0) << outcome_.err;
  ASSERT_TRUE(summary_.is_object());
  EXPECT_EQ(summary_["status"], "completed");
  EXPECT_THAT(summary_["log_sha256"].get<std::string>(), MatchesRegex("[0-9a-f]{64}"));
  EXPECT_GT(summary_["real_time_factor"].get<double>(), 1);
  for (const auto& event : summary_["events"]) EXPECT_EQ(event["status"], "completed") << event;
  EXPECT_EQ(summary_["events"].size(), 3u);
}

TEST_F(ShortDrive, leaves_the_files_of_the_contract_and_no_journal) {
  for (const char* name : {"log.gpkg", "overlay.kml", "summary.json", "plan.kml"}) {
    EXPECT_TRUE(fs::is_regular_file(run_ / name)) << name;
  }
  EXPECT_FALSE(fs::exists(run_ / "log.gpkg-wal"));
  EXPECT_FALSE(fs::exists(run_ / "log.gpkg-shm"));
  EXPECT_EQ(read_text(run_ / "plan.kml"), kml(short_drive()));
}

TEST_F(ShortDrive, drives_as_far_and_as_long_as_the_plan_says) {
  // 0.000989 degrees on the Moon's radius of 1737400 m.
  const double route_m = 0.000989 * std::acos(-1.0) / 180 * 1737400;
  const double distance_m = summary_["rovers"]["SEV1"]["distance_m"];
  EXPECT_NEAR(distance_m, route_m, 2.5);  // it may stop short by the arrival radius
  const double drive_s = number("select end_s - start_s from events where type = 'Route'");
  EXPECT_GT(drive_s, (route_m - 2.5) / 2);  // not faster than the requested 2 m/s
  EXPECT_LT(drive_s, 60);

  const double pause_s = number("select end_s - start_s from events where type = 'Pause'");
  EXPECT_NEAR(pause_s, 60, 0.2);
  EXPECT_NEAR(number("select end_s from events where type = 'Wait'"), 300, 0.1);
  EXPECT_NEAR(summary_["sim_s"].get<double>(), 300, 0.2);
}

TEST_F(ShortDrive, ends_where_the_route_ends) {
  const std::string last = " from samples order by time_s desc limit 1";
  EXPECT_NEAR(number("select lon_deg" + last), 0.000989, 2.5 / 30323);
  EXPECT_NEAR(std::stod(query(log_, "select lat_deg" + last)), 0, 1.0 / 30323);
  EXPECT_EQ(number("select speed_mps" + last), 0);
  EXPECT_NEAR(number("select heading_rad" + last), std::acos(-1.0) / 2, 0.1);  // eastwards
}

TEST_F(ShortDrive, logs_a_sample_at_each_interval_and_at_the_end) {
  const double end_s = number("select max(time_s) from samples");
  EXPECT_EQ(end_s, summary_["sim_s"].get<double>());
  const double expected = std::floor(end_s / 2) + 1 + (std::fmod(end_s, 2) > 0 ? 1 : 0);
  EXPECT_EQ(number("select count(*) from samples"), expected);
  EXPECT_EQ(number("select count(distinct time_s) from samples"), expected);
  EXPECT_EQ(query(log_, "select utc from samples where time_s = 10"), "2026-01-01T00:00:10.000Z");
}

TEST_F(ShortDrive, leaves_a_log_that_gdal_reads) {
  const Outcome info = run_command({"ogrinfo", "-ro", "-al", "-so", log_.string()});
  EXPECT_EQ(info.exit_code, 0);
  EXPECT_THAT(info.err, IsEmpty());
  for (const char* layer : {"samples", "events", "phases", "notes", "run", "joints"}) {
    EXPECT_THAT(info.out, HasSubstr(std::string("Layer name: ") + layer + "\n"));
  }
  for (const char* column : {"time_s",
                             "utc",
                             "rover_id",
                             "lon_deg",
                             "lat_deg",
                             "elevation_m",
                             "x_m",
                             "y_m",
                             "z_m",
                             "roll_rad",
                             "pitch_rad",
                             "heading_rad",
                             "speed_mps",
                             "distance_m",
                             "slope_rad",
                             "slip",
                             "slip_max",
                             "sinkage_m",
                             "energy_j",
                             "charge",
                             "energy_rate_w",
                             "solar_w",
                             "solar_available_w",
                             "external_w",
                             "load_w",
                             "drive_w",
                             "loss_w",
                             "solar_j",
                             "external_j",
                             "load_j",
                             "drive_j",
                             "loss_j",
                             "sun_fraction",
                             "incidence",
                             "event",
                             "phase"}) {
    EXPECT_THAT(info.out, HasSubstr(std::string("\n") + column + ": ")) << column;
  }
}

TEST_F(ShortDrive, leaves_an_overlay_that_is_valid_kml) {
  LSOS_NEEDS_REFERENCE("kml/xsd");
  const fs::path schema = reference_file("kml/xsd");
  const Outcome outcome = run_command(
      {"xmllint", "--nonet", "--noout", "--schema", "ogckml22.xsd", run_ / "overlay.kml"},
      {.folder = schema, .environment = {"XML_CATALOG_FILES=catalog.xml"}});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

TEST_F(ShortDrive, says_nothing_but_results_on_standard_output) {
  const std::string plan = folder_ / "drive.kml";
  const Outcome outcome = run({plan, "-o", run_, "--quiet", "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_TRUE(nlohmann::json::accept(outcome.out)) << outcome.out;
}

TEST(FailingEvent, gives_exit_code_1_and_the_reason) {
  const TempFolder folder;
  const std::string plan = folder.write(
      "plan.kml", kml({mission(), sev("SEV1", "0,0"),
                       event("Pause", "SEV1", 1, {{"Duration", "60"}, {"Timeout", "20"}}),
                       event("Pause", "SEV1", 2, {{"Duration", "60"}})}));
  const Outcome outcome = run({plan, "-o", folder / "run"});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  const nlohmann::json result = summary(folder / "run");
  ASSERT_TRUE(result.is_object());
  EXPECT_EQ(result["status"], "failed");
  EXPECT_EQ(result["events"][0]["status"], "failed");
  EXPECT_FALSE(result["events"][0]["reason"].get<std::string>().empty());
  EXPECT_EQ(result["events"][1]["status"], "not_started");
  EXPECT_NEAR(result["events"][0]["end_s"].get<double>(), 20, 0.2);
}

TEST(EventScript, beside_the_plan_is_used_without_a_build) {
  const TempFolder folder;
  folder.write("events/Nap.lua", R"(-- Stand still for as long as the crew wants to sleep.

local lsos = require 'lsos'

local function doze(ev, rover)
  rover:brake()
  if ev.phase_elapsed_s >= ev.params.length_s then
    ev:log('awake', { after_s = ev.phase_elapsed_s })
    return lsos.done
  end
  return lsos.sleep(ev.params.length_s - ev.phase_elapsed_s)
end

return lsos.event {
  api    = 1,
  schema = 'Nap',
  doc    = 'Stand still for as long as the crew wants to sleep.',
  params = { length_s = lsos.duration { kml = 'Length', required = true, doc = 'How long.' } },
  start  = 'doze',
  phases = { doze = doze },
}
)");
  const std::string plan = folder.write(
      "plan.kml",
      kml({mission(), sev("SEV1", "0,0"), event("Nap", "SEV1", 1, {{"Length", "2 min"}})}));
  const Outcome outcome = run({plan, "-o", folder / "run"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(query(folder / "run" / "log.gpkg", "select name from notes"), "awake");
  EXPECT_NEAR(summary(folder / "run")["sim_s"].get<double>(), 120, 0.2);
}

TEST(RunFolder, of_two_plans_of_one_name_is_not_shared_unasked) {
  const TempFolder folder;
  const Surroundings there{folder.path()};
  const std::string plan =
      kml({mission(), sev("A", "31,12"), event("Pause", "A", 1, {{"Duration", "10"}})});
  for (const char* name : {"moon", "mars"}) {
    std::filesystem::create_directory(folder / name);
    folder.write(std::string(name) + "/plan.kml", plan);
  }
  EXPECT_EQ(run({"moon/plan.kml", "--quiet"}, there).exit_code, 0);
  EXPECT_EQ(run({"moon/plan.kml", "--quiet"}, there).exit_code, 0) << "the same again";
  const Outcome other = run({"mars/plan.kml", "--quiet"}, there);
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_THAT(other.err, ::testing::HasSubstr("moon/plan.kml, another plan of that name: "
                                              "-o names another folder, --force replaces it"));
  EXPECT_EQ(run({"mars/plan.kml", "--quiet", "--force"}, there).exit_code, 0);
  const Outcome replacing = run({"moon/plan.kml", "--quiet", "-o", folder / "out/plan"}, there);
  EXPECT_EQ(replacing.exit_code, 0);
  EXPECT_THAT(replacing.err, ::testing::HasSubstr("mars/plan.kml that it held is replaced"));
}

// Options that the contract allows for every command.
TEST(CommonOptions, are_taken_where_there_is_no_use_for_them) {
  const TempFolder folder;
  const std::string plan = folder.write("plan.kml", kml(two_rovers()));
  const std::vector<Words> commands = {{"fsm", plan, "--quiet"},
                                       {"check", plan, "--seed", "3", "--threads", "2", "--quiet"},
                                       {"list", "events", "--quiet"},
                                       {"schema", "Pause", "--quiet", "--threads", "2"}};
  for (const Words& words : commands) EXPECT_EQ(run(words).exit_code, 0) << words[0];
}

TEST(Fsm, is_a_graph_that_graphviz_draws) {
  const TempFolder folder;
  const std::string plan = folder.write("plan.kml", kml(two_rovers()));
  const Outcome outcome = run({"fsm", plan});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Outcome drawn = run_command({"dot", "-Tsvg", folder.write("machine.dot", outcome.out)});
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
  EXPECT_THAT(drawn.err, IsEmpty());
  for (const char* word : {"North", "South", "Route", "Pause"}) {
    EXPECT_THAT(drawn.out, HasSubstr(word));
  }
}

// In a mission of weeks a failure is told when it happens, not in the table at the end.
TEST(Run, tells_of_a_failure_while_it_goes_on) {
  const TempFolder folder;
  const std::string plan = folder.write(
      "plan.kml", kml({mission(), sev("SEV1", "0,0"),
                       event("Consume", "SEV1", 10,
                             {{"Resource", "oxygen"}, {"Amount", "99"}, {"OnFailure", "skip"}}),
                       event("Pause", "SEV1", 20, {{"Duration", "60"}})}));
  const Outcome outcome = run({plan, "-o", folder / "out", "--no-report"});
  EXPECT_THAT(outcome.err, ::testing::HasSubstr("SEV1 at 00:00:00: Consume 'Consume 10' failed: "
                                                "SEV1 has only 24 of oxygen, 99 are wanted\n"));
  const Outcome quiet = run({plan, "-o", folder / "out", "--no-report", "--quiet"});
  EXPECT_THAT(quiet.err, ::testing::Not(::testing::HasSubstr("failed")));
}

}  // namespace
}  // namespace lsos::test
