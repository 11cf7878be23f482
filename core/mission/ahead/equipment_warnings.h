// Goes through a rover's events before the mission starts, as far as it is known which of its
// panels and antennas are deployed and where the Sun stands.
#pragma once

#include <vector>

#include "base/error.h"
#include "mission/model/machine.h"
#include "mission/port/script_host.h"
#include "mission/rover/rover_agent.h"
#include "planet/site_frame.h"

namespace lsos {

// Warnings about events that deploy what is up, stow what is down, need what is stowed, or wait for
// sunlight while no panel is up or the Sun is below the horizon for as long as they wait (a day
// when they have no Duration). What a condition, another rover or a user's own script leaves open
// is not warned about. Also errors of scripts that fail when queried. `rover`: as it begins.
std::vector<Fault> equipment_warnings(const RoverMachine& machine, const MissionInfo& mission,
                                      const RoverAgent& rover, ScriptHost& host,
                                      const SiteFrame& site);

}  // namespace lsos
