// The mission as a table of time for a terminal: days, in each a line a rover with its events.
#pragma once

#include <string>
#include <vector>

#include "planet/utc.h"

namespace lsos {

struct TimelineSpan {
  double begin_s = 0, end_s = 0;  // since the mission's start
};

struct TimelineBar {
  TimelineSpan time;
  char letter = '?';
};

struct TimelineRover {
  std::string id;
  std::vector<TimelineBar> bars;
  std::vector<TimelineSpan> dark;    // no Sun reaches its panels
  std::vector<TimelineSpan> unseen;  // Earth is not in view
};

// Days of 24 h from the mission's start, a letter each 20 min: that of the event that takes most of
// it, '.' where none does. Below, where anything is dark or unseen, a line with n (no Sun), e (no
// Earth) or b (both).
std::string timeline_text(const std::vector<TimelineRover>& rovers, Instant start, double end_s);

}  // namespace lsos
