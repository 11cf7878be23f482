// The day of each event in a table that is written, as import reads it.
#pragma once

#include <string>
#include <vector>

#include "plan/declaration.h"
#include "plan/kml_source.h"

namespace lsos {

// An event's row in a table.
struct EventDay {
  int day = 0;        // 1, 2, ...; 0: no event, or one whose start stands whole
  std::string start;  // "08:00", or the text of StartTime where no clock is equal to it
};

// For each of a plan's things its day: that of its StartTime, else that of the rover's event before
// it, so that no start is made up when the table is read. Empty when
// the mission has no start.
std::vector<EventDay> event_days(const KmlSource& things, const Declarations& declarations);

// A UTC time as a clock where it is one of that day, else the text.
std::string time_on_day(const std::string& text, int day, const KmlSource& things);

}  // namespace lsos
