// Measurements of single wheels in a soil bin, read from the reference data. Load, slip and slip
// angle are prescribed; forces and sinkage are measured.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "vehicle/vehicle_config.h"

namespace lsos::validation {

inline constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

// One setting of the rig, averaged over its repeats.
struct MeasuredPoint {
  double slip = 0;  // as single_wheel.h defines it, but by slip_radius_m
  double slip_radius_m = 0;
  double slip_angle_rad = 0;
  int repeats = 1;
  double load_n = 0;
  double drawbar_pull_n = 0;
  double side_force_n = not_measured;  // left positive, travel to the left of the heading
  double torque_n_m = not_measured;
  double sinkage_m = 0;
  // Range (greatest minus least) of the repeats.
  double pull_spread_n = 0, side_spread_n = 0, sinkage_spread_m = 0;
};

struct WheelTests {
  Wheel wheel;
  std::vector<MeasuredPoint> points;  // sorted by slip angle, then slip
};

// Folder of the data (LSOS_REFERENCE_DATA or ../shared/data, then terramech); may not exist.
std::string data_folder();

// Both throw std::runtime_error when the folder has no such file or the file no such column.
// The CMU rig counts slip by half the diameter of 125 mm, over the tips of grousers.
WheelTests read_cmu_tests(const std::string& folder, bool has_grousers);
// `source`: a value of the column of that name, "ding2011" or "wang_han_2016_kls1". Slip is counted
// by the rim.
WheelTests read_published_tests(const std::string& folder, const std::string& source,
                                bool has_grousers);

}  // namespace lsos::validation
