// Rows of the log for one rover.
#pragma once

#include <string>
#include <vector>

#include "mission/rover/rover_agent.h"
#include "record/rows.h"

namespace lsos {

SampleRow sample_row(const RoverAgent& rover, SimTime now, const std::string& event,
                     const std::string& phase);
// The same with the slip that conditions use: the mean over the last second of driving.
SampleRow condition_row(const RoverAgent& rover, SimTime now, const std::string& event,
                        const std::string& phase);
std::vector<JointRow> joint_rows(const RoverAgent& rover, SimTime now);
std::vector<PanelRow> panel_rows(const RoverAgent& rover, SimTime now);
// What its panels and limbs are told until they are told otherwise.
std::vector<OrderRow> order_rows(const RoverAgent& rover, SimTime now);
std::vector<ResourceRow> resource_rows(const RoverAgent& rover, SimTime now);

}  // namespace lsos
