// Light of sky and ground through the whole program: plan, terrain script, rendering, log.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "system/plan_run.h"

namespace lsos::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

// Noon on Mars: the Sun stands some 80 degrees high.
constexpr const char* noon = "2012-10-17T10:30:00Z";
constexpr const char* meridiani = "-5.5,-2";

Mark on(const std::string& planet, const std::string& terrain, const std::string& start = noon) {
  return {"MissionInfo",
          {{"Planet", planet}, {"StartTime", start}, {"Terrain", terrain}, {"Seed", "1"}},
          ""};
}

Mark rover(const std::string& type, const std::string& at = meridiani) {
  return {"Rover", {{"RoverId", "R"}, {"RoverType", type}, {"InitialCharge", "0.5"}}, point(at)};
}

json light_at(const Words& more) {
  Words words{"sun"};
  words.insert(words.end(), more.begin(), more.end());
  const Outcome outcome = run(words);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return json::parse(outcome.out)[0];
}

// A flat panel on the roof under a free sky has all the light that falls on level ground.
TEST(DiffuseLight, of_a_level_panel_in_the_open_is_what_the_instrument_says) {
  for (const std::string planet : {"Mars", "Earth"}) {
    const std::string start = planet == "Mars" ? noon : "2026-03-20T12:10:00Z";
    const PlanRun run(
        {on(planet, "Flat", start), rover("SEV"), event("Pause", "R", 1, {{"Duration", "10"}})});
    ASSERT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
    const SampleRow row = run.samples().front();
    EXPECT_EQ(row.sun_fraction, 1);
    const json light = light_at({"--planet", planet, "--site", meridiani, "--at", start});
    const double level_wpm2 = light["level_wpm2"], diffuse_wpm2 = light["diffuse_wpm2"];
    EXPECT_GT(diffuse_wpm2, 50);
    EXPECT_NEAR(row.solar_available_w / (8 * 0.29 * 0.9 * level_wpm2), 1, 0.01) << planet;
    EXPECT_THAT(run.summary()["assumptions"].dump(),
                HasSubstr(planet == "Mars" ? "diffuse light: two-stream, optical depth 0.5"
                                           : "diffuse light: clear sky"));
  }
}

TEST(DiffuseLight, is_none_on_the_moon) {
  const PlanRun run({on("Moon", "Flat", "2026-01-01T00:00:00Z"), rover("SEV", "30,10"),
                     event("Pause", "R", 1, {{"Duration", "10"}})});
  ASSERT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
  EXPECT_THAT(run.summary()["assumptions"].dump(), HasSubstr("direct light alone"));
}

TEST(DiffuseLight, ends_with_the_day) {
  const PlanRun run({on("Mars", "Flat", "2012-10-17T22:00:00Z"), rover("SEV"),
                     event("Pause", "R", 1, {{"Duration", "10"}})});
  ASSERT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
  EXPECT_EQ(run.samples().front().solar_available_w, 0);
}

// The Sun stands low behind another rover. The panel in its shadow goes on with the light of the
// sky, but for what the other hides of that.
TEST(DiffuseLight, reaches_a_panel_in_the_shade) {
  const std::string morning = "2012-10-17T05:30:00Z";
  const auto first = [&](const std::string& other) {
    std::vector<Mark> plan{on("Mars", "Flat", morning), rover("MER"),
                           event("Pause", "R", 1, {{"Duration", "5"}})};
    if (!other.empty()) {
      plan.push_back(
          {"Rover", {{"RoverId", "X"}, {"RoverType", "SEV"}, {"Heading", "0"}}, point(other)});
    }
    for (const SampleRow& row : PlanRun(plan).samples()) {
      if (row.rover_id == "R") return row;
    }
    return SampleRow{};
  };
  const SampleRow alone = first(""), shaded = first("-5.4999,-2");  // 5.9 m to the east
  EXPECT_GT(alone.sun_fraction, 0.7);
  EXPECT_LT(shaded.sun_fraction, 0.3);
  // The share of a level panel's light that is diffuse. More than half of that is the aureole,
  // which is hidden with the Sun, and the other rover hides a part of the sky.
  const json light = light_at({"--planet", "Mars", "--site", meridiani, "--at", morning});
  const double diffuse = light["diffuse_wpm2"].get<double>() / light["level_wpm2"].get<double>();
  EXPECT_GT(shaded.solar_available_w, 0.25 * diffuse * alone.solar_available_w);
  EXPECT_LT(shaded.solar_available_w, 0.9 * alone.solar_available_w);
}

// Views that are kept while a rover stands are no state: driving, parked, on several threads and
// thrown away at each exchange, the log is the same.
TEST(DiffuseLight, repeats_and_survives_being_saved) {
  const std::vector<Mark> plan{
      on("Mars", "Slope"),
      rover("SEV"),
      {"Rover", {{"RoverId", "S"}, {"RoverType", "MER"}}, point("-5.4997,-2")},
      event("SteerSP", "R", 1),
      event("Route", "R", 2, {}, point("-5.4999,-1.9999")),
      event("Pause", "R", 3, {{"Duration", "60"}}),
      event("Pause", "S", 1, {{"Duration", "100"}})};
  const std::string digest = digest_of(TempFolder(), plan);
  EXPECT_EQ(digest_of(TempFolder(), plan, {"--threads", "2"}), digest);
  EXPECT_EQ(digest_of(TempFolder(), plan, {"--save-every-exchange"}), digest);
}

}  // namespace
}  // namespace lsos::test
