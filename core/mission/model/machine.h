// The state machine that a plan's unordered Placemarks are synthesised into: mission (initialise,
// run, terminate) > one machine per rover > its events in sequence > their phases.
#pragma once

#include <string>
#include <vector>

#include "plan/plan.h"

namespace lsos {

struct EventMachine {
  PlanEvent event;
  EventDeclaration declaration;
};

struct RoverMachine {
  PlanRover rover;
  std::vector<EventMachine> events;  // ascending sequence, disabled ones too
};

struct MissionMachine {
  MissionInfo mission;
  std::vector<RoverMachine> rovers;  // in byte order of RoverId
};

MissionMachine synthesise(const Plan& plan, const Declarations& declarations);

// Graphviz digraph: clusters of rovers between `initialise` and `terminate`, a node with its phases
// for each event, dashed edges for StartAfter and dotted ones for OnFailure = goto and for events
// that take effect at a time.
std::string to_dot(const MissionMachine& machine);

}  // namespace lsos
