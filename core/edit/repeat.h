// `edit repeat`: a day's events again on the following days.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "edit/copied_events.h"
#include "edit/event_choice.h"

namespace lsos {

struct Repetition {
  std::vector<const PlanEvent*> events;  // of the days, by rover and sequence
  int first_day = 1, last_day = 1;
  int times = 1;
  // When each event is expected to begin, since the mission's start.
  std::map<PlanEvent::Reference, SimTime> begins = {};
  // Coordinates of Points, in the order in which they are visited; empty: places stay.
  std::vector<std::string> places;
  std::string places_file;  // for messages
};

struct Repeated {
  int count = 0;
  CopyPlaces copies;
  std::vector<std::string> warnings;
};

// Copies the events behind the last of each rover, each time later by the length of the days: the
// times that they say, and the first of a rover has a StartTime so that the days do not run into
// each other. The day stands behind their names, except those that OnFailure of MissionInfo or a
// Rover goes to. When there are places, each Point of the days gets the next one; equal Points one
// together, and those within 50 m of an asset or of the rover's start stay. Ends of lines that are
// at one of these Points go with it; lines and areas that stay are warned of. Throws InputError
// where the places are too few.
Repeated repeat(PlanDocument& document, const Repetition& repetition, const EventDays& days);

}  // namespace lsos
