// Warnings about events that run otherwise than their plan or script intends; absent: there is
// nothing to warn of.
#pragma once

#include <optional>
#include <string>

#include "mission/events/turn.h"

namespace lsos {

// An event has ended while it still drove.
std::optional<std::string> unfinished_drive_warning(const PlanEvent& event,
                                                    const RoverAgent& agent);
// An event starts after its StartTime.
std::optional<std::string> late_start_warning(const PlanEvent& event, const EventRecord& record,
                                              const Turn& turn);
// A stationary event starts far from its Point.
std::optional<std::string> far_start_warning(const PlanEvent& event, const Turn& turn);

}  // namespace lsos
