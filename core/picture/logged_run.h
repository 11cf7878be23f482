// A run's log as pictures need it: all rovers at some moments, and their tracks.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "picture/logged_rover.h"
#include "record/log.h"
#include "terrain/ground.h"

namespace lsos {

// Each rover that has a sample by then, in order of ids, interpolated between its last sample and
// the next.
using LoggedMoment = std::vector<LoggedRover>;

struct TrackPoint {
  SimTime time{};
  Vec3 p_S_m = Vec3::Zero();
};

struct LoggedRun {
  std::vector<LoggedMoment> moments;                      // one for each requested time
  std::map<std::string, std::vector<TrackPoint>> tracks;  // key: rover; 5 cm or more between points
};

// Reads each layer once, so that a log may have any length. `times` must ascend; tracks end at the
// last. `interval`: LogInterval; between samples farther apart the rover was parked except for this
// long.
LoggedRun read_logged(const LogReader& log, std::span<const SimTime> times, const Ground& ground,
                      SimTime interval);

}  // namespace lsos
