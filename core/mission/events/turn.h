// What an event works with while its rover has its turn in an exchange.
#pragma once

#include "mission/events/event_record.h"
#include "mission/port/script_host.h"
#include "mission/rover/rover_agent.h"
#include "plan/plan.h"

namespace lsos {

struct Turn {
  SimTime now{};
  const MissionInfo& mission;
  RoverAgent& agent;
  ScriptHost& host;
  const EventLookup& others;  // events of all rovers
};

}  // namespace lsos
