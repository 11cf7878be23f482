// MER placed where Curiosity stood: 33 of its localisations between sols 960 and 1073 lie on the 1
// m HiRISE elevation model of Gale crater in the reference data. The test reads and projects the
// raster by other means than the program.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>

#include "record/log.h"
#include "support/reference_data.h"
#include "system/gale_ground.h"
#include "system/plan_text.h"
#include "system/run_folder.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;

constexpr double deg = std::numbers::pi / 180;

struct Attitude {
  double pitch_rad = 0, roll_rad = 0;
};

// Points of the raster under MER's wheels, in the rover's level frame: forward, right, up. The
// horizontal distances between wheels, which are shorter on a slope, are taken as on the level.
constexpr double half_base_m = 1.41 / 2;  // rovers/MER.lua
constexpr std::array<double, 3> forward_m{half_base_m, 0, -half_base_m}, right_m{0.53, 0.61, 0.53};
constexpr double track_m = 2 * (0.53 + 0.61 + 0.53) / 3;

Eigen::Matrix<double, 6, 3> ground_under_wheels(const GaleRaster& raster,
                                                const Localisation& stand) {
  const double north = std::cos(stand.yaw_rad), east = std::sin(stand.yaw_rad);
  Eigen::Matrix<double, 6, 3> points;
  for (int k = 0; k < 6; ++k) {
    const double x = forward_m[k % 3], y = k < 3 ? right_m[k % 3] : -right_m[k % 3];
    points.row(k) << x, y,
        raster.height_m(stand.easting_m + x * east + y * north,
                        stand.northing_m + x * north - y * east);
  }
  return points;
}

// Attitude of MER from the geometry of its suspension alone. A bogie's pivot is halfway between the
// middle and the rear wheel, so that each rocker leans on its front wheel and on the mean of those
// two, and the differential gives the body the mean pitch of both rockers. All of them turn about
// the body's y axis, so that the body rolls by the difference of the sides' mean heights.
double side_pitch_rad(const Eigen::Matrix<double, 6, 3>& points, int front) {
  const double rise_m = points(front, 2) - (points(front + 1, 2) + points(front + 2, 2)) / 2;
  return std::atan(rise_m / (1.5 * half_base_m));
}

Attitude stand_of_mer(const Eigen::Matrix<double, 6, 3>& points) {
  const double pitch_rad = (side_pitch_rad(points, 0) + side_pitch_rad(points, 3)) / 2;
  const double drop_m = points.col(2).tail<3>().mean() - points.col(2).head<3>().mean();
  return {pitch_rad, std::atan(drop_m / track_m * std::cos(pitch_rad))};
}

// Slope of the plane fitted by least squares.
double slope_rad(Eigen::Matrix<double, 6, 3> points) {
  const Eigen::Matrix<double, 6, 1> h_m = points.col(2);
  points.col(2).setOnes();
  return std::atan(points.colPivHouseholderQr().solve(h_m).eval().head<2>().norm());
}

// Groups the places so that the MERs of one plan stand clear of each other, in few groups.
std::vector<std::vector<Localisation>> clear_of_each_other(
    const std::vector<Localisation>& stands) {
  std::vector<std::vector<Localisation>> groups;
  for (const Localisation& stand : stands) {
    const auto is_clear = [&](const std::vector<Localisation>& group) {
      return std::ranges::none_of(group, [&](const Localisation& other) {
        return std::hypot(stand.easting_m - other.easting_m, stand.northing_m - other.northing_m) <
               5;
      });
    };
    auto group = std::ranges::find_if(groups, is_clear);
    if (group == groups.end()) group = groups.insert(group, std::vector<Localisation>{});
    group->push_back(stand);
  }
  return groups;
}

std::string id_of(const Localisation& stand) { return fmt::format("sol{:04}", stand.sol); }

// The first row of each rover's log.
std::map<std::string, SampleRow> placed(const std::vector<Localisation>& stands,
                                        const fs::path& raster) {
  const TempFolder folder;
  std::vector<Mark> marks{
      {"MissionInfo",
       {{"Planet", "Mars"}, {"StartTime", "2015-04-18T00:00:00Z"}, {"Terrain", raster}},
       ""}};
  for (const Localisation& stand : stands) {
    const std::string at = point(fmt::format("{:.9f},{:.9f}", stand.lon_deg(), stand.lat_deg()));
    const double heading_deg = std::fmod(stand.yaw_rad / deg + 360, 360);
    marks.push_back({"Rover",
                     {{"RoverId", id_of(stand)},
                      {"RoverType", "MER"},
                      {"Heading", fmt::format("{:.6f}", heading_deg)}},
                     at});
    marks.push_back(event("Pause", id_of(stand), 1, {{"Duration", "2"}}));
  }
  const Outcome outcome =
      run({folder.write("gale.kml", kml(marks)), "-o", folder / "run", "--quiet"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  std::map<std::string, SampleRow> rows;
  if (outcome.exit_code != 0) return rows;
  for (const SampleRow& row : LogReader(folder / "run" / "log.gpkg").samples()) {
    if (row.time == SimTime{}) rows[row.rover_id] = row;
  }
  return rows;
}

class Curiosity : public ::testing::Test {
 protected:
  void SetUp() override {
    LSOS_NEEDS_REFERENCE(gale_traverse);
    LSOS_NEEDS_REFERENCE(gale_raster);
  }

  std::vector<Localisation> stands_on(const GaleRaster& raster) const {
    std::vector<Localisation> stands;
    for (const TraverseRow& row : curiosity_traverse()) {
      if (raster.holds(row)) stands.push_back(row);
    }
    return stands;
  }

  const fs::path raster_file = reference_file(gale_raster);
};

// The meaning of the columns is documented nowhere, so it is derived from the rover's drives.
TEST_F(Curiosity, yaw_is_the_heading_clockwise_from_north) {
  const std::vector<TraverseRow> rows = curiosity_traverse();
  std::map<std::string, std::vector<double>> off_deg;  // by possible meaning of yaw
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double east_m = rows[i].easting_m - rows[i - 1].easting_m;
    const double north_m = rows[i].northing_m - rows[i - 1].northing_m;
    if (std::hypot(east_m, north_m) < 20) continue;
    const double drive_deg = std::atan2(east_m, north_m) / deg, yaw_deg = rows[i].yaw_rad / deg;
    const auto add = [&](const char* what, double heading_deg) {
      off_deg[what].push_back(std::abs(std::remainder(heading_deg - drive_deg, 360)));
    };
    add("clockwise from north", yaw_deg);
    add("counterclockwise from east", 90 - yaw_deg);
    add("counterclockwise from north", -yaw_deg);
  }
  std::map<std::string, double> median_deg;
  for (auto& [what, all] : off_deg) {
    std::ranges::nth_element(all, all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2));
    median_deg[what] = all[all.size() / 2];
    fmt::print("yaw {}: median {:.1f} deg off {} drives\n", what, median_deg[what], all.size());
  }
  EXPECT_LT(median_deg["clockwise from north"], 25);
  EXPECT_GT(median_deg["counterclockwise from east"], 45);
  EXPECT_GT(median_deg["counterclockwise from north"], 45);
}

// Planetographic latitudes would lie 3.3 km away. A few of the rows are damaged.
TEST_F(Curiosity, latitudes_are_planetocentric_on_the_sphere_of_the_raster) {
  int good = 0, damaged = 0;
  for (const TraverseRow& row : curiosity_traverse()) {
    const double off_m = std::hypot(row.easting_m - row.lon_as_written_deg * deg * mars_radius_m,
                                    row.northing_m - row.lat_as_written_deg * deg * mars_radius_m);
    ++(off_m < 0.05 ? good : damaged);
  }
  EXPECT_GT(good, 500);
  EXPECT_LT(damaged, 20);
}

// The heights of the localisations and of the raster come from the same HiRISE stereo pairs.
TEST_F(Curiosity, stood_at_the_height_of_the_raster) {
  const GaleRaster raster(raster_file);
  const std::vector<Localisation> stands = stands_on(raster);
  ASSERT_EQ(stands.size(), 33u);
  for (const Localisation& stand : stands) {
    EXPECT_NEAR(raster.height_m(stand.easting_m, stand.northing_m), stand.elevation_m, 0.2)
        << stand.sol;
  }
}

// Greatest turn of the body about the vertical when MER is lowered with its rockers in line: they
// turn against each other, nose up on the right by `angle_rad` and down on the left, about pivots
// 0.45 m above the wheels. The turn is that large when no wheel moves, and smaller when they roll.
double turn_by_rockers_rad(const Eigen::Matrix<double, 6, 3>& points) {
  const double angle_rad = (side_pitch_rad(points, 0) - side_pitch_rad(points, 3)) / 2;
  return std::atan(2 * 0.45 * std::sin(angle_rad) / track_m);
}

// Compares MER at rest with the raster and its suspension at the place where it came to rest.
void expect_rest(const SampleRow& row, const Localisation& stand, const GaleRaster& raster) {
  const Localisation rest{.sol = stand.sol,
                          .easting_m = row.place.lon_rad * mars_radius_m,
                          .northing_m = row.place.lat_rad * mars_radius_m,
                          .yaw_rad = row.heading_rad};
  const Eigen::Matrix<double, 6, 3> points = ground_under_wheels(raster, rest);
  // On a slope the springs deflect a little and shift the rover.
  EXPECT_LT(std::hypot(rest.easting_m - stand.easting_m, rest.northing_m - stand.northing_m), 0.03);
  const double turn_rad = std::remainder(row.heading_rad - stand.yaw_rad, 360 * deg);
  EXPECT_LT(std::abs(turn_rad), std::abs(turn_by_rockers_rad(points)) + 0.1 * deg);
  EXPECT_NEAR(row.elevation_m, raster.height_m(rest.easting_m, rest.northing_m), 0.001);
  EXPECT_EQ(row.speed_mps, 0);
  EXPECT_TRUE(std::isnan(row.slip));
  EXPECT_GT(row.sinkage_m, 0.001);
  EXPECT_LT(row.sinkage_m, 0.03);  // a quarter of its wheels' radius

  const Attitude wanted = stand_of_mer(points);
  EXPECT_NEAR(row.pitch_rad, wanted.pitch_rad, 0.25 * deg);
  EXPECT_NEAR(row.roll_rad, wanted.roll_rad, 0.25 * deg);
  EXPECT_NEAR(row.slope_rad, slope_rad(points), 0.35 * deg);
  const double tilt_rad = std::acos(std::cos(row.pitch_rad) * std::cos(row.roll_rad));
  fmt::print("{:4} {:9.2f} {:8.2f} {:8.2f} | {:9.2f} {:8.2f} | {:8.2f}\n", stand.sol,
             row.pitch_rad / deg, row.roll_rad / deg, tilt_rad / deg, wanted.pitch_rad / deg,
             wanted.roll_rad / deg, turn_rad / deg);
}

TEST_F(Curiosity, ground_carries_mer_as_its_suspension_says) {
  const GaleRaster raster(raster_file);
  const std::vector<Localisation> stands = stands_on(raster);
  std::map<std::string, SampleRow> rows;
  for (const std::vector<Localisation>& group : clear_of_each_other(stands)) {
    rows.merge(placed(group, raster_file));
  }
  ASSERT_EQ(rows.size(), 33u);
  fmt::print(" sol pitch_deg roll_deg tilt_deg |  by its suspension | turn_deg\n");
  for (const Localisation& stand : stands) {
    SCOPED_TRACE(id_of(stand));
    expect_rest(rows.at(id_of(stand)), stand, raster);
  }
}

}  // namespace
}  // namespace lsos::test
