// How a run ended: what its log says of each rover at that time.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "mission/model/rover_start.h"
#include "record/log.h"

namespace lsos {

struct RoverEnd {
  SampleRow sample;                 // its last
  RoverStart start;                 // a rover that begins as this one ended
  std::string hindrance;            // why none can begin so ("it had rolled over"); "": one can
  std::vector<std::string> doubts;  // what is not known of it, or not taken over
  double shade = 1;                 // share of sunlight that a script left its panels
};

struct RunEnd {
  Instant time;
  std::map<std::string, RoverEnd> rovers;  // by RoverId
};

// The log must have samples.
RunEnd read_run_end(const LogReader& log);

}  // namespace lsos
