// The study that drives MSL where Curiosity drove, against what Curiosity told of itself.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/QR>

#include <cmath>

#include "record/log.h"
#include "support/reference_data.h"
#include "system/gale_ground.h"
#include "system/run_folder.h"
#include "system/source_files.h"

namespace lsos::test {
namespace {

constexpr double deg = std::numbers::pi / 180;

// Where the wheels of rovers/MSL.lua stand: forward and to the right, m.
constexpr double base_m[3] = {1.1, 0, -1.1}, side_m[3] = {1.15, 1.2, 1.15};

// Slope of the plane fitted by least squares to the raster under the wheels.
double slope_rad(const GaleRaster& raster, const Localisation& stand) {
  const double north = std::cos(stand.yaw_rad), east = std::sin(stand.yaw_rad);
  Eigen::Matrix<double, 6, 3> points;
  Eigen::Matrix<double, 6, 1> height_m;
  for (int k = 0; k < 6; ++k) {
    const double x_m = base_m[k % 3], y_m = k < 3 ? side_m[k % 3] : -side_m[k % 3];
    points.row(k) << x_m, y_m, 1;
    height_m(k) = raster.height_m(stand.easting_m + x_m * east + y_m * north,
                                  stand.northing_m + x_m * north - y_m * east);
  }
  return std::atan(points.colPivHouseholderQr().solve(height_m).eval().head<2>().norm());
}

// The first sample of a rover from that time on.
SampleRow sample_at(const std::vector<SampleRow>& samples, SimTime time) {
  return *std::ranges::find_if(samples, [&](const SampleRow& row) { return row.time >= time; });
}

TEST(CuriosityReplay, drives_where_curiosity_drove) {
  LSOS_NEEDS_REFERENCE(gale_traverse);
  LSOS_NEEDS_REFERENCE(gale_raster);
  const TempFolder folder;
  const Outcome made =
      run_command({"python3", "-B", repository() / "script/studies/curiosity_replay.py",
                   folder.path().string(), reference_folder().string()});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const Outcome outcome =
      run({folder / "curiosity_replay.kml", "-o", folder / "run", "--no-report", "--quiet"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;

  const GaleRaster raster(reference_file(gale_raster));
  std::vector<TraverseRow> stands;
  for (const TraverseRow& row : curiosity_traverse()) {
    if (row.sol >= 960 && row.sol <= 1073) stands.push_back(row);
  }
  const LogReader log(folder / "run" / "log.gpkg");
  const std::vector<EventRow> events = log.events();
  const std::vector<SampleRow> samples = log.samples();
  ASSERT_EQ(events.size() + 1, stands.size());
  double driven_m = 0, own_m = 0, tilt2 = 0;
  fmt::print(" sol | driven_m  own_m straight_m | tilt_deg of_ground_deg | height_m off\n");
  for (std::size_t k = 0; k < events.size(); ++k) {
    const TraverseRow &from = stands[k], &to = stands[k + 1];
    SCOPED_TRACE(to.sol);
    const SampleRow row = sample_at(samples, *events[k].end);
    const Localisation rest{.sol = to.sol,
                            .easting_m = row.place.lon_rad * mars_radius_m,
                            .northing_m = row.place.lat_rad * mars_radius_m,
                            .elevation_m = row.elevation_m,
                            .yaw_rad = row.heading_rad};
    const double straight_m =
        std::hypot(to.easting_m - from.easting_m, to.northing_m - from.northing_m);
    const double off_m = std::hypot(rest.easting_m - to.easting_m, rest.northing_m - to.northing_m);
    EXPECT_LT(off_m, 0.35);
    EXPECT_GT(events[k].distance_m, straight_m - 1);
    EXPECT_NEAR(row.elevation_m, to.elevation_m, 0.3);
    const double tilt_rad = std::acos(std::cos(row.pitch_rad) * std::cos(row.roll_rad));
    const double ground_rad = slope_rad(raster, rest);
    EXPECT_NEAR(tilt_rad, ground_rad, 3 * deg);
    tilt2 += std::pow(tilt_rad - ground_rad, 2);
    driven_m += events[k].distance_m;
    own_m += to.driven_m;
    fmt::print("{:4} | {:8.1f} {:6.1f} {:10.1f} | {:8.1f} {:13.1f} | {:8.2f} {:.2f}\n", to.sol,
               events[k].distance_m, to.driven_m, straight_m, tilt_rad / deg, ground_rad / deg,
               row.elevation_m - to.elevation_m, off_m);
  }
  const double tilt_rms_rad = std::sqrt(tilt2 / static_cast<double>(events.size()));
  fmt::print("driven {:.1f} m, Curiosity {:.1f} m; tilt {:.2f} deg RMS off the ground's\n",
             driven_m, own_m, tilt_rms_rad / deg);
  // Curiosity also drove to and fro for what it looked at, which its positions do not tell.
  EXPECT_GT(driven_m, 0.8 * own_m);
  EXPECT_LT(driven_m, 1.05 * own_m);
  EXPECT_LT(tilt_rms_rad, 1 * deg);
}

}  // namespace
}  // namespace lsos::test
