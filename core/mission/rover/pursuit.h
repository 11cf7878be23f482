// Following another rover along its track: where the follower enters the track, how fast it drives,
// and when it stands and waits.
#pragma once

#include <optional>
#include <string>

#include "driving/driven_track.h"
#include "mission/port/rover_port.h"
#include "vehicle/path_follower.h"

namespace lsos {

// The rover that is followed, as of this exchange.
struct Leader {
  const DrivenTrack& track;
  double speed_mps = 0;
  double half_length_m = 0;  // of its footprint
  bool has_ended = false;    // all its events had ended at the exchange before
};

class Pursuit {
 public:
  Pursuit() = default;  // to be read from an archive
  // `limits`: those of a drive at the greatest speed that is allowed. `half_length_m`: of the
  // follower's footprint.
  Pursuit(PursuitSettings settings, const FollowerLimits& limits, double half_length_m)
      : settings_(std::move(settings)), limits_(limits), half_length_m_(half_length_m) {}

  const std::string& leader_id() const { return settings_.leader_id; }
  // From the follower to the leader: straight to the track, then along it.
  double gap_m() const { return gap_m_; }
  // It stands until the leader has driven on.
  bool is_waiting() const { return is_waiting_; }
  bool has_ended() const { return has_ended_; }
  // It has seen its leader: before that it cannot know whether it must set off.
  bool has_begun() const { return has_begun_; }

  // At an exchange, after all rovers were read. `follower` is that of the drive; it is made when
  // the rover sets off.
  void update(const Leader& leader, const FollowerPose& pose,
              std::optional<PathFollower>& follower);

  // The follower was put elsewhere, at rest: its line must be made anew.
  void begin_again() { is_waiting_ = true; }

  void archive(Archive& a) {
    LSOS_ARCHIVE(a, settings_.leader_id, settings_.distance_m, settings_.speed_mps, limits_,
                 half_length_m_, end_S_m_, entry_S_m_, next_corner_, gap_m_, is_waiting_,
                 has_ended_, has_begun_);
  }

 private:
  void aim(const Leader& leader, const FollowerPose& pose, std::optional<PathFollower>& follower);
  void lengthen(const DrivenTrack& track, const FollowerPose& pose, PathFollower& follower);
  double speed_mps(const Leader& leader, const FollowerPose& pose) const;

  PursuitSettings settings_;
  FollowerLimits limits_;
  double half_length_m_ = 0;
  Vec2 end_S_m_ = Vec2::Zero();    // of the line that is followed
  Vec2 entry_S_m_ = Vec2::Zero();  // where it enters the track
  std::size_t next_corner_ = 0;    // of the track, the first that is not in the line
  double gap_m_ = 0;
  bool is_waiting_ = true, has_ended_ = false, has_begun_ = false;
};

}  // namespace lsos
