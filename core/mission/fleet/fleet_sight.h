// Lines of sight between the rovers and assets of a mission, and Earth.
#pragma once

#include <string>
#include <vector>

#include "mission/fleet/fleet.h"
#include "mission/light/sight_watch.h"

namespace lsos {

class FleetSight {
 public:
  // `ground` and `renderer` must outlive it.
  FleetSight(const Ground& ground, Renderer& renderer, const Fleet& fleet,
             bool is_estimate = false);

  // Evaluates the pairs that are due. Returns the intervals that end now.
  std::vector<SightIntervalRow> update(const Fleet& fleet, const Moment& moment);
  // Rows of the last results from one end to those after it: rovers first, then assets.
  std::vector<PairRow> rows(const Fleet& fleet, const Moment& moment, std::size_t from) const;
  // Ends all open intervals and returns them.
  std::vector<SightIntervalRow> finish(const Fleet& fleet, SimTime now);
  // Last result between two of rovers, assets and Earth; absent: there is none yet. In an estimate
  // it is evaluated when it is asked for.
  std::optional<PairSight> between(const Fleet& fleet, const Moment& moment, const std::string& one,
                                   const std::string& other);
  // When a pair is next due if nothing moves; absent: never.
  std::optional<SimTime> wake() const { return watch_.wake(); }
  const SightWatch& watch() const { return watch_; }
  std::vector<std::string> warnings_of_own_way(const Fleet& fleet, SimTime now) const;

  void archive(Archive& a) { LSOS_ARCHIVE(a, watch_); }

 private:
  const Ground* ground_;
  SightWatch watch_;
  bool is_estimate_;
};

}  // namespace lsos
