// Energy and light through the whole program: plan, scripts, rendering, log.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>

#include "system/energy_balance.h"
#include "system/plan_run.h"

namespace lsos::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

// Place at 30 degrees east, 10 north, where the Sun stands 78.38 degrees high on 2026-01-01.
constexpr const char* in_sunshine = "30,10";

Mark rover(const std::string& type, const Fields& more = {}, const std::string& at = in_sunshine) {
  Fields fields{{"RoverId", "R"}, {"RoverType", type}};
  fields.insert(fields.end(), more.begin(), more.end());
  return {"Rover", fields, point(at)};
}

Mark on_craters(const Fields& more = {}) {
  Fields fields{{"Planet", "Moon"}, {"StartTime", "2026-01-01T00:00:00Z"}, {"Terrain", "Craters"}};
  fields.insert(fields.end(), more.begin(), more.end());
  return {"MissionInfo", fields, ""};
}

Mark asset(const std::string& id, const std::string& type, const std::string& at) {
  return {"Asset", {{"AssetId", id}, {"AssetType", type}}, point(at)};
}

// A rover that nothing will charge ends with that reason, and does not wait until MaxDuration.
TEST(Power, that_never_comes_is_not_waited_for) {
  const Mark on_earth{
      "MissionInfo",
      {{"Planet", "Earth"}, {"StartTime", "2026-01-02T00:00:00Z"}, {"Terrain", "Flat"}},
      ""};
  const PlanRun run(
      {on_earth, rover("SEV", {{"InitialCharge", "0.01"}}, "10,20"), event("StowSP", "R", 1),
       event("Consume", "R", 2, {{"Power", "50000"}, {"Duration", "1 h"}, {"OnFailure", "skip"}}),
       event("Route", "R", 3, {}, point("10.0001,20")),
       event("Pause", "R", 4, {{"Duration", "5"}})});
  const json summary = run.summary();
  EXPECT_EQ(summary["events"][2]["status"], "failed");
  EXPECT_EQ(summary["events"][2]["reason"],
            "the battery is empty, and nothing charges it: the solar panels are stowed");
  EXPECT_EQ(summary["events"][3]["status"], "not_started");
  EXPECT_LT(summary["sim_s"], 3600);
}

// While light may come, an event waits for it until the end of the mission, and says so.
TEST(Power, that_does_not_come_is_waited_for_in_rows_until_the_end) {
  const Mark at_night{"MissionInfo",
                      {{"Planet", "Earth"},
                       {"StartTime", "2026-01-02T20:00:00Z"},
                       {"Terrain", "Flat"},
                       {"ParkedLogInterval", "60"},
                       {"MaxDuration", "1 h"}},
                      ""};
  const PlanRun run(
      {at_night, rover("SEV", {{"InitialCharge", "0.01"}}, "10,20"),
       event("Consume", "R", 1, {{"Power", "50000"}, {"Duration", "1 h"}, {"OnFailure", "skip"}}),
       event("Route", "R", 2, {}, point("10.0001,20")),
       event("Pause", "R", 3, {{"Duration", "5"}})});
  std::size_t rows = 0;
  for (const SampleRow& row : run.samples()) rows += row.time % SimTime{60'000'000} == SimTime{};
  EXPECT_EQ(rows, 61u);
  bool is_noted = false;
  for (const NoteRow& note : run.log().notes()) {
    is_noted |= note.name == "waits_for_charge" && note.sequence == 2;
  }
  EXPECT_TRUE(is_noted);
  EXPECT_EQ(run.summary()["events"][2]["reason"],
            "MaxDuration is over; its turn did not come, 'Route 2' waited to start");
}

TEST(Power, closes_in_every_row_driving_and_parked) {
  const PlanRun run({on_craters({{"LogInterval", "1"}}), rover("SEV", {{"InitialCharge", "0.7"}}),
                     event("SteerSP", "R", 1), event("Route", "R", 2, {}, point("30.003,10")),
                     event("Pause", "R", 3, {{"Duration", "1 h"}})});
  ASSERT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
  expect_closed(run.samples());
  EXPECT_GT(run.samples().back().drive_j, 1e4);
  EXPECT_GT(run.samples().back().solar_j, 1e5);
}

// The panel's power against the sky's own numbers; the panel lies flat on the roof, all in
// sunshine.
TEST(Power, of_a_panel_in_the_open_is_area_cosine_efficiency_and_sunshine) {
  const PlanRun run({mission(), rover("SEV"), event("Pause", "R", 1, {{"Duration", "10"}})});
  ASSERT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
  const SampleRow row = run.samples().front();
  EXPECT_EQ(row.sun_fraction, 1);
  // lsos-host sun: elevation 78.38 deg, distance 147.3e9 m.
  const json sun = json::parse(
      test::run({"sun", "--planet", "Moon", "--site", in_sunshine, "--at", "2026-01-01T00:00:00Z"})
          .out)[0];
  const double cosine = std::sin(sun["elevation_deg"].get<double>() * 3.14159265358979 / 180);
  const double au = sun["distance_m"].get<double>() / 149597870700;
  EXPECT_NEAR(row.incidence, cosine, 1e-3);  // the rover's springs deflect a little
  EXPECT_NEAR(row.solar_available_w, 8 * 0.29 * 0.9 * 1361 / au / au * cosine, 3);
  EXPECT_LT(row.solar_w, row.solar_available_w);  // the battery is full
}

TEST(Power, does_not_depend_on_how_often_it_is_logged) {
  const auto last = [](const std::string& interval) {
    const PlanRun run({on_craters({{"LogInterval", interval}, {"ParkedLogInterval", interval}}),
                       rover("SEV", {{"InitialCharge", "0.5"}}), event("SteerSP", "R", 1),
                       event("Route", "R", 2, {}, point("30.001,10")),
                       event("Pause", "R", 3, {{"Duration", "20 min"}})});
    return run.samples().back();
  };
  const SampleRow often = last("0.7"), seldom = last("50");
  EXPECT_EQ(often.energy_j, seldom.energy_j);
  EXPECT_EQ(often.solar_j, seldom.solar_j);
  EXPECT_EQ(often.load_j, seldom.load_j);
}

TEST(Power, with_panels_and_an_array_repeats_and_survives_being_saved) {
  const std::vector<Mark> plan{
      on_craters(),
      rover("SEV", {{"InitialCharge", "0.5"}}),
      asset("Array", "SolarArray", "30.0004,10"),
      {"Rover", {{"RoverId", "S"}, {"RoverType", "SEV"}}, point("30.0007,10.0005")},
      event("SteerSP", "R", 1),
      event("Recharge", "R", 2, {{"From", "Array"}, {"Duration", "60"}}),
      event("Route", "S", 1, {}, point("30.0008,10.0001")),
      event("StowSP", "S", 2)};
  const std::string digest = digest_of(TempFolder(), plan);
  EXPECT_EQ(digest_of(TempFolder(), plan, {"--threads", "2"}), digest);
  EXPECT_EQ(digest_of(TempFolder(), plan, {"--save-every-exchange"}), digest);
}

TEST(Recharge, sets_a_level_at_once) {
  const PlanRun run({mission(), rover("LRV"), event("Recharge", "R", 1, {{"EnergyLevel", "25%"}}),
                     event("Pause", "R", 2, {{"Duration", "10"}})});
  ASSERT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
  expect_closed(run.samples());
  const std::vector<SampleRow> rows = run.samples();
  EXPECT_EQ(rows.front().charge, 1);  // initial charge
  EXPECT_NEAR(rows[1].charge, 0.25, 1e-4);
  EXPECT_NEAR(rows[1].external_j, -0.75 * 242 * 36 * 3600, 1);
}

TEST(Recharge, flows_at_a_rate_until_the_charge_is_reached) {
  const PlanRun run({mission(), rover("LRV", {{"InitialCharge", "0.5"}}),
                     event("Recharge", "R", 1, {{"EnergyRate", "1 kW"}, {"UntilCharge", "0.6"}})});
  ASSERT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
  expect_closed(run.samples());
  // 0.1 of 242 A h x 36 V, at 1000 W less 80 W of loads.
  const double wanted_s = 0.1 * 242 * 36 * 3600 / 920;
  EXPECT_NEAR(run.summary()["events"][0]["end_s"].get<double>(), wanted_s, 0.2);
  EXPECT_NEAR(run.samples().back().charge, 0.6, 1e-5);
}

// 0.01 of 242 A h x 36 V at 50 kW takes 6 s, whatever flowed before.
TEST(Recharge, ends_at_the_charge_that_was_asked) {
  const PlanRun run(
      {mission(), rover("LRV", {{"InitialCharge", "0.5"}}),
       event("Recharge", "R", 1, {{"EnergyRate", "50 kW"}, {"UntilCharge", "0.51"}}),
       event("Recharge", "R", 2,
             {{"EnergyLevel", "1 kWh"}, {"EnergyRate", "50 kW"}, {"UntilCharge", "0.2"}})});
  ASSERT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
  const json events = run.summary()["events"];
  EXPECT_NEAR(events[0]["end_s"].get<double>(), 0.01 * 242 * 36 * 3600 / 49920, 0.1);
  // From 1 kWh to 0.2 of 8.712 kWh.
  const double wanted_s = (0.2 * 242 * 36 * 3600 - 3.6e6) / 49920;
  EXPECT_NEAR(events[1]["end_s"].get<double>() - events[1]["start_s"].get<double>(), wanted_s, 0.1);
}

TEST(Recharge, at_the_start_goes_on_from_the_level_that_it_set) {
  const PlanRun run(
      {mission(), rover("LRV"),
       event("Recharge", "R", 1,
             {{"EnergyLevel", "20%"}, {"EnergyRate", "10 kW"}, {"UntilCharge", "0.3"}})});
  ASSERT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
  EXPECT_NEAR(run.samples().back().charge, 0.3, 1e-4);
}

TEST(Recharge, takes_what_an_asset_nearby_can_give) {
  const PlanRun run(
      {mission(), rover("LRV", {{"InitialCharge", "0.5"}}), asset("Home", "Habitat", "30.0005,10"),
       event("Recharge", "R", 1, {{"From", "Home"}, {"Duration", "100"}, {"EnergyRate", "300 W"}}),
       event("Recharge", "R", 2, {{"From", "Home"}, {"Duration", "100"}})});
  ASSERT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
  const auto rows = run.samples();
  EXPECT_NEAR(rows.back().external_j, 300 * 100 + 5000 * 100, 1);
}

TEST(Recharge, from_too_far_or_from_nothing_says_so) {
  const PlanRun far({mission(), rover("LRV"), asset("Home", "Habitat", "30.002,10"),
                     event("Recharge", "R", 1, {{"From", "Home"}, {"Duration", "100"}})});
  EXPECT_THAT(far.summary()["events"][0]["reason"].get<std::string>(), HasSubstr("'Home' is 59."));
  const PlanRun mast({mission(), rover("LRV"), asset("Mast", "CommStation", "30.0002,10"),
                      event("Recharge", "R", 1, {{"From", "Mast"}, {"Duration", "100"}})});
  EXPECT_EQ(mast.outcome.exit_code, 2);
  EXPECT_THAT(mast.outcome.err,
              HasSubstr("From = 'Mast': the plan has no asset with power to give"));
}

// The array faces the Sun unobstructed, so that its power also follows from its area, its
// efficiency and the Sun's irradiance.
TEST(Recharge, from_a_solar_array_is_sunshine) {
  const PlanRun run({mission(), rover("LRV", {{"InitialCharge", "0.5"}}),
                     asset("Array", "SolarArray", "30.0005,10"),
                     event("Recharge", "R", 1, {{"From", "Array"}, {"Duration", "100"}})});
  ASSERT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
  const double au = 0.98333;  // perihelion of 2026-01-03, without the Moon's orbit
  EXPECT_NEAR(run.samples().back().external_j / 100, 30 * 0.29 * 0.9 * 1361 / au / au, 60);
}

TEST(Recharge, waits_for_the_sun) {
  const PlanRun run({mission({{"ParkedLogInterval", "60"}}),
                     rover("SEV", {{"InitialCharge", "0.5"}}), event("SteerSP", "R", 1),
                     event("Recharge", "R", 2, {{"UntilCharge", "0.51"}})});
  ASSERT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
  expect_closed(run.samples());
  EXPECT_NEAR(run.samples().back().charge, 0.51, 1e-5);
  EXPECT_EQ(run.samples().back().external_j, 0);
}

TEST(Panels, that_are_stowed_give_nothing_and_cannot_be_steered) {
  const PlanRun run({mission(), rover("SEV"), event("StowSP", "R", 1, {{"Duration", "30"}}),
                     event("Pause", "R", 2, {{"Duration", "10"}}),
                     event("SteerSP", "R", 3, {{"OnFailure", "skip"}, {"Panel", "Roof"}}),
                     event("DeploySP", "R", 4), event("Pause", "R", 5, {{"Duration", "10"}})});
  const json events = run.summary()["events"];
  EXPECT_EQ(events[0]["end_s"].get<double>(), 30);
  EXPECT_THAT(events[2]["reason"].get<std::string>(), HasSubstr("'Roof' is stowed"));
  EXPECT_NEAR(events[3]["end_s"].get<double>() - events[3]["start_s"].get<double>(), 300, 0.11);
  const auto rows = run.samples();
  EXPECT_GT(rows.front().load_w, 0);
  EXPECT_EQ(rows[18].solar_available_w, 0);  // at 36 s
  EXPECT_GT(rows.back().solar_available_w, 2000);
  EXPECT_TRUE(std::isnan(run.log().panels()[18].azimuth_rad));
  // The panel no longer follows the target that it had before it was stowed.
  EXPECT_NEAR(run.log().panels().back().elevation_rad, 3.14159265 / 2, 0.01);
}

TEST(Panels, that_track_face_the_sun_as_the_rover_drives) {
  const PlanRun run({on_craters(), rover("SEV"), event("SteerSP", "R", 1),
                     event("Route", "R", 2, {}, line("30,10 30.001,10 30.001,10.001"))});
  ASSERT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
  double mean = 0, count = 0;
  for (const PanelRow& row : run.log().panels()) {
    if (seconds(row.time) < 80 || row.sun_fraction < 0.9) continue;
    mean += row.incidence / row.sun_fraction;
    ++count;
  }
  ASSERT_GT(count, 20);
  EXPECT_GT(mean / count, 0.95);  // in the bend it lags, at one degree per second
}

TEST(Panels, that_point_look_where_they_are_told) {
  const PlanRun run(
      {mission(), rover("SEV", {{"Heading", "70"}}),
       event("SteerSP", "R", 1, {{"Mode", "point"}, {"Azimuth", "135"}, {"Elevation", "30"}}),
       event("Pause", "R", 2, {{"Duration", "10"}})});
  ASSERT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
  const PanelRow row = run.log().panels().back();
  EXPECT_NEAR(row.azimuth_rad * 180 / 3.14159265, 135, 0.1);
  EXPECT_NEAR(row.elevation_rad * 180 / 3.14159265, 30, 0.1);
}

TEST(Consume, uses_energy_and_resources_until_they_are_gone) {
  const PlanRun run({mission(), rover("SEV"),
                     event("Consume", "R", 1, {{"Power", "2 kW"}, {"Duration", "60"}}),
                     event("Consume", "R", 2, {{"Resource", "oxygen"}, {"Amount", "20"}}),
                     event("Consume", "R", 3, {{"Resource", "oxygen"}, {"Amount", "5"}})});
  EXPECT_EQ(run.outcome.exit_code, 1);
  const json summary = run.summary();
  EXPECT_NEAR(summary["rovers"]["R"]["resources"]["oxygen"].get<double>(), 4, 1e-12);
  EXPECT_THAT(summary["events"][2]["reason"].get<std::string>(),
              HasSubstr("R has only 4 of oxygen, 5 are wanted"));
  EXPECT_NEAR(run.samples()[0].load_w, 550 + 2000, 1e-9);
}

// In a lunar night the battery runs down and loads are shed; in the morning the rover recovers.
TEST(Power, comes_back_after_a_lunar_night) {
  const PlanRun run({mission({{"ParkedLogInterval", "1 h"}}), rover("SEV", {}, "120,0"),
                     event("Pause", "R", 1, {{"Duration", "18 d"}})});
  ASSERT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
  const auto rows = run.samples();
  expect_closed(rows);
  double least = 1;
  for (const SampleRow& row : rows) least = std::min(least, row.charge);
  EXPECT_EQ(least, 0);
  EXPECT_GT(rows.back().charge, 0.5);
  std::vector<std::string> notes;
  for (const NoteRow& note : run.log().notes()) notes.push_back(note.name);
  EXPECT_THAT(notes, ::testing::ElementsAre("battery_empty", "loads_shed", "loads_restored"));
}

// On a machine without any driver that renders, the run does not begin.
TEST(Power, without_anything_that_draws_says_what_to_install) {
  const TempFolder folder;
  const std::string plan = folder.write(
      "plan.kml", kml({mission(), rover("SEV"), event("Pause", "R", 1, {{"Duration", "5"}})}));
  const Outcome outcome =
      run({plan, "-o", folder / "run", "--quiet"},
          {.environment = {"__EGL_VENDOR_LIBRARY_FILENAMES=" + (folder / "none.json").string()}});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("cannot draw without a screen"));
  EXPECT_THAT(outcome.err, HasSubstr("apt-get install libegl1 libgl1-mesa-dri"));
  EXPECT_FALSE(std::filesystem::exists(folder / "run"));
}

// The renderer is reported and logged, and so are the assumptions about the air.
TEST(Power, says_what_drew_and_what_was_assumed) {
  const TempFolder folder;
  const std::string plan = folder.write(
      "plan.kml", kml({{"MissionInfo",
                        {{"Planet", "Mars"}, {"StartTime", "2026-01-01"}, {"Terrain", "Flat"}},
                        ""},
                       {"Rover", {{"RoverId", "R"}, {"RoverType", "MER"}}, point("137,-4")},
                       event("Pause", "R", 1, {{"Duration", "5"}})}));
  const Outcome outcome = run({plan, "-o", folder / "run"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string renderer = LogReader(folder / "run" / "log.gpkg").run().at("renderer");
  EXPECT_THAT(outcome.err, HasSubstr("light is drawn by " + renderer));
  EXPECT_THAT(summary(folder / "run")["assumptions"].dump(),
              HasSubstr("dust with an optical depth of 0.5 is assumed"));
}

// Two rovers stand in line with the Sun, 5 degrees high in the east, the low one in the shadow of
// the other.
TEST(Power, is_taken_by_another_rovers_shadow) {
  const auto fraction = [](const std::string& other) {
    std::vector<Mark> plan{mission(), rover("MER", {{"Heading", "0"}}, "-52.5,0"),
                           event("Pause", "R", 1, {{"Duration", "5"}})};
    if (!other.empty()) {
      plan.push_back(
          {"Rover", {{"RoverId", "X"}, {"RoverType", "SEV"}, {"Heading", "0"}}, point(other)});
    }
    double last = -1;
    for (const SampleRow& row : PlanRun(plan).samples()) {
      if (row.rover_id == "R") last = row.sun_fraction;
    }
    return last;
  };
  const double alone = fraction("");
  EXPECT_GT(alone, 0.8);                       // its mast and antenna shade it
  EXPECT_LT(fraction("-52.49973,0"), 0.2);     // 8 m to the east
  EXPECT_EQ(fraction("-52.5006,0"), alone);    // to the west
  EXPECT_EQ(fraction("-52.5,0.0006"), alone);  // to the north
}

// The Sun stands 3 degrees high at an azimuth of 16.3 degrees. Another rover, 10 m towards it,
// raises and lowers its panel. The Sun is sampled every six minutes, but a neighbour's move counts
// at once.
TEST(Light, a_neighbours_panel_shades_as_soon_as_it_moves) {
  const double azimuth = 16.28 * std::numbers::pi / 180, latitude = -86 * std::numbers::pi / 180;
  const double deg_a_m = 180 / std::numbers::pi / 1737400;
  const std::string beside =
      fmt::format("{:.9f},{:.9f}", 10 * std::sin(azimuth) * deg_a_m / std::cos(latitude),
                  -86 + 10 * std::cos(azimuth) * deg_a_m);
  const auto rover_at = [](const std::string& id, const std::string& at) {
    return Mark{"Rover", {{"RoverId", id}, {"RoverType", "SEV"}, {"Heading", "0"}}, point(at)};
  };
  const PlanRun run({{"MissionInfo",
                      {{"Planet", "Moon"},
                       {"StartTime", "2026-07-28T00:00:00Z"},
                       {"Terrain", "Flat"},
                       {"LogInterval", "1"},
                       {"ParkedLogInterval", "1"}},
                      ""},
                     rover_at("A", "0,-86"),
                     rover_at("B", beside),
                     event("SteerSP", "A", 1),
                     event("Pause", "A", 2, {{"Duration", "800"}}),
                     event("SteerSP", "B", 1),
                     event("Pause", "B", 2, {{"Duration", "500"}}),
                     event("StowSP", "B", 3)});
  ASSERT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
  double stow_s = 0;
  for (const PhaseRow& phase : run.log().phases()) {
    if (phase.rover_id == "B" && phase.phase == "stow") stow_s = seconds(phase.start);
  }
  ASSERT_GT(stow_s, 500);
  for (const SampleRow& row : run.samples()) {
    if (row.rover_id != "A") continue;
    const double time_s = seconds(row.time);
    if (time_s == 0 || time_s > stow_s + 1) {
      EXPECT_GT(row.sun_fraction, 0.95) << time_s;
    } else if (time_s > stow_s - 50 && time_s < stow_s) {
      EXPECT_LT(row.sun_fraction, 0.4) << time_s;
    }
  }
}

}  // namespace
}  // namespace lsos::test
