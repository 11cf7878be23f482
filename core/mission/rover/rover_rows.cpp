#include "mission/rover/rover_rows.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lsos {

SampleRow sample_row(const RoverAgent& rover, SimTime now, const std::string& event,
                     const std::string& phase) {
  const VehicleReport& report = rover.motion().report();
  SampleRow row;
  row.time = now;
  row.rover_id = rover.id();
  row.place = rover.motion().place();
  row.elevation_m = report.elevation_m;
  row.p_S_m = report.p_S_m;
  row.roll_rad = report.roll_rad;
  row.pitch_rad = report.pitch_rad;
  row.heading_rad = report.heading_rad;
  row.speed_mps = report.speed_mps;
  row.distance_m = rover.motion().distance_m();
  row.slope_rad = report.slope_rad;
  row.slip = report.slip;
  row.slip_max = report.slip_max;
  row.sinkage_m = report.sinkage_m;
  row.drive_w = rover.motion().drive_w();
  row.drive_j = rover.motion().drive_j();
  rover.power().fill(row);
  row.event = event;
  row.phase = phase;
  return row;
}

SampleRow condition_row(const RoverAgent& rover, SimTime now, const std::string& event,
                        const std::string& phase) {
  SampleRow row = sample_row(rover, now, event, phase);
  const DriveSlip& slip = rover.drive().slip();
  row.slip = rover.is_parked() ? not_modelled : slip.now();
  row.slip_max = rover.is_parked() ? not_modelled : slip.now_max();
  return row;
}

std::vector<JointRow> joint_rows(const RoverAgent& rover, SimTime now) {
  std::vector<JointRow> rows;
  const std::vector<double>& joints = rover.motion().joints();
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const LinkConfig& link = rover.motion().config().links[i];
    JointRow row{now, rover.id(), link.name};
    (link.joint == JointType::revolute ? row.angle_rad : row.extension_m) = joints[i];
    rows.push_back(row);
  }
  const AntennaArray& antennas = rover.antennas();
  for (std::size_t i = 0; i < antennas.specs().size(); ++i) {
    const AntennaSpec& antenna = antennas.specs()[i];
    if (!antenna.is_stowable()) continue;
    rows.push_back(
        {now, rover.id(), mast_joint(antenna), not_modelled, antennas.extension_m(i, now)});
  }
  return rows;
}

std::vector<PanelRow> panel_rows(const RoverAgent& rover, SimTime now) {
  std::vector<PanelRow> rows;
  const std::optional<PanelSunlight>& sun = rover.power().sun();
  const PanelArray& panels = rover.power().panels();
  if (panels.specs().empty()) return rows;
  const SiteFrame& site = rover.motion().ground().site();
  const Vec3& p_S_m = rover.motion().report().p_S_m;
  const Mat3 R_SB = rover.motion().part_poses()[0].R_SB;
  for (std::size_t i = 0; i < panels.specs().size(); ++i) {
    PanelRow row{.time = now, .rover_id = rover.id(), .panel = panels.specs()[i].name};
    if (sun) {
      const PanelSunlight::Panel& lit = sun->panels[i];
      row.sun_fraction = lit.sun_fraction;
      row.incidence = lit.sun_fraction * std::max(0.0, lit.cosine);
      row.power_w = lit.power_w;
    }
    if (panels.is_up(i, now)) {
      const Vec3 normal_S = R_SB * panels.pose_at(i, now).normal_B();
      const double east = normal_S.dot(site.east_S(p_S_m));
      const double north = normal_S.dot(site.north_S(p_S_m));
      const double azimuth_rad = std::atan2(east, north);
      row.azimuth_rad = azimuth_rad < 0 ? azimuth_rad + 2 * std::numbers::pi : azimuth_rad;
      row.elevation_rad = std::atan2(normal_S.dot(site.up_S(p_S_m)), std::hypot(east, north));
    }
    rows.push_back(row);
  }
  return rows;
}

std::vector<OrderRow> order_rows(const RoverAgent& rover, SimTime now) {
  std::vector<OrderRow> rows;
  const PanelArray& panels = rover.power().panels();
  for (std::size_t i = 0; i < panels.specs().size(); ++i) {
    const Steering& steering = panels.steering(i);
    OrderRow row{now, rover.id(), OrderRow::panel, panels.specs()[i].name,
                 panels.is_stowed(i) ? OrderRow::stowed : to_string(steering.mode)};
    row.azimuth_rad = steering.angles.azimuth_rad;
    row.elevation_rad = steering.angles.elevation_rad;
    rows.push_back(row);
  }
  const PostureControl* posture = rover.motion().vehicle().posture();
  if (posture == nullptr) return rows;
  const std::vector<LimbConfig>& limbs = rover.motion().config().limbs;
  for (std::size_t i = 0; i < limbs.size(); ++i) {
    OrderRow row{now, rover.id(), OrderRow::limb, limbs[i].name,
                 posture->is_level() ? OrderRow::level : OrderRow::parallel};
    row.x_m = posture->hubs_B_m()[i].x();
    row.y_m = posture->hubs_B_m()[i].y();
    row.z_m = posture->hubs_B_m()[i].z();
    rows.push_back(row);
  }
  return rows;
}

std::vector<ResourceRow> resource_rows(const RoverAgent& rover, SimTime now) {
  std::vector<ResourceRow> rows;
  for (const auto& [name, amount] : rover.power().resources()) {
    rows.push_back({now, rover.id(), name, amount});
  }
  return rows;
}

}  // namespace lsos
