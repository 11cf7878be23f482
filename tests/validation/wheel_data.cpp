#include "validation/wheel_data.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <stdexcept>
#include <utility>

#include "base/units.h"

namespace lsos::validation {

namespace {

using Row = std::map<std::string, std::string>;

// Fields may be in double quotes, as those with commas are; no field of these files contains a
// quote or a line break.
std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> answer(1);
  bool is_quoted = false;
  for (const char c : line) {
    if (c == '"') {
      is_quoted = !is_quoted;
    } else if (c == ',' && !is_quoted) {
      answer.emplace_back();
    } else if (c != '\r') {
      answer.back() += c;
    }
  }
  return answer;
}

std::vector<Row> read_rows(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot read " + path);
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> names = fields(line);
  std::vector<Row> rows;
  while (std::getline(in, line)) {
    const std::vector<std::string> values = fields(line);
    if (values.size() != names.size()) throw std::runtime_error(path + ": ragged: " + line);
    Row row;
    for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = values[i];
    rows.push_back(std::move(row));
  }
  return rows;
}

// All of these are metal wheels on a rigid axle, flattened by less than a micrometre.
constexpr double rigid_npm = 1e9;

double number(const Row& row, const std::string& name) { return std::stod(row.at(name)); }

void sort(std::vector<MeasuredPoint>& points) {
  std::ranges::sort(points, {},
                    [](const MeasuredPoint& p) { return std::pair(p.slip_angle_rad, p.slip); });
}

MeasuredPoint mean(const std::vector<MeasuredPoint>& repeats) {
  MeasuredPoint answer = repeats.front();
  answer.repeats = static_cast<int>(repeats.size());
  // Sets the member to its mean; returns greatest minus least.
  const auto average = [&](double MeasuredPoint::*member) {
    const auto [least, greatest] = std::ranges::minmax(repeats, {}, member);
    double sum = 0;
    for (const MeasuredPoint& p : repeats) sum += p.*member;
    answer.*member = sum / answer.repeats;
    return greatest.*member - least.*member;
  };
  average(&MeasuredPoint::slip);
  average(&MeasuredPoint::load_n);
  answer.pull_spread_n = average(&MeasuredPoint::drawbar_pull_n);
  answer.side_spread_n = average(&MeasuredPoint::side_force_n);
  answer.sinkage_spread_m = average(&MeasuredPoint::sinkage_m);
  return answer;
}

}  // namespace

std::string data_folder() {
  const char* set = std::getenv("LSOS_REFERENCE_DATA");
  return std::string(set != nullptr ? set : LSOS_SOURCE_DIR "/../shared/data") + "/terramech";
}

WheelTests read_cmu_tests(const std::string& folder, bool has_grousers) {
  constexpr double tip_radius_m = 0.0625;
  WheelTests tests;
  tests.wheel = {.radius_m = tip_radius_m, .width_m = 0.060, .normal_stiffness_npm = rigid_npm};
  if (has_grousers) {  // by the rig's mesh
    tests.wheel.radius_m = 0.0574;
    tests.wheel.grouser_height_m = 0.0049;
    tests.wheel.grouser_count = 24;
  }
  const char* file =
      has_grousers ? "/cmu_single_wheel_grouser.csv" : "/cmu_single_wheel_smooth.csv";
  std::map<std::pair<double, double>, std::vector<MeasuredPoint>> by_setting;
  for (const Row& row : read_rows(folder + file)) {
    const double slip_angle_deg = number(row, "beta_deg");
    // The sensor's axes are rotated against those of the wheel.
    by_setting[{slip_angle_deg, number(row, "rim_speed_cmd_mm_s")}].push_back(
        {.slip = number(row, "slip_reported"),
         .slip_radius_m = tip_radius_m,
         .slip_angle_rad = radians(slip_angle_deg),
         .load_n = -number(row, "Fz_sensor_N"),
         .drawbar_pull_n = -number(row, "Fy_sensor_N"),
         .side_force_n = -number(row, "Fx_sensor_N"),
         .sinkage_m = -number(row, "Z_mm") / 1000});
  }
  for (const auto& [setting, repeats] : by_setting) tests.points.push_back(mean(repeats));
  sort(tests.points);
  return tests;
}

WheelTests read_published_tests(const std::string& folder, const std::string& source,
                                bool has_grousers) {
  WheelTests tests;
  const char* file =
      has_grousers ? "/single_wheel_grousered_published.csv" : "/single_wheel_smooth_published.csv";
  for (const Row& row : read_rows(folder + file)) {
    if (row.at("source") != source) continue;
    tests.wheel = {.radius_m = number(row, "wheel_radius_m"),
                   .width_m = number(row, "wheel_width_m"),
                   .normal_stiffness_npm = rigid_npm,
                   .grouser_height_m = number(row, "grouser_height_m"),
                   .grouser_count = std::stoi(row.at("grouser_count"))};
    tests.points.push_back({.slip = number(row, "slip"),
                            .slip_radius_m = tests.wheel.radius_m,
                            .load_n = number(row, "vertical_load_n"),
                            .drawbar_pull_n = number(row, "meas_drawbar_pull_n"),
                            .torque_n_m = number(row, "meas_torque_nm"),
                            .sinkage_m = number(row, "meas_sinkage_m")});
  }
  if (tests.points.empty()) throw std::runtime_error("no rows of " + source + " in " + folder);
  sort(tests.points);
  return tests;
}

}  // namespace lsos::validation
