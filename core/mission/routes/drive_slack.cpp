#include "mission/routes/drive_slack.h"

#include <algorithm>
#include <cmath>

namespace lsos {

namespace {

// Slip beyond which a rover is stuck rather than slow.
constexpr double slip_most = 0.9;
// Length over which the slope of a line is taken, m.
constexpr double stretch_m = 2;

// Metres rolled a metre of ground, as a share of those at the slip expected.
double rolled_share(double slip, double other_slip) { return (1 - slip) / (1 - other_slip); }

}  // namespace

DriveDoubt& DriveDoubt::operator+=(const DriveDoubt& other) {
  early_s += other.early_s;
  late_s += other.late_s;
  less_j += other.less_j;
  more_j += other.more_j;
  driven_j += other.driven_j;
  return *this;
}

DriveDoubt DriveDoubt::operator-(const DriveDoubt& other) const {
  return {early_s - other.early_s, late_s - other.late_s, less_j - other.less_j,
          more_j - other.more_j, driven_j - other.driven_j};
}

void DriveSlackSum::add(double time_s, double energy_j, double slip) {
  const double known = std::clamp(slip, 0.0, slip_most);
  const double low = rolled_share(known, (1 - slip_error) * known);
  const double high = rolled_share(known, std::min((1 + slip_error) * known, slip_most));
  time_s_ += time_s;
  low_s_ += time_s * low;
  high_s_ += time_s * high;
  energy_j_ += energy_j;
  low_j_ += energy_j * low;
  high_j_ += energy_j * high;
}

DriveSlack DriveSlackSum::slack() const {
  DriveSlack slack;
  if (time_s_ > 0) {
    slack.time_low = (1 - drive_time_error) * low_s_ / time_s_;
    slack.time_high = (1 + drive_time_error) * high_s_ / time_s_;
  }
  if (energy_j_ > 0) {
    slack.energy_low = (1 - drive_energy_error) * low_j_ / energy_j_;
    slack.energy_high = (1 + drive_energy_error) * high_j_ / energy_j_;
  }
  return slack;
}

DriveSlack line_slack(const DriveCost& cost, const Path3& line_S_m) {
  DriveSlackSum sum;
  const SoilDrive& soil = cost.soils.front();
  if (soil.by_slope.empty()) return sum.slack();
  for (std::size_t from = 0, to = 1; to < line_S_m.size(); ++to) {
    const Vec3 along_m = line_S_m[to] - line_S_m[from];
    const double level_m = along_m.head<2>().norm();
    if (level_m < stretch_m && to + 1 < line_S_m.size()) continue;
    from = to;
    if (level_m <= 0) continue;
    const SlopeDrive drive = soil.at(std::atan2(along_m.z(), level_m));
    sum.add(along_m.norm() / drive.speed_mps, along_m.norm() * drive.energy_jpm, drive.slip);
  }
  return sum.slack();
}

}  // namespace lsos
