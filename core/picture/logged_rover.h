// Where a rover was, read from the log of a run: what is drawn again without simulating.
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

// At a `share`, 0..1, of the way from one sample of a rover to its next: where it was, and how its
// joints and panels stood. All else is as the first sample has it.
LoggedRover between(const SiteFrame& site, const LoggedRover& from, const LoggedRover& to,
                    double share);

// Of the chassis, then of each link.
std::vector<PartPose> part_poses(const SiteFrame& site, const VehicleConfig& vehicle,
                                 const LoggedRover& logged);
// The masts of antennas as far as they were raised, frame B.
std::vector<Shape> masts(std::span<const AntennaSpec> antennas, const LoggedRover& logged);

// Of the panels that were up, about the rover's reference point, site axes; absent where one was
// not.
std::vector<std::optional<PanelFace>> panel_faces(const SiteFrame& site,
                                                  std::span<const PanelSpec> panels,
                                                  const LoggedRover& logged);

}  // namespace lsos
