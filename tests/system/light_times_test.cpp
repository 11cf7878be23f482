// `lsos-host light` over a span of time, and `lsos-host sight --horizon`.
#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "system/plan_run.h"
#include "system/polar_raster.h"

namespace lsos::test {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;

std::vector<float> band(const std::string& file, int number) {
  GDALAllRegister();
  const GDALDatasetUniquePtr map(GDALDataset::FromHandle(GDALOpen(file.c_str(), GA_ReadOnly)));
  const int columns = map->GetRasterXSize(), rows = map->GetRasterYSize();
  std::vector<float> values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  EXPECT_EQ(map->GetRasterBand(number)->RasterIO(GF_Read, 0, 0, columns, rows, values.data(),
                                                 columns, rows, GDT_Float32, 0, 0),
            CE_None);
  return values;
}

Outcome light(const std::string& ground, const std::string& file, const Words& more) {
  Words words{"light",        ground,  "--window=-0.0378,-85.0033,0.0378,-84.9967",
              "--resolution", "20",    "-o",
              file,           "--json"};
  words.insert(words.end(), more.begin(), more.end());
  return run(words);
}

// Behind a ring of hills the low Sun comes and goes: three maps of one moment against one of all.
TEST(LightTimes, are_those_of_maps_of_each_moment) {
  const TempFolder folder;
  const std::string ground = raster(folder, "coarse", 260, 100), file = folder / "times.tif";
  const Outcome outcome =
      light(ground, file,
            {"--from", "2026-07-29T00:00:00Z", "--to", "2026-07-30T12:00:00Z", "--every", "12 h"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json answer = json::parse(outcome.out)[0];
  EXPECT_EQ(answer["moments"], 3);
  EXPECT_EQ(answer["from_utc"], "2026-07-29T00:00:00.000Z");
  const std::vector<float> mean = band(file, 1), dark_s = band(file, 2), lit_s = band(file, 3);
  std::vector<double> sum(mean.size()), dark(mean.size()), longest(mean.size());
  for (const char* at : {"2026-07-29T00:00:00Z", "2026-07-29T12:00:00Z", "2026-07-30T00:00:00Z"}) {
    const std::string one = folder / "one.tif";
    ASSERT_EQ(light(ground, one, {"--at", at}).exit_code, 0);
    const std::vector<float> shares = band(one, 1);
    ASSERT_EQ(shares.size(), mean.size());
    for (std::size_t k = 0; k < shares.size(); ++k) {
      sum[k] += shares[k] / 3;
      dark[k] = shares[k] > 0 ? 0 : dark[k] + 12 * 3600;
      longest[k] = std::max(longest[k], dark[k]);
    }
  }
  double apart = 0, all = 0;
  int same_dark = 0;
  for (std::size_t k = 0; k < mean.size(); ++k) {
    apart += std::abs(mean[k] - sum[k]) / static_cast<double>(mean.size());
    all += mean[k] / static_cast<double>(mean.size());
    same_dark += dark_s[k] == longest[k];
    EXPECT_LE(dark_s[k] + lit_s[k], 36 * 3600);
  }
  EXPECT_GT(all, 0.1);
  EXPECT_LT(all, 0.9);
  EXPECT_LT(apart, 0.01);
  EXPECT_GT(same_dark, 0.95 * static_cast<double>(mean.size()));
}

TEST(LightTimes, refuse_what_is_no_span_of_time) {
  const TempFolder folder;
  const auto refused = [&](const Words& times) {
    const Outcome outcome = light("Craters", folder / "no.tif", times);
    EXPECT_EQ(outcome.exit_code, 2);
    return outcome.err;
  };
  EXPECT_THAT(refused({}), HasSubstr("light: no time is given; --at UTC, or --from UTC --to UTC"));
  EXPECT_THAT(refused({"--from", "2026-07-01", "--at", "2026-07-01"}),
              AllOf(HasSubstr("--at: is for one moment"), HasSubstr("--to: is missing"),
                    HasSubstr("--every: is missing")));
  EXPECT_THAT(refused({"--from", "2026-07-02", "--to", "2026-07-01", "--every", "1 h"}),
              HasSubstr("--to 2026-07-01: must be later than --from"));
  EXPECT_THAT(refused({"--from", "2026-07-01", "--to", "2026-07-02", "--every", "2 d"}),
              HasSubstr("--every 2 d: 0.864 s to 86400 s are allowed in that span"));
  EXPECT_THAT(refused({"--from", "2026-07-01", "--to", "2026-07-02", "--every", "1e-9 s", "--site",
                       "nowhere"}),
              AllOf(HasSubstr("--every 1e-9 s: 0.864 s to"), HasSubstr("--site nowhere")));
  // Rounded to whole microseconds it would be no time at all.
  EXPECT_THAT(refused({"--from", "2026-07-01T00:00:00Z", "--to", "2026-07-01T00:00:00.010Z",
                       "--every", "1e-7 s"}),
              HasSubstr("--every 1e-7 s: 0.001 s to 0.01 s are allowed"));
  EXPECT_THAT(refused({"--from", "2026-07-01", "--to", "2026-07-02", "--every", "soon"}),
              HasSubstr("--every soon: "));
}

// The hills' own formula, searched in steps of 1 m over a sphere.
double highest_deg(double azimuth_rad, double eye_m) {
  double highest_rad = -1;
  for (double x_m = 1000; x_m < 8000; ++x_m) {
    const double up_m = height_m(x_m * std::sin(azimuth_rad), x_m * std::cos(azimuth_rad)) - eye_m;
    highest_rad = std::max(highest_rad, std::atan2(up_m - x_m * x_m / 2 / moon_radius_m, x_m));
  }
  return highest_rad * 180 / std::numbers::pi;
}

TEST(Horizon, is_that_of_the_hills_around) {
  const TempFolder folder;
  const std::string coarse = raster(folder, "coarse", 260, 100);
  const Outcome outcome =
      run({"sight", coarse, "--from", "0,-85,2", "--horizon", "--step", "5", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json rows = json::parse(outcome.out);
  ASSERT_EQ(rows.size(), 72u);
  for (const json& row : rows) {
    const double azimuth_deg = row["azimuth_deg"];
    // The raster's cells of 100 m cut crests of 300 m, and the map's scale is 0.2 % off.
    EXPECT_NEAR(row["elevation_deg"].get<double>(),
                highest_deg(azimuth_deg * std::numbers::pi / 180, 2), 0.15)
        << azimuth_deg;
    EXPECT_NEAR(row["distance_m"].get<double>(), 3900, 500) << azimuth_deg;
  }
}

TEST(Horizon, tells_where_the_ground_ends_too_soon) {
  const TempFolder folder;
  const Outcome outcome = run({"sight", raster(folder, "fine", 200, 5), "--from", "0,-85,2",
                               "--horizon", "--step", "30", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json rows = json::parse(outcome.out);
  ASSERT_EQ(rows.size(), 12u);
  EXPECT_NEAR(rows[0]["ground_reaches_m"].get<double>(), 500, 30);
  EXPECT_THAT(rows[0]["warnings"][0].get<std::string>(),
              HasSubstr("the ground ends before the horizon that counts in 12 of 12 directions"));
  EXPECT_THAT(outcome.err, HasSubstr("--beyond lays a coarser terrain around it"));
}

TEST(Horizon, refuses_what_does_not_go_with_it) {
  const auto refused = [](const Words& more) {
    Words words{"sight", "Craters", "--from", "31,20,2"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.exit_code, 2);
    return outcome.err;
  };
  EXPECT_THAT(refused({"--horizon", "--to", "31,20.1,2"}),
              HasSubstr("--horizon: is neither for lines of sight nor for a map"));
  EXPECT_THAT(refused({"--horizon", "--step", "100"}), HasSubstr("--step 100: 0.01..90 deg"));
  EXPECT_THAT(refused({"--step", "5", "--to", "31,20.1,2"}),
              HasSubstr("--step: is for a --horizon"));
  EXPECT_THAT(refused({}), HasSubstr("--height H -o OUT.tif or --horizon"));
}

}  // namespace
}  // namespace lsos::test
