// State of a rover, read from the log of a run, for drawing without simulating.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mission/model/rover_model.h"
#include "planet/sunlight.h"
#include "record/rows.h"
#include "vehicle/part_pose.h"
#include "view/exposure/panel_view.h"

namespace lsos {

struct LoggedRover {
  SampleRow sample;
  std::vector<JointRow> joints;
  std::vector<PanelRow> panels;
};

// Interpolates position, attitude, joints and panels at a `share`, 0..1, between one sample of a
// rover and its next. All else is taken from the first sample.
LoggedRover between(const SiteFrame& site, const LoggedRover& from, const LoggedRover& to,
                    double share);

// Poses of the chassis, then of each link.
std::vector<PartPose> part_poses(const SiteFrame& site, const VehicleConfig& vehicle,
                                 const LoggedRover& logged);
// Masts of the antennas, raised as logged, frame B.
std::vector<Shape> masts(std::span<const AntennaSpec> antennas, const LoggedRover& logged);

// Faces of the panels that were up, relative to the rover's reference point, site axes; absent for
// one that was not.
std::vector<std::optional<PanelFace>> panel_faces(const SiteFrame& site,
                                                  std::span<const PanelSpec> panels,
                                                  const LoggedRover& logged);

}  // namespace lsos
