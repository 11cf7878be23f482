// How rovers begin a mission where another run left them, in place of what the plan and the rover's
// script say.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/vector.h"
#include "mission/port/breakage.h"
#include "planet/body.h"
#include "planet/utc.h"
#include "power/panel_array.h"

namespace lsos {

// What is absent or empty stays as the plan and the script have it.
struct RoverStart {
  struct Panel {
    // Direction of its face: azimuth from true north, elevation above the horizon; absent: it is
    // not up.
    std::optional<PanelAngles> face;
    Steering steering;
    bool goes_up = true;  // false: it is stowed, or was being stowed
  };
  // On limbs: places of the wheels' hubs under the chassis that the posture is to keep, by limb.
  struct Stance {
    std::map<std::string, Vec3> hubs_B_m;
    bool is_level = true;
  };

  std::optional<Geodetic> place;  // of the reference point; its height is not used
  std::optional<double> heading_rad;
  std::map<std::string, double> joints;  // m or rad, by link
  std::optional<Stance> stance;
  std::optional<double> energy_j;  // that the battery holds
  std::map<std::string, double> resources;
  std::map<std::string, Panel> panels;
  std::map<std::string, double> masts_m;  // how far each antenna is raised
  std::vector<Breakage> breakages;        // repairs too, in their order
};

// The end of a run, with which a mission begins.
struct MissionStart {
  std::string folder;      // of the run
  std::string log_sha256;  // of its log
  Instant end;
  Geodetic site;  // origin of its site frame, at height 0
  std::map<std::string, RoverStart> rovers;
};

}  // namespace lsos
