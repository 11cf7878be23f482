#include "picture/logged_rover.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lsos {

namespace {

// Inverse of direction_S().
SkyPosition sky_position(const SiteFrame& site, const Vec3& p_S_m, const Vec3& direction_S) {
  const double azimuth_rad = site.azimuth_rad(direction_S, p_S_m);
  return {azimuth_rad < 0 ? azimuth_rad + 2 * std::numbers::pi : azimuth_rad,
          std::asin(std::clamp(direction_S.dot(site.up_S(p_S_m)), -1.0, 1.0))};
}

PartPose chassis_pose(const SiteFrame& site, const SampleRow& sample) {
  return chassis_pose(site, sample.p_S_m, sample.heading_rad, sample.pitch_rad, sample.roll_rad);
}

// Inverse of chassis_pose().
void set_attitude(const SiteFrame& site, const Mat3& R_SB, SampleRow& sample) {
  const Vec3 up = site.up_S(sample.p_S_m), ahead = R_SB.col(0), left = R_SB.col(1);
  const SkyPosition nose = sky_position(site, sample.p_S_m, ahead);
  const Vec3 level_left = up.cross(ahead).normalized();
  sample.heading_rad = nose.azimuth_rad;
  sample.pitch_rad = nose.elevation_rad;
  sample.roll_rad = std::atan2(left.dot(ahead.cross(level_left)), left.dot(level_left));
}

template <class Value>
Value mixed(const Value& from, const Value& to, double share) {
  return from + share * (to - from);
}

// Mixes rows of the same name; a row without a counterpart in `to` stays as it is.
template <class Row, class Mix>
void mix_rows(std::vector<Row>& rows, const std::vector<Row>& to, std::string Row::*name,
              const Mix& mix) {
  for (Row& row : rows) {
    const auto other = std::ranges::find(to, row.*name, name);
    if (other != to.end()) mix(row, *other);
  }
}

}  // namespace

LoggedRover between(const SiteFrame& site, const LoggedRover& from, const LoggedRover& to,
                    double share) {
  LoggedRover rover = from;
  SampleRow& sample = rover.sample;
  const SampleRow& end = to.sample;
  const Mat3 from_R_SB = chassis_pose(site, from.sample).R_SB;
  const Mat3 to_R_SB = chassis_pose(site, end).R_SB;
  const Mat3 R_SB = Quat(from_R_SB).slerp(share, Quat(to_R_SB)).toRotationMatrix();
  sample.p_S_m += share * (end.p_S_m - sample.p_S_m);
  sample.elevation_m = mixed(sample.elevation_m, end.elevation_m, share);
  sample.place = site.geodetic(sample.p_S_m);
  set_attitude(site, R_SB, sample);
  mix_rows(rover.joints, to.joints, &JointRow::joint, [&](JointRow& row, const JointRow& other) {
    row.angle_rad = mixed(row.angle_rad, other.angle_rad, share);
    row.extension_m = mixed(row.extension_m, other.extension_m, share);
  });
  // Panels are interpolated in the chassis frame: a panel that lies flat has no well-defined
  // azimuth.
  for (PanelRow& row : rover.panels) {
    if (std::isnan(row.azimuth_rad)) continue;
    Vec3 normal_B = from_R_SB.transpose() *
                    direction_S(site, from.sample.p_S_m, {row.azimuth_rad, row.elevation_rad});
    const auto other = std::ranges::find(to.panels, row.panel, &PanelRow::panel);
    if (other != to.panels.end() && !std::isnan(other->azimuth_rad)) {
      const Vec3 to_B = to_R_SB.transpose() *
                        direction_S(site, end.p_S_m, {other->azimuth_rad, other->elevation_rad});
      const Vec3 mixed_B = mixed(normal_B, to_B, share);
      if (mixed_B.norm() > 1e-3) normal_B = mixed_B.normalized();
    }
    const SkyPosition faced = sky_position(site, sample.p_S_m, R_SB * normal_B);
    row.azimuth_rad = faced.azimuth_rad;
    row.elevation_rad = faced.elevation_rad;
  }
  return rover;
}

std::vector<PartPose> part_poses(const SiteFrame& site, const VehicleConfig& vehicle,
                                 const LoggedRover& logged) {
  std::vector<double> joints;
  for (const LinkConfig& link : vehicle.links) {
    const auto row = std::ranges::find(logged.joints, link.name, &JointRow::joint);
    const bool is_known = row != logged.joints.end();
    const bool is_angle = link.joint == JointType::revolute;
    joints.push_back(!is_known ? 0 : is_angle ? row->angle_rad : row->extension_m);
  }
  PartPose chassis = chassis_pose(site, logged.sample);
  chassis.p_S_m -= chassis.R_SB * reference_B_m(vehicle, joints);
  return part_poses(vehicle, chassis, joints);
}

std::vector<Shape> masts(std::span<const AntennaSpec> antennas, const LoggedRover& logged) {
  std::vector<Shape> shapes;
  for (const AntennaSpec& antenna : antennas) {
    const auto row = std::ranges::find(logged.joints, mast_joint(antenna), &JointRow::joint);
    if (!antenna.is_stowable() || row == logged.joints.end()) continue;
    const std::vector<Shape> more = mast_shapes(antenna, row->extension_m);
    shapes.insert(shapes.end(), more.begin(), more.end());
  }
  return shapes;
}

std::vector<std::optional<PanelFace>> panel_faces(const SiteFrame& site,
                                                  std::span<const PanelSpec> panels,
                                                  const LoggedRover& logged) {
  const PartPose chassis = chassis_pose(site, logged.sample);
  std::vector<std::optional<PanelFace>> faces;
  for (const PanelSpec& panel : panels) {
    const auto row = std::ranges::find(logged.panels, panel.name, &PanelRow::panel);
    if (row == logged.panels.end() || std::isnan(row->azimuth_rad)) {
      faces.emplace_back();
      continue;
    }
    const Vec3 normal_S =
        direction_S(site, logged.sample.p_S_m, {row->azimuth_rad, row->elevation_rad});
    const PanelAngles angles = facing(panel, panel.rest, chassis.R_SB.transpose() * normal_S);
    const PanelPose at = pose(panel, angles);
    faces.push_back(PanelFace{chassis.R_SB * at.p_B_m, chassis.R_SB * at.half_u_B_m,
                              chassis.R_SB * at.half_v_B_m});
  }
  return faces;
}

}  // namespace lsos
