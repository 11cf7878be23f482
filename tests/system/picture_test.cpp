// `lsos-host picture` and `lsos-host light`: files of the view from the Sun.
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "record/log.h"
#include "system/run_folder.h"

namespace lsos::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class SunPicture : public ::testing::Test {
 protected:
  // MER's mast and antenna stand in front of the Sun, which is 30 degrees high.
  SunPicture() {
    const std::string plan = folder.write(
        "plan.kml",
        kml({mission(),
             {"Rover", {{"RoverId", "R"}, {"RoverType", "MER"}, {"Heading", "90"}}, point("-27,0")},
             event("Pause", "R", 1, {{"Duration", "20"}})}));
    EXPECT_EQ(run({plan, "-o", folder / "run", "--quiet"}).exit_code, 0);
  }
  Outcome picture(const Words& more) const {
    Words words{"picture", folder / "run", "-o", folder / "sun.png"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }

  TempFolder folder;
};

TEST_F(SunPicture, shows_as_much_green_as_the_log_says) {
  const Outcome outcome = picture({"--at", "10", "--size", "1024"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json answer = json::parse(outcome.out)[0];
  EXPECT_THAT(read_text(folder / "sun.png"), StartsWith("\x89PNG"));
  EXPECT_EQ(answer["utc"], "2026-01-01T00:00:10.000Z");
  const double logged = LogReader(folder / "run/log.gpkg").samples()[5].sun_fraction;
  EXPECT_LT(logged, 0.99);
  EXPECT_GT(logged, 0.5);
  EXPECT_NEAR(answer["seen_share"].get<double>(), logged, 0.02);
}

TEST_F(SunPicture, says_what_it_cannot_show) {
  EXPECT_THAT(picture({"--at", "noon"}).err, HasSubstr("--at noon: UTC or a time from the start"));
  EXPECT_THAT(picture({"--at", "1", "--rover", "S"}).err,
              HasSubstr("--rover S: the run has no such rover"));
  EXPECT_THAT(picture({"--at", "9 h"}).err,
              HasSubstr("--at 9 h: the run is from 2026-01-01T00:00:00.000Z to "));
  const Outcome nowhere = run({"picture", folder / "none", "--at", "1", "-o", folder / "x.png"});
  EXPECT_EQ(nowhere.exit_code, 2);
}

TEST(LightMap, is_lit_by_day_and_dark_by_night) {
  const TempFolder folder;
  const auto light = [&](const std::string& at) {
    const Outcome outcome =
        run({"light", "Flat", "--planet", "Moon", "--at", at, "--window=29.99,9.99,30.01,10.01",
             "--resolution", "50", "-o", folder / "light.tif", "--threads", "2"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(outcome.out)[0];
  };
  const json night = light("2026-01-15T00:00:00Z"), day = light("2026-01-01T00:00:00Z");
  EXPECT_EQ(day["mean_sun_fraction"], 1);
  EXPECT_EQ(night["mean_sun_fraction"], 0);
  EXPECT_EQ(day["columns"], 12);
  // The Sun is 78.38 degrees high (lsos-host sun).
  const Outcome place =
      run_command({"gdallocationinfo", "-valonly", folder / "light.tif", "6", "6"});
  EXPECT_THAT(place.out, StartsWith("1\n"));
  EXPECT_NEAR(std::stod(place.out.substr(2)), std::sin(78.38 * 3.14159265 / 180), 1e-3);
}

}  // namespace
}  // namespace lsos::test
