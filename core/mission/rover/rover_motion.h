// The state of a rover's vehicle as of the last exchange, and why it can no longer drive.
#pragma once

#include <string>
#include <vector>

#include "base/archive.h"
#include "mission/rover/rover_journal.h"
#include "terrain/ground.h"
#include "vehicle/footprint.h"
#include "vehicle/part_pose.h"
#include "vehicle/vehicle.h"

namespace lsos {

class RoverMotion {
 public:
  // `config` must have all its links and, like `ground`, outlive it.
  RoverMotion(const VehicleConfig& config, const Ground& ground)
      : ground_(&ground), vehicle_(config, ground), at_rest_(lsos::footprint_at_rest(config)) {
    update_footprint();
  }

  Vehicle& vehicle() { return vehicle_; }
  const Vehicle& vehicle() const { return vehicle_; }
  const VehicleConfig& config() const { return vehicle_.config(); }
  const Ground& ground() const { return *ground_; }

  // In an estimate: the rover has come to a place without being stepped. `more_j`: what its drives
  // have used since it was last carried. Where the ground is not known it stays where it is.
  struct Carried {
    Vec3 p_S_m = Vec3::Zero();
    double heading_rad = 0;  // clockwise from north
    double more_m = 0, more_j = 0, drive_w = 0, speed_mps = 0;
  };
  void carry(const Carried& to);
  // Likewise: it stands in the stance that its limbs are moving to. It has posture control.
  void take_posture();

  // Reads the state of the vehicle. When its numbers are not finite, the last finite ones stay.
  void read();
  const VehicleReport& report() const { return report_; }
  // Whether limbs move although the rover stands.
  bool is_adjusting() const { return vehicle_.is_adjusting(); }
  const std::vector<double>& joints() const { return joints_; }  // m or rad
  double distance_m() const { return distance_m_; }
  double drive_w() const { return drive_w_; }
  double drive_j() const { return drive_j_; }
  Geodetic place() const { return ground_->site().geodetic(report_.p_S_m); }
  // Poses of the chassis and each link; with broken dynamics the last finite ones.
  std::vector<PartPose> part_poses() const;
  // Footprint after another `ahead_s` of the present motion.
  Footprint footprint(double ahead_s = 0) const;
  // As it stands: on limbs it follows the hubs' places while these move.
  const Footprint& footprint_at_rest() const { return at_rest_; }

  // Finds a fault after which the rover can no longer drive, and notes it.
  void find_fault(RoverJournal& journal);
  // Rolled over, left the terrain, numbers not finite; else "".
  const std::string& fault() const { return fault_; }
  bool is_broken() const { return is_broken_; }  // numbers are not finite: it stays where it is

  void archive(Archive& a);
  bool is_sound() const;

 private:
  void update_footprint();

  const Ground* ground_;
  Vehicle vehicle_;
  Footprint at_rest_;           // not saved: follows from the stance
  std::vector<Vec3> hubs_B_m_;  // on limbs: those of `at_rest_`
  VehicleReport report_;
  std::vector<double> joints_;
  double distance_m_ = 0, drive_w_ = 0, drive_j_ = 0;
  double carried_m_ = 0, carried_j_ = 0;  // not saved: estimates are not
  std::string fault_;
  bool is_broken_ = false;
};

}  // namespace lsos
