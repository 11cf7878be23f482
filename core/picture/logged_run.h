// A run's log as pictures need it: all rovers at some moments, and where they have been.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "picture/logged_rover.h"
#include "record/log.h"
#include "terrain/ground.h"

namespace lsos {

// Each rover that has a sample until then, in order of ids, between its last one and the next.
using LoggedMoment = std::vector<LoggedRover>;

struct TrackPoint {
  SimTime time{};
  Vec3 p_S_m = Vec3::Zero();
};

struct LoggedRun {
  std::vector<LoggedMoment> moments;                      // as many as times were asked for
  std::map<std::string, std::vector<TrackPoint>> tracks;  // by rover, 5 cm or more between points
};

// In one pass over each layer of a log of any length. `times` must ascend; tracks end at the last.
// `interval`: LogInterval; where samples are farther apart the rover was parked but for so long.
LoggedRun read_logged(const LogReader& log, std::span<const SimTime> times, const Ground& ground,
                      SimTime interval);

}  // namespace lsos
