// An estimate as a map: where each event is expected to end and with how much charge, day by day.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "mission/mission_estimate.h"
#include "plan/kml_writer.h"
#include "plan/plan.h"

namespace lsos {

// Where an event that is expected to end leads its rover.
struct EventCourse {
  Geodetic end;                // absent: it does not end
  std::vector<Geodetic> line;  // that it drives; empty: it does not
};
using EventCourses = std::map<PlanEvent::Reference, EventCourse>;

// `simulation`: that of the estimate, at its end.
EventCourses event_courses(const Simulation& simulation, const Declarations& declarations);

// A document with styles, their ids beginning with "lsos-", and a folder Estimate: in it a folder a
// day with a point at the end of each event, called "A #30 EVA 08:12 64 %", and lines coloured by
// the charge at their ends. Where a rover stays, viewers show the name of the last point alone.
// `notes`: for the folder's balloon.
KmlDocument estimate_map(const Plan& plan, const MissionEstimate& estimate,
                         const EventCourses& courses, const std::string& notes);

}  // namespace lsos
