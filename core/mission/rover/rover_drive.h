// Drives of a rover: the path that it follows, the command to its vehicle, what ends a drive early,
// and whether the rover is parked.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mission/port/rover_port.h"
#include "mission/rover/drive_slip.h"
#include "mission/rover/foreseen_drive.h"
#include "mission/rover/pursuit.h"
#include "mission/rover/rover_motion.h"
#include "vehicle/path_follower.h"

namespace lsos {

class RoverDrive {
 public:
  // Both must outlive it.
  RoverDrive(RoverMotion& motion, RoverJournal& journal) : motion_(&motion), journal_(&journal) {}

  bool is_parked() const { return is_parked_; }
  // A drive goes on, though it may stand and wait for the rover that it follows.
  bool is_driving() const;
  bool is_under_way() const { return is_driving() && !(pursuit_ && pursuit_->is_waiting()); }
  // A pursuit has been commanded and begins at the next exchange, which a parked rover must not
  // sleep through.
  bool is_to_pursue() const {
    return pursuit_ && !pursuit_->has_begun() && is_driving() && motion_->fault().empty();
  }
  DriveState state() const;
  // Share 0..1 of the followed line that lies behind; 0 when it follows none, or another rover.
  double share() const;
  const DriveSlip& slip() const { return slip_; }

  // At an exchange, after the motion was read: counts slip, finds faults and hindrances, and
  // updates the path follower.
  void observe();
  // At an exchange, after scripts ran: gives the vehicle its command, and parks it when it rests.
  void control();

  void follow(const Path3& path_S_m, const FollowSettings& settings);
  void follow_rover(const PursuitSettings& settings);
  // The rover that it follows, "" when it follows none any more.
  std::string leader_id() const;
  // At an exchange, after all rovers have observed: keeps its distance to that rover.
  void pursue(const Leader& leader);
  void brake();
  // Has a parked rover stepped again until it rests, for what moves on it.
  void wake() { is_parked_ = false; }
  // The rover was put elsewhere, at rest: it goes on from there.
  void go_on_from_here();
  // The same for another stance, in which it may stand tilted again.
  void wake_in_other_stance() { is_parked_ = has_warned_of_tilt_ = false; }
  // Warns once a drive of a slope that is much steeper than FollowSettings::slope_max_rad.
  void warn_of_slope(SimTime now);
  // Warns of a rover on limbs that rests otherwise than it is to: tilted, or on its chassis.
  void warn_of_stance();
  // Ends the drive, when there is one, for a reason that it does not note.
  void fail(const std::string& reason);
  // Ends the drive because the rover would touch another or an asset, whose centre is `distance_m`
  // away. `ends_both`: the drive of the other one ends too.
  void end_before(const std::string& other_id, double distance_m, bool ends_both);

  // In an estimate drives are foreseen in place of followed: the rover counts as parked all the
  // time, and is carried along its line. A drive begins:
  void foresee(DriveEstimate estimate, SimTime now);
  // The same behind another rover.
  void foresee_pursuit(const PursuitSettings& settings);
  const std::optional<ForeseenDrive>& foreseen() const { return foreseen_; }
  bool is_foreseen_pursuit() const { return foreseen_pursuit_.has_value(); }
  // A foreseen drive takes it elsewhere.
  bool is_carried() const { return foreseen_ && !foreseen_->has_ended() && is_driving(); }
  // At an exchange: carries the rover to where it is then. Returns whether a drive has ended.
  bool carry(SimTime now);
  // What all its foreseen drives up to now may take less or more.
  const DriveDoubt& doubt() const { return doubt_; }
  // It has come to a mark of its drive, so that light and sight are due.
  bool has_passed_mark() const { return has_passed_mark_; }
  // Whether the rover that it follows has set off and it has not yet set off behind it.
  bool is_left_behind(const RoverDrive& leader) const;
  // At an exchange, after all rovers were carried: it drives where the leader is expected to drive,
  // up to the distance that it keeps. `on_line` estimates its drive along a line.
  void pursue_foreseen(const RoverDrive& leader, bool has_leader_ended, SimTime now,
                       const std::function<DriveEstimate(const Path3&)>& on_line);

  // Footprints, in order, up to where the rover would rest if it braked now: on its line when it
  // follows one, else straight ahead; while it turns on the spot, within a second. `beyond_m`:
  // farther by this along its line.
  std::vector<Footprint> footprints_ahead(double beyond_m = 0) const;
  // How far from another rover the drive ends, so that it can turn there; 0: it may rest as near as
  // its brakes allow.
  double room_to_turn_m() const { return is_under_way() ? room_to_turn_m_ : 0; }

  // Whether motion has ended since this was last cleared.
  bool has_motion_ended() const { return has_motion_ended_; }
  void clear_motion_ended() { has_motion_ended_ = false; }

  void archive(Archive& a);

 private:
  FollowerLimits limits(double speed_mps) const;
  DriveState foreseen_state() const;
  void update_slip();
  void find_hindrances();
  void give(const DriveCommand& command);
  void fail_with_note(const std::string& reason, const std::string& finding,
                      const std::string& fields_json);

  RoverMotion* motion_;
  RoverJournal* journal_;
  std::optional<PathFollower> follower_;
  std::optional<Pursuit> pursuit_;  // when it follows another rover
  // Not saved: estimates are not.
  struct ForeseenPursuit {
    PursuitSettings settings;
    std::optional<SimTime> left_at;  // when the leader's drive that it is behind began
    double gap_m = 0;
    bool has_ended = false;
  };
  std::optional<ForeseenDrive> foreseen_;
  std::optional<ForeseenPursuit> foreseen_pursuit_;
  DriveDoubt doubt_;
  bool has_passed_mark_ = false;
  DriveCommand command_;
  bool has_new_command_ = false;
  std::string blocker_id_;  // what it would have touched, "": nothing
  std::string failure_;     // why the present drive ended early, "" when it did not
  double room_to_turn_m_ = 0;
  double slope_max_rad_ = std::numeric_limits<double>::infinity();
  bool may_touch_with_chassis_ = false;  // high-centred when this drive began; may drive free
  bool is_parked_ = true;
  bool has_warned_of_tilt_ = false;  // in this stance
  int exchanges_at_rest_ = 0;
  bool has_motion_ended_ = false;
  DriveSlip slip_;
};

}  // namespace lsos
