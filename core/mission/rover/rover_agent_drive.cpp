// Driving of a rover: planning a route, following it, and what ends a drive.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "mission/port/note_json.h"
#include "mission/routes/drive_cost_model.h"
#include "mission/rover/rover_agent.h"

namespace lsos {

namespace {

constexpr double lookahead_least_m = 0.6;  // least lookahead of the path follower, for small rovers

FollowerPose pose_of(const VehicleReport& report) {
  const Vec2 left_S(-std::sin(report.yaw_rad), std::cos(report.yaw_rad));
  return {report.p_S_m.head<2>(), report.yaw_rad,
          report.speed_mps,       left_S.dot(report.v_S_mps.head<2>()),
          report.pitch_rad,       report.roll_rad};
}

}  // namespace

std::vector<Footprint> RoverAgent::footprints_ahead() const {
  constexpr double step_m = 0.25, turning_s = 1;
  constexpr double turning_mps = 0.1;  // below this speed a rover that turns does so on the spot
  const Vec2 p_m = report_.p_S_m.head<2>(), v_mps = report_.v_S_mps.head<2>();
  const double braking_s =
      v_mps.norm() / (2 * vehicle_.config().acceleration_mps2) + seconds(exchange_period);
  const double braking_m = braking_s * v_mps.norm();
  std::vector<Footprint> footprints;
  if (v_mps.norm() < turning_mps) {
    double turn_rad = turning_s * report_.yaw_rate_radps;
    if (is_driving()) {
      const double left_rad = follower_->turn_remaining_rad(report_.yaw_rad);
      turn_rad = std::clamp(turn_rad, std::min(0.0, left_rad), std::max(0.0, left_rad));
    }
    footprints.push_back(moved(footprint_at_rest_, p_m, report_.yaw_rad + turn_rad));
  }
  if (is_driving()) {
    for (const FollowerPose& pose : follower_->poses_ahead(pose_of(report_), braking_m, step_m)) {
      footprints.push_back(moved(footprint_at_rest_, pose.p_S_m, pose.yaw_rad));
    }
  } else {
    footprints.push_back(moved(footprint_at_rest_, p_m, report_.yaw_rad, braking_s * v_mps));
  }
  return footprints;
}

void RoverAgent::follow_path() {
  if (!is_driving()) return;
  find_hindrances();
  if (!is_driving()) return;
  command_ = follower_->update(pose_of(report_), seconds(exchange_period));
  has_new_command_ = true;
  if (follower_->is_stuck()) {
    note("stuck", fmt::format(R"({{"remaining_m":{},"sinkage_m":{},"slip":{}}})",
                              note_json(follower_->remaining_m()), note_json(report_.sinkage_m),
                              note_json(report_.slip)));
  } else if (follower_->is_off_line()) {
    note("strayed", fmt::format(R"({{"remaining_m":{}}})", note_json(follower_->remaining_m())));
  }
}

// Counts the slip of the period just ended, under the command given before it.
void RoverAgent::update_slip() {
  DriveSlip::Motion motion;
  motion.command_mps = std::hypot(command_.speed_mps, command_.left_mps);
  motion.is_commanded = is_driving() && !command_.is_braking && motion.command_mps > 0;
  if (motion.is_commanded) motion.requested_mps = follower_->requested_mps();
  motion.cruise_mps = vehicle_.config().cruise_speed_mps;
  motion.speed_mps = report_.speed_mps;
  motion.slip = report_.slip;
  motion.slip_max = report_.slip_max;
  slip_.add(motion);
}

bool RoverAgent::is_driving() const {
  return follower_ && follower_->status() == PathFollower::Status::driving &&
         drive_failure_.empty();
}

// Finds failures that end the drive alone: a script may try again on another route.
void RoverAgent::find_hindrances() {
  if (!report_.is_chassis_on_ground) {
    may_touch_with_chassis_ = false;
  } else if (!may_touch_with_chassis_) {
    fail_drive("high_centred",
               fmt::format("high-centred: its chassis touches the ground, {:.1f} m before the end",
                           follower_->remaining_m()),
               fmt::format(R"({{"remaining_m":{}}})", note_json(follower_->remaining_m())));
  }
}

void RoverAgent::fail_drive(const std::string& finding, const std::string& reason,
                            const std::string& fields_json) {
  drive_failure_ = reason;
  command_ = {};
  has_new_command_ = true;
  note(finding, fields_json);
}

void RoverAgent::end_drive_before(const std::string& other_id, double distance_m) {
  if (!is_driving()) return;
  fail_drive(
      "would_touch",
      fmt::format("would touch {}, whose centre is {:.1f} m away", other_id, distance_m),
      fmt::format(R"({{"distance_m":{},"other":{}}})", note_json(distance_m), note_json(other_id)));
}

DriveState RoverAgent::drive() const {
  if (!follower_) return {};
  DriveState drive{DriveState::Status::failed, fault_, follower_->remaining_m()};
  drive.next_point = follower_->next_waypoint();
  if (!fault_.empty()) return drive;
  drive.reason = drive_failure_;
  drive.is_blocked = !drive_failure_.empty();
  if (drive.is_blocked) return drive;
  drive.reason = follower_->reason();
  drive.is_blocked = follower_->is_stuck();
  if (follower_->status() == PathFollower::Status::driving) {
    drive.status = DriveState::Status::driving;
  } else if (follower_->status() == PathFollower::Status::arrived) {
    drive.status = DriveState::Status::arrived;
    drive.remaining_m = 0;
  }
  return drive;
}

double RoverAgent::drive_share() const { return follower_ ? follower_->share() : 0; }

void RoverAgent::follow(const Path3& path_S_m, const FollowSettings& settings) {
  const VehicleConfig& config = vehicle_.config();
  if (settings.speed_mps && *settings.speed_mps > config.speed_max_mps) {
    warnings_.push_back(
        fmt::format("{}: commanded to drive at {:.3g} m/s, a {} does {:.3g} m/s at most", rover_.id,
                    *settings.speed_mps, config.type, config.speed_max_mps));
  }
  FollowerLimits limits;
  limits.speed_mps =
      std::min(settings.speed_mps.value_or(config.cruise_speed_mps), config.speed_max_mps);
  limits.level_speed_mps = std::max(limits.speed_mps, config.cruise_speed_mps);
  limits.acceleration_mps2 = config.acceleration_mps2;
  limits.gravity_mps2 = ground_->site().gravity_S_mps2(Vec3::Zero()).norm();
  limits.arrival_radius_m = settings.arrival_radius_m;
  limits.can_turn_on_spot = config.can_turn_on_spot;
  limits.radius_min_m = config.turning_radius_min_m;
  limits.turn_rate_radps = turn_rate_radps(config);
  limits.lookahead_min_m = std::max(lookahead_least_m, wheel_reach_m(config));
  limits.cross_track_max_m = settings.cross_track_max_m;
  limits.is_crabbing = settings.is_crabbing && config.can_crab;
  if (settings.is_crabbing && !config.can_crab) {
    warnings_.push_back(fmt::format("{}: commanded to crab, a {} cannot; it turns instead",
                                    rover_.id, config.type));
  }
  drive_failure_.clear();
  may_touch_with_chassis_ = report_.is_chassis_on_ground;
  follower_.emplace(path_S_m, pose_of(report_), limits);
  if (!fault_.empty()) return;
  command_ = follower_->update(pose_of(report_), seconds(exchange_period));
  has_new_command_ = true;
}

void RoverAgent::brake() {
  follower_.reset();
  drive_failure_.clear();
  command_ = {};
  has_new_command_ = true;
}

PlannedRoute RoverAgent::plan_path(const Path3& waypoints_S_m, std::int64_t first,
                                   const RouteSettings& settings) {
  PlannedRoute way = routes_.plan(rover_.id, now_, noting_sequence_,
                                  {view_.p_S_m, view_.heading_rad}, waypoints_S_m, first, settings);
  for (std::string& warning : routes_.take_warnings()) warnings_.push_back(std::move(warning));
  return way;
}

std::optional<GroundView> RoverAgent::ground_at(const Vec3& p_S_m) const {
  const GroundSample sample = Ground::Probe(*ground_).sample(p_S_m);
  if (!sample.is_ground()) return {};
  return GroundView{p_S_m - sample.gap_m * sample.up_S, sample.elevation_m,
                    std::acos(std::clamp(sample.normal_S.dot(sample.up_S), -1.0, 1.0)),
                    ground_->soils()[static_cast<std::size_t>(sample.soil)].name};
}

Vec3 RoverAgent::ahead_S_m(double distance_m) const {
  const SiteFrame& site = ground_->site();
  const Vec3& p_S_m = view_.p_S_m;
  const Vec3 there_S_m = p_S_m + distance_m * (std::cos(view_.heading_rad) * site.north_S(p_S_m) +
                                               std::sin(view_.heading_rad) * site.east_S(p_S_m));
  Geodetic there = site.geodetic(there_S_m);
  there.height_m = ground_->elevation_m(there).value_or(there.height_m);
  return site.p_S_m(there);
}

}  // namespace lsos
