#include "mission/rover/rover_motion.h"

#include <fmt/format.h>

#include <cmath>

#include "base/units.h"
#include "mission/port/note_json.h"
#include "vehicle/limb_stance.h"

namespace lsos {

namespace {

constexpr double rolled_over_rad = 1.2;  // tilt of the chassis (69 deg)

}  // namespace

void RoverMotion::read() {
  const VehicleReport report = vehicle_.report();
  if (!report.is_finite) {
    report_.is_finite = false;  // keep the last finite numbers for the log
    return;
  }
  report_ = report;
  joints_ = vehicle_.joint_positions();
  distance_m_ = carried_m_ + vehicle_.distance_m();
  drive_w_ = vehicle_.drive_w();
  drive_j_ = carried_j_ + vehicle_.drive_j();
  update_footprint();
}

void RoverMotion::carry(const Carried& to) {
  carried_m_ += to.more_m;
  carried_j_ += to.more_j;
  vehicle_.put_down(ground_->site().geodetic(to.p_S_m), to.heading_rad, joints_);
  read();
  drive_w_ = to.drive_w;
  if (report_.is_finite) report_.speed_mps = to.speed_mps;
}

void RoverMotion::take_posture() {
  const PostureControl& posture = *vehicle_.posture();
  vehicle_.stand_on(posture.target_hubs_B_m(), posture.is_level());
  carry({report_.p_S_m, report_.heading_rad});
}

void RoverMotion::update_footprint() {
  const PostureControl* posture = vehicle_.posture();
  if (posture == nullptr || posture->hubs_B_m() == hubs_B_m_) return;
  hubs_B_m_ = posture->hubs_B_m();
  VehicleConfig standing = config();
  stand(standing, hubs_B_m_);
  at_rest_ = lsos::footprint_at_rest(standing);
}

std::vector<PartPose> RoverMotion::part_poses() const {
  if (!is_broken_) return vehicle_.part_poses();
  PartPose chassis = chassis_pose(ground_->site(), report_.p_S_m, report_.heading_rad,
                                  report_.pitch_rad, report_.roll_rad);
  chassis.p_S_m -= chassis.R_SB * reference_B_m(config(), joints_);
  return lsos::part_poses(config(), chassis, joints_);
}

Footprint RoverMotion::footprint(double ahead_s) const {
  return moved(at_rest_, (report_.p_S_m + ahead_s * report_.v_S_mps).head<2>(),
               report_.yaw_rad + ahead_s * report_.yaw_rate_radps, Vec2::Zero());
}

void RoverMotion::find_fault(RoverJournal& journal) {
  if (!report_.is_finite) {
    is_broken_ = true;
    fault_ = vehicle_.fault();
    journal.note("broken_dynamics", "{}");
  } else if (!report_.is_on_ground_data) {
    fault_ = fmt::format("left the terrain that is known at {:.6f},{:.6f}", lon_deg(place()),
                         lat_deg(place()));
    journal.note("left_terrain", "{}");
  } else if (std::hypot(report_.pitch_rad, report_.roll_rad) > rolled_over_rad) {
    fault_ = fmt::format("rolled over (pitch {:.0f} deg, roll {:.0f} deg)",
                         degrees(report_.pitch_rad), degrees(report_.roll_rad));
    journal.note("rollover",
                 fmt::format(R"({{"pitch_rad":{},"roll_rad":{}}})", note_json(report_.pitch_rad),
                             note_json(report_.roll_rad)));
  }
}

void RoverMotion::archive(Archive& a) {
  LSOS_ARCHIVE(a, vehicle_, report_, joints_, distance_m_, drive_w_, drive_j_, fault_, is_broken_);
  if (a.is_reading()) update_footprint();
}

bool RoverMotion::is_sound() const {
  constexpr double far_m = 1e8;
  const double angles_rad =
      report_.heading_rad + report_.pitch_rad + report_.roll_rad + report_.yaw_rad;
  return joints_.size() == config().links.size() && report_.p_S_m.cwiseAbs().maxCoeff() < far_m &&
         report_.v_S_mps.allFinite() && std::isfinite(angles_rad) &&
         std::isfinite(distance_m_ + report_.speed_mps);
}

}  // namespace lsos
