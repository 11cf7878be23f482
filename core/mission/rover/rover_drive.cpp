#include "mission/rover/rover_drive.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/moment_text.h"
#include "base/units.h"
#include "mission/port/note_json.h"
#include "mission/routes/follower_limits.h"
#include "vehicle/follower_pose.h"
#include "vehicle/limb_hindrance.h"
#include "vehicle/limb_stance.h"

namespace lsos {

namespace {

constexpr double at_rest_mps = 0.005;       // speed below which a braked rover is at rest
constexpr double level_within_rad = 0.035;  // tilt up to which a rover counts as level (2 deg)
constexpr int exchanges_until_parked = 5;   // exchanges at rest after which it is parked
// Behind another rover corners are rounded more than on a line of its own: where the leader turned
// on the spot and drove on, a follower that did the same would fall back.
constexpr double pursuit_offset_m = 1.0, pursuit_steering_m = 2;
constexpr double pursuit_radius_share = 0.5;  // of the least radius, for what turns on the spot
// How far from what it goes round a route keeps the rover, beyond what it needs to turn
// (RouteCost::cross_track_margin_m), and a little more.
constexpr double turning_margin_m = 0.5;

// Distance from its front at which a rover that turns about its reference point touches nothing.
double room_to_turn_m(const Footprint& at_rest) {
  const Vec2 farthest_m = at_rest.center_S_m.cwiseAbs() + at_rest.half_m;
  return farthest_m.norm() - (at_rest.center_S_m.x() + at_rest.half_m.x()) + turning_margin_m;
}

}  // namespace

bool RoverDrive::is_driving() const {
  if (!failure_.empty() || (pursuit_ && pursuit_->has_ended())) return false;
  if (foreseen_pursuit_) return !foreseen_pursuit_->has_ended;
  if (foreseen_) return !foreseen_->has_ended();
  return follower_ ? follower_->status() == PathFollower::Status::driving : pursuit_.has_value();
}

DriveState RoverDrive::state() const {
  if (foreseen_ || foreseen_pursuit_) return foreseen_state();
  if (!follower_ && !pursuit_) return {};
  DriveState state;
  state.status = DriveState::Status::failed;
  state.reason = motion_->fault();
  state.remaining_m = pursuit_ ? pursuit_->gap_m() : follower_->remaining_m();
  if (follower_) state.next_point = follower_->next_waypoint();
  if (follower_) state.is_backward = follower_->is_backward();
  if (!motion_->fault().empty()) return state;
  state.reason = failure_;
  state.is_blocked = !failure_.empty();
  state.blocked_by = blocker_id_;
  if (state.is_blocked) return state;
  if (is_driving()) {
    state.status = DriveState::Status::driving;
  } else if (pursuit_ && pursuit_->has_ended()) {
    state.status = DriveState::Status::arrived;
  } else if (follower_->status() == PathFollower::Status::arrived) {
    state.status = DriveState::Status::arrived;
    state.remaining_m = 0;
  } else {
    state.reason = follower_->reason();
    state.is_blocked = follower_->is_stuck();
  }
  return state;
}

void RoverDrive::give(const DriveCommand& command) {
  command_ = command;
  has_new_command_ = true;
}

void RoverDrive::observe() {
  // What moves on a rover that is carried has had it stepped: it goes on as foreseen.
  if (foreseen_ || foreseen_pursuit_) {
    is_parked_ = true;
    return;
  }
  update_slip();
  if (motion_->fault().empty()) motion_->find_fault(*journal_);
  if (!motion_->fault().empty()) return give({});
  if (is_under_way()) find_hindrances();
  if (!is_under_way()) return;
  const VehicleReport& report = motion_->report();
  give(follower_->update(follower_pose(report), seconds(exchange_period)));
  if (follower_->is_stuck()) {
    journal_->note("stuck", fmt::format(R"({{"remaining_m":{},"sinkage_m":{},"slip":{}}})",
                                        note_json(follower_->remaining_m()),
                                        note_json(report.sinkage_m), note_json(report.slip)));
    if (report.is_chassis_on_ground) {
      failure_ = follower_->reason() + "; its chassis touches the ground";
    }
  } else if (follower_->is_off_line()) {
    journal_->note("strayed",
                   fmt::format(R"({{"remaining_m":{}}})", note_json(follower_->remaining_m())));
  }
}

// Counts the slip of the period just ended, under the command given before it.
void RoverDrive::update_slip() {
  const VehicleReport& report = motion_->report();
  DriveSlip::Motion motion;
  motion.command_mps = std::hypot(command_.speed_mps, command_.left_mps);
  motion.is_commanded = is_under_way() && !command_.is_braking && motion.command_mps > 0;
  if (motion.is_commanded) motion.requested_mps = follower_->requested_mps();
  motion.cruise_mps = motion_->config().cruise_speed_mps;
  motion.speed_mps = report.speed_mps;
  motion.slip = report.slip;
  motion.slip_max = report.slip_max;
  slip_.add(motion);
}

// Finds failures that end the drive alone: a script may try again on another route.
void RoverDrive::find_hindrances() {
  if (!motion_->report().is_chassis_on_ground) {
    may_touch_with_chassis_ = false;
  } else if (!may_touch_with_chassis_) {
    fail_with_note(
        fmt::format("high-centred: its chassis touches the ground, {:.1f} m before the end",
                    follower_->remaining_m()),
        "high_centred",
        fmt::format(R"({{"remaining_m":{}}})", note_json(follower_->remaining_m())));
  }
}

void RoverDrive::fail(const std::string& reason) {
  if (!is_driving()) return;
  failure_ = reason;
  give({});
}

void RoverDrive::fail_with_note(const std::string& reason, const std::string& finding,
                                const std::string& fields_json) {
  fail(reason);
  journal_->note(finding, fields_json);
}

void RoverDrive::end_before(const std::string& other_id, double distance_m, bool ends_both) {
  if (!is_under_way()) return;
  const std::string& id = journal_->rover_id();
  std::string reason =
      fmt::format("would touch {}, whose centre is {:.1f} m away", other_id, distance_m);
  std::string ended;
  if (ends_both) {
    reason = fmt::format("{} {}; the drives of both end", id, reason);
    ended = fmt::format(R"("ended":[{},{}],)", note_json(std::min(id, other_id)),
                        note_json(std::max(id, other_id)));
  }
  fail_with_note(reason, "would_touch",
                 fmt::format(R"({{"distance_m":{},{}"other":{}}})", note_json(distance_m), ended,
                             note_json(other_id)));
  blocker_id_ = other_id;
}

void RoverDrive::control() {
  if (has_new_command_) {
    if (!command_.is_braking) is_parked_ = false;
    if (!is_parked_) motion_->vehicle().command(command_);
    has_new_command_ = false;
  }
  if (is_parked_) return;
  const bool rests = command_.is_braking && !is_under_way() && !motion_->is_adjusting() &&
                     motion_->report().speed_mps < at_rest_mps;
  exchanges_at_rest_ = rests ? exchanges_at_rest_ + 1 : 0;
  if (exchanges_at_rest_ >= exchanges_until_parked || !motion_->fault().empty()) {
    is_parked_ = has_motion_ended_ = true;
    exchanges_at_rest_ = 0;
    motion_->vehicle().halt();
    if (!motion_->is_broken()) motion_->read();
    warn_of_stance();
  }
}

void RoverDrive::warn_of_stance() {
  const Vehicle& vehicle = motion_->vehicle();
  if (!motion_->fault().empty() || vehicle.posture() == nullptr) return;
  const VehicleReport& report = motion_->report();
  const double tilt_rad = std::acos(std::cos(report.pitch_rad) * std::cos(report.roll_rad));
  const bool is_tilted = vehicle.stands_level() && tilt_rad > level_within_rad;
  // It is said once for each stance: a drive over a slope may park many times.
  if (is_tilted && !std::exchange(has_warned_of_tilt_, true)) {
    const std::string hindrance = limbs_hindrance(vehicle);
    journal_->warn(fmt::format("{}: stands tilted by {:.1f} deg, though it is to be level{}",
                               journal_->rover_id(), degrees(tilt_rad),
                               hindrance.empty() ? "" : ": " + hindrance));
  }
  // What a drive ended with is said already, and what it began with.
  const bool is_new = failure_.empty() && !may_touch_with_chassis_;
  may_touch_with_chassis_ = report.is_chassis_on_ground;
  if (!report.is_chassis_on_ground || !is_new) return;
  journal_->note("chassis_on_ground", "{}");
  journal_->warn(fmt::format(
      "{}: its chassis rests on the ground, not on its limbs alone; it is {:.2f} m over "
      "the middle of its wheels' ground",
      journal_->rover_id(), height_m(vehicle.config(), vehicle.hubs_B_m())));
}

void RoverDrive::warn_of_slope(SimTime now) {
  // Routes are planned for a plane through the wheels' ground; a wheel on a rock tilts it a little.
  constexpr double beyond_rad = radians(2);
  const VehicleReport& report = motion_->report();
  if (!is_under_way() || !(report.slope_rad > slope_max_rad_ + beyond_rad)) return;
  const bool turns = command_.speed_mps == 0 && command_.left_mps == 0;
  const Geodetic place = motion_->place();
  journal_->note("steep",
                 fmt::format(R"({{"allowed_rad":{},"slope_rad":{},"turns_on_spot":{}}})",
                             note_json(slope_max_rad_), note_json(report.slope_rad), turns));
  journal_->warn(fmt::format(
      "{}: at {} it {} on a slope of {:.1f} deg, {:.1f} deg are allowed, at {:.6f}, {:.6f}",
      journal_->rover_id(), moment_text(now), turns ? "turns on the spot" : "drives",
      degrees(report.slope_rad), degrees(slope_max_rad_), lon_deg(place), lat_deg(place)));
  slope_max_rad_ = std::numeric_limits<double>::infinity();  // once a drive
}

void RoverDrive::follow(const Path3& path_S_m, const FollowSettings& settings) {
  const VehicleConfig& config = motion_->config();
  if (settings.speed_mps && *settings.speed_mps > config.speed_max_mps) {
    journal_->warn(fmt::format("{}: commanded to drive at {:.3g} m/s, a {} does {:.3g} m/s at most",
                               journal_->rover_id(), *settings.speed_mps, config.type,
                               config.speed_max_mps));
  }
  FollowerLimits limits = this->limits(settings.speed_mps.value_or(config.cruise_speed_mps));
  limits.arrival_radius_m = settings.arrival_radius_m;
  limits.cross_track_max_m = settings.cross_track_max_m;
  limits.is_crabbing = settings.is_crabbing && config.can_crab;
  if (settings.is_crabbing && !config.can_crab) {
    journal_->warn(fmt::format("{}: commanded to crab, a {} cannot; it turns instead",
                               journal_->rover_id(), config.type));
  }
  const VehicleReport& report = motion_->report();
  pursuit_.reset();
  failure_.clear();
  blocker_id_.clear();
  may_touch_with_chassis_ = report.is_chassis_on_ground;
  room_to_turn_m_ =
      settings.keeps_room_to_turn ? lsos::room_to_turn_m(motion_->footprint_at_rest()) : 0;
  slope_max_rad_ = settings.slope_max_rad;
  follower_.emplace(path_S_m, follower_pose(report), limits, settings.gear_changes);
  if (!motion_->fault().empty()) return;
  give(follower_->update(follower_pose(report), seconds(exchange_period)));
}

FollowerLimits RoverDrive::limits(double speed_mps) const {
  return limits_of(motion_->config(), speed_mps,
                   motion_->ground().site().gravity_S_mps2(Vec3::Zero()).norm());
}

void RoverDrive::follow_rover(const PursuitSettings& settings) {
  brake();
  may_touch_with_chassis_ = motion_->report().is_chassis_on_ground;
  const double speed_mps = settings.speed_mps.value_or(motion_->config().speed_max_mps);
  FollowerLimits limits = this->limits(speed_mps);
  limits.corner_offset_m = pursuit_offset_m;
  limits.steering_m = pursuit_steering_m;
  if (limits.can_turn_on_spot) limits.radius_min_m *= pursuit_radius_share;
  pursuit_.emplace(settings, limits, motion_->footprint_at_rest().half_m.x());
}

void RoverDrive::pursue(const Leader& leader) {
  if (!is_driving() || !motion_->fault().empty()) return;
  const FollowerPose pose = follower_pose(motion_->report());
  const bool was_under_way = is_under_way();
  pursuit_->update(leader, pose, follower_);
  if (is_under_way() == was_under_way) return;
  // It stops, or sets off; while it drives, observe() commands it.
  give(was_under_way ? DriveCommand{} : follower_->update(pose, seconds(exchange_period)));
}

void RoverDrive::brake() {
  follower_.reset();
  pursuit_.reset();
  foreseen_.reset();
  foreseen_pursuit_.reset();
  failure_.clear();
  blocker_id_.clear();
  room_to_turn_m_ = 0;
  give({});
}

void RoverDrive::go_on_from_here() {
  is_parked_ = has_warned_of_tilt_ = false;
  exchanges_at_rest_ = 0;
  may_touch_with_chassis_ = motion_->report().is_chassis_on_ground;
  give({});
  if (!is_driving()) return;
  if (pursuit_) {
    follower_.reset();
    pursuit_->begin_again();
  } else {
    follower_->begin_again(follower_pose(motion_->report()));
  }
}

std::vector<Footprint> RoverDrive::footprints_ahead(double beyond_m) const {
  constexpr double step_m = 0.25, turning_s = 1;
  constexpr double turning_mps = 0.1;     // below this speed a rover that turns does so on the spot
  constexpr double braking_max_m = 1000;  // nothing farther away is looked for, however it slides
  const VehicleReport& report = motion_->report();
  const Footprint& at_rest = motion_->footprint_at_rest();
  const Vec2 p_m = report.p_S_m.head<2>(), v_mps = report.v_S_mps.head<2>();
  const double braking_s =
      v_mps.norm() / (2 * motion_->config().acceleration_mps2) + seconds(exchange_period);
  const double braking_m = std::min(braking_max_m, braking_s * v_mps.norm());
  std::vector<Footprint> footprints;
  if (v_mps.norm() < turning_mps) {
    double turn_rad = turning_s * report.yaw_rate_radps;
    if (is_under_way()) {
      const double left_rad = follower_->turn_remaining_rad(report.yaw_rad);
      turn_rad = std::clamp(turn_rad, std::min(0.0, left_rad), std::max(0.0, left_rad));
    }
    footprints.push_back(moved(at_rest, p_m, report.yaw_rad + turn_rad));
  }
  if (is_under_way()) {
    for (const FollowerPose& pose :
         follower_->poses_ahead(follower_pose(report), braking_m + beyond_m, step_m)) {
      footprints.push_back(moved(at_rest, pose.p_S_m, pose.yaw_rad));
    }
  } else {
    footprints.push_back(moved(at_rest, p_m, report.yaw_rad, braking_s * v_mps));
  }
  return footprints;
}

void RoverDrive::archive(Archive& a) {
  LSOS_ARCHIVE(a, follower_, pursuit_, command_, has_new_command_, blocker_id_, failure_,
               room_to_turn_m_, slope_max_rad_, may_touch_with_chassis_, is_parked_,
               has_warned_of_tilt_, exchanges_at_rest_, has_motion_ended_, slip_);
}

}  // namespace lsos
