#include "mission/routes/drive_estimate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/segment.h"
#include "base/units.h"
#include "driving/driving_line.h"
#include "route/cost/stance_drive.h"
#include "route/map/ground_map.h"

namespace lsos {

namespace {

constexpr double passed_radius_m = 1;  // as in PathFollower
// Distance between the places of a drawn line whose ground is examined, and between those that one
// map of the ground serves.
constexpr double sample_m = 2, map_m = 64;
// Length beyond which only every second, third, ... stretch that a map serves is examined.
constexpr double examined_m = 30e3;
constexpr double stuck_s = 60;           // in which a rover that gets nowhere is found to be stuck
constexpr double turn_least_rad = 0.03;  // as in PathFollower

// The line that a rover drives on a path: points that it stands on are behind it, as in
// PathFollower.
DriveEstimate line_of_drive(const Vec3& from_S_m, const Path3& path_S_m,
                            const FollowSettings& settings) {
  DriveEstimate drive;
  const double here_m = std::min(settings.arrival_radius_m, passed_radius_m);
  const auto is_within = [&](const Vec3& p_S_m, double radius_m) {
    return (p_S_m - from_S_m).head<2>().norm() <= radius_m;
  };
  std::size_t first = 0;
  if (settings.gear_changes.empty()) {
    while (first + 1 < path_S_m.size() && is_within(path_S_m[first], here_m)) ++first;
  } else if (is_within(path_S_m.front(), passed_radius_m)) {
    ++first;
  }
  drive.line_S_m = {from_S_m};
  drive.line_S_m.insert(drive.line_S_m.end(), path_S_m.begin() + static_cast<std::ptrdiff_t>(first),
                        path_S_m.end());
  drive.path_begins_at = 1 - static_cast<std::ptrdiff_t>(first);
  for (const std::size_t at : settings.gear_changes) {
    drive.gear_changes.push_back(at < first ? 0 : at - first + 1);
  }
  drive.marks = {{}};
  // A rover that stands on the last one does not move.
  if (first + 1 >= path_S_m.size() && is_within(path_S_m.back(), here_m)) {
    drive.line_S_m.resize(1);
    drive.gear_changes.clear();
  }
  return drive;
}

double length_m(const Path3& line_S_m) {
  double sum_m = 0;
  for (std::size_t k = 1; k < line_S_m.size(); ++k) {
    sum_m += (line_S_m[k] - line_S_m[k - 1]).head<2>().norm();
  }
  return sum_m;
}

// Adds marks up to `end`, evenly and no farther apart than they may be.
void add_marks(DriveEstimate& drive, const DriveMark& end) {
  const DriveMark begin = drive.marks.back();
  const double along_m = end.along_m - begin.along_m;
  const int parts = std::max(1, static_cast<int>(std::ceil(along_m / mark_spacing_m)));
  for (int k = 1; k <= parts; ++k) {
    const double share = static_cast<double>(k) / parts;
    drive.marks.push_back({std::lerp(begin.along_m, end.along_m, share),
                           std::lerp(begin.driven_m, end.driven_m, share),
                           std::lerp(begin.time_s, end.time_s, share),
                           std::lerp(begin.energy_j, end.energy_j, share)});
  }
}

// Ground under a stretch of a line: what steady driving takes there.
struct Steady {
  double along_m = 0, driven_m = 0, time_s = 0, energy_j = 0;
};

class DrawnDrive {
 public:
  DrawnDrive(const Ground& ground, const DriveCost& cost, const FollowerLimits& limits)
      : ground_(ground), finder_(cost), cost_(cost), limits_(limits) {
    // The mean deceleration that speeding up amounts to, by the time that it loses.
    const double up_s = cost.stop_s - cost.speed_mps / (2 * cost.acceleration_mps2);
    up_mps2_ = up_s > 0 ? std::min(cost.acceleration_mps2, cost.speed_mps / (2 * up_s))
                        : cost.acceleration_mps2;
  }

  DriveEstimate run(DriveEstimate drive, double yaw_rad) {
    drive_ = std::move(drive);
    height_m_ = drive_.line_S_m.front().z();
    if (cost_.soils.front().by_slope.empty()) return fail("its wheels cannot drive on this soil");
    const std::vector<DrivingPiece> pieces = line();
    Vec2 ahead(std::cos(yaw_rad), std::sin(yaw_rad));
    bool was_backward = false;
    const bool swings = !cost_.can_turn_on_spot && !pieces.empty() && !pieces.front().is_backward;
    if (swings) swing(yaw_rad, pieces.front());
    for (const DrivingPiece& piece : pieces) {
      const Vec2 heading = piece.is_backward ? Vec2(-piece.along_S) : piece.along_S;
      if (speed_mps_ <= 0 && cost_.can_turn_on_spot) turn(std::abs(bend_rad(ahead, heading)));
      if (piece.is_backward != was_backward) sum_.time_s += steering_lag_s;
      was_backward = piece.is_backward;
      ahead = heading;
      if (!drive_piece(piece)) break;
      if (sum_.along_m - drive_.marks.back().along_m >= mark_spacing_m / 2) add_mark();
    }
    add_mark();
    drive_.slack = slack_.slack();
    return std::move(drive_);
  }

 private:
  std::vector<DrivingPiece> line() const {
    DrivingLimits limits;
    limits.speed_mps = limits_.speed_mps;
    limits.acceleration_mps2 = limits.lateral_mps2 = limits_.acceleration_mps2;
    limits.radius_min_m = limits_.radius_min_m;
    limits.can_turn_on_spot = limits_.can_turn_on_spot;
    std::vector<Vec2> points_S_m;
    for (const Vec3& p_S_m : drive_.line_S_m) points_S_m.push_back(p_S_m.head<2>());
    return driving_line(points_S_m, limits, drive_.gear_changes);
  }

  void add_mark() {
    if (sum_.along_m > drive_.marks.back().along_m || sum_.time_s > drive_.marks.back().time_s) {
      add_marks(drive_, sum_);
    }
  }

  DriveEstimate fail(const std::string& why) {
    drive_.failure = why;
    drive_.is_blocked = true;
    sum_.time_s += stuck_s;
    add_marks(drive_, sum_);
    return std::move(drive_);
  }

  void turn(double by_rad) {
    if (by_rad < turn_least_rad) return;
    const double takes_s = cost_.steer_s + cost_.turn_sprad * by_rad;
    sum_.time_s += takes_s;
    sum_.energy_j += cost_.turn_jprad * by_rad + cost_.idle_w * takes_s;
  }

  // A rover that cannot turn on the spot leaves the line as it sets off another way than it stands:
  // it turns past the line's direction and back, in its tightest arcs, until it is on the line.
  void swing(double yaw_rad, const DrivingPiece& first) {
    const Vec2 ahead(std::cos(yaw_rad), std::sin(yaw_rad));
    const double by_rad = std::abs(bend_rad(ahead, first.along_S));
    if (by_rad < turn_least_rad) return;
    // What the first arc leads aside, the second leads back.
    const double past_rad = std::acos((1 + std::cos(by_rad)) / 2);
    const double detour_m =
        limits_.radius_min_m * (by_rad + 2 * past_rad - std::sin(by_rad) - 2 * std::sin(past_rad));
    const SlopeDrive level = cost_.soils.front().at(0);
    sum_.driven_m += detour_m;
    sum_.time_s += detour_m / level.speed_mps;
    sum_.energy_j += detour_m * level.energy_jpm;
  }

  // Returns false where the drive ends before the end of the piece.
  bool drive_piece(const DrivingPiece& piece) {
    const int parts = std::max(1, static_cast<int>(std::ceil(piece.length_m / map_m)));
    const int every = 1 + static_cast<int>(piece.length_m / examined_m);
    Steady steady;
    for (int k = 0; k < parts; ++k) {
      const double begin_m = piece.length_m * k / parts, end_m = piece.length_m * (k + 1) / parts;
      if (k % every == 0) steady = steady_over(piece, begin_m, end_m);
      const double left_m = piece.length_m - end_m;
      const double end_mps = std::sqrt(piece.end_speed_mps * piece.end_speed_mps +
                                       2 * cost_.acceleration_mps2 * left_m);
      add(steady, piece.speed_max_mps, end_mps);
      if (drive_.failure.empty()) continue;
      sum_.time_s += stuck_s;
      speed_mps_ = 0;
      return false;
    }
    if (piece.ends_in_stop) speed_mps_ = 0;
    return true;
  }

  // Adds a stretch that begins at the present speed and ends at `end_mps` at most.
  void add(const Steady& steady, double most_mps, double end_mps) {
    sum_.along_m += steady.along_m;
    sum_.driven_m += steady.driven_m;
    if (steady.time_s <= 0) return;
    const double steady_mps = steady.driven_m / steady.time_s;
    const double cruise_mps = std::max(least_mps, std::min(most_mps, steady_mps));
    const double begin2 = speed_mps_ * speed_mps_, end2 = end_mps * end_mps;
    const double down_mps2 = cost_.acceleration_mps2;
    // Up to a peak and down again where there is no room to reach the full speed.
    const double peak2 = (2 * steady.driven_m + begin2 / up_mps2_ + end2 / down_mps2) /
                         (1 / up_mps2_ + 1 / down_mps2);
    const double peak_mps = std::max(least_mps, std::min(cruise_mps, std::sqrt(peak2)));
    const double last_mps = std::min(peak_mps, end_mps);
    const double up_mps = std::max(0.0, peak_mps - speed_mps_), down_mps = peak_mps - last_mps;
    const double up_m = up_mps * (peak_mps + speed_mps_) / 2 / up_mps2_;
    const double down_m = down_mps * (peak_mps + last_mps) / 2 / down_mps2;
    const double takes_s = up_mps / up_mps2_ + down_mps / down_mps2 +
                           std::max(0.0, steady.driven_m - up_m - down_m) / peak_mps;
    const double gained = std::max(0.0, peak_mps * peak_mps - begin2);
    sum_.time_s += takes_s;
    sum_.energy_j += steady.energy_j + cost_.stop_j * gained / (cost_.speed_mps * cost_.speed_mps) +
                     cost_.idle_w * std::max(0.0, takes_s - steady.time_s);
    speed_mps_ = last_mps;
  }

  // Where the ground is too steep or unknown the stretch ends, and says so.
  Steady steady_over(const DrivingPiece& piece, double begin_m, double end_m) {
    const auto at_S_m = [&](double along_m) -> Vec3 {
      const Vec2 at_m = piece.from_S_m + along_m * piece.along_S;
      return {at_m.x(), at_m.y(), height_m_};
    };
    const MapFrame frame(ground_.site(), at_S_m(begin_m));
    const Vec2 to_m = frame.at(at_S_m(end_m));
    const double spacing_m = map_spacing_m(cost_);
    const Vec2 aside_m = Vec2::Constant(finder_.reach_m() + 3 * spacing_m);
    GroundMap map(ground_, frame, to_m.cwiseMin(0) - aside_m, to_m.cwiseMax(0) + aside_m,
                  spacing_m);
    const double length_m = end_m - begin_m;
    const int steps = std::max(1, static_cast<int>(std::ceil(length_m / sample_m)));
    const Vec2 ahead = to_m.normalized();
    Steady sum;
    for (int k = 0; k < steps; ++k) {
      const Stance stance = finder_.at(map, to_m * ((k + 0.5) / steps), ahead);
      if (!find_failure(stance)) return sum;
      const SlopeDrive driven = stance_drive(cost_, stance);
      const double along_m = length_m / steps / std::cos(stance.pitch_rad);
      sum.along_m += length_m / steps;
      sum.driven_m += along_m;
      sum.time_s += along_m / driven.speed_mps;
      sum.energy_j += along_m * driven.energy_jpm;
      slack_.add(along_m / driven.speed_mps, along_m * driven.energy_jpm, driven.slip);
    }
    return sum;
  }

  // Returns false where the drive ends. One steep place alone may be a rock.
  bool find_failure(const Stance& stance) {
    if (!stance.is_on_ground) {
      drive_.failure = "it leads where the terrain is not known";
      return false;
    }
    const SoilDrive& soil = cost_.soils[static_cast<std::size_t>(stance.soil)];
    const bool is_steep = stance.pitch_rad > soil.last_rad();
    steep_ = is_steep ? steep_ + 1 : 0;
    if (steep_ < steep_places) return true;
    drive_.failure =
        fmt::format("stuck: the ground rises by {:.0f} deg, its wheels climb {:.0f} deg",
                    degrees(stance.pitch_rad), degrees(soil.last_rad()));
    drive_.is_blocked = true;
    return false;
  }

  static constexpr double least_mps = 0.01;
  static constexpr int steep_places = 2;

  const Ground& ground_;
  StanceFinder finder_;
  const DriveCost& cost_;
  const FollowerLimits& limits_;
  double up_mps2_;
  double height_m_ = 0;  // in S, where the drive begins
  double speed_mps_ = 0;
  int steep_ = 0;  // places one after another that are too steep
  DriveMark sum_;
  DriveSlackSum slack_;
  DriveEstimate drive_;
};

}  // namespace

DriveEstimate estimate_planned(const DriveCost& cost, const Vec3& from_S_m,
                               const PlannedRoute& route, const FollowSettings& settings) {
  DriveEstimate drive = line_of_drive(from_S_m, route.path_S_m, settings);
  if (drive.line_S_m.size() < 2) return drive;
  drive.slack = line_slack(cost, drive.line_S_m);
  // Legs lie on the line from its beginning on, which the rover is near.
  double planned_m = 0, before_m = 0;
  for (const PlannedRoute::Leg& leg : route.legs) planned_m += leg.length_m;
  const double line_m = length_m(drive.line_S_m);
  DriveMark sum;
  for (const PlannedRoute::Leg& leg : route.legs) {
    before_m += leg.length_m;
    sum.along_m = planned_m > 0 ? line_m * before_m / planned_m : line_m;
    sum.driven_m += leg.length_m;
    sum.time_s += leg.duration_s;
    sum.energy_j += leg.energy_j;
    add_marks(drive, sum);
  }
  return drive;
}

DriveEstimate estimate_drawn(const Ground& ground, const DriveCost& cost,
                             const FollowerLimits& limits, const Vec3& from_S_m, double yaw_rad,
                             const Path3& path_S_m, const FollowSettings& settings) {
  DriveEstimate drive = line_of_drive(from_S_m, path_S_m, settings);
  if (drive.line_S_m.size() < 2) return drive;
  return DrawnDrive(ground, cost, limits).run(std::move(drive), yaw_rad);
}

}  // namespace lsos
