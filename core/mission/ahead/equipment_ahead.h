// Going through a rover's events before the mission starts, as far as it is known which of its
// panels and antennas are then deployed, and where the Sun then stands.
#pragma once

#include <vector>

#include "base/error.h"
#include "mission/model/machine.h"
#include "mission/model/rover_model.h"
#include "mission/port/script_host.h"
#include "planet/site_frame.h"

namespace lsos {

// Warnings of events that deploy what is up, stow what is down, need what is stowed, or wait for
// sunlight while no panel is up or the Sun is below the horizon for as long as they wait (a day
// where they have no Duration). Nothing is warned of that a condition, another rover or a script of
// the user's own leaves open. Errors of scripts that fail when asked.
std::vector<Fault> equipment_ahead(const RoverMachine& machine, const MissionInfo& mission,
                                   const RoverModel& model, ScriptHost& host,
                                   const SiteFrame& site);

}  // namespace lsos
