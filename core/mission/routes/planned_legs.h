// Cache of planned legs: a leg that was planned once, in this run or an earlier one, is not planned
// again. Several threads may request legs at once.
#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "route/cost/drive_cost.h"
#include "route/cost/leg_request.h"
#include "terrain/ground.h"

namespace lsos {

class PlannedLegs {
 public:
  // `ground` must outlive it. `seed`: the mission's.
  PlannedLegs(const Ground& ground, std::uint64_t seed);

  // Sets the obstacles that stand for the whole mission, which all legs avoid. Call it before the
  // first leg.
  void set_standing(std::vector<Obstacle> standing) { standing_ = std::move(standing); }
  const std::vector<Obstacle>& standing() const { return standing_; }
  // Has kept() given to `keep` while legs are planned, by one thread at a time, so often that one
  // who stops the program loses a fiftieth of them at most, or one leg.
  void set_keeper(std::function<void(const std::string& bytes)> keep) { keep_ = std::move(keep); }

  // Returns the planned leg; plans it when it is not known. The seed of the request is replaced by
  // one of the leg's own.
  const PlannedLeg& leg(const DriveCost& cost, LegRequest request);

  // Takes up legs of an earlier run of the same program. A leg is used only for the same ground,
  // rover, settings and places, to the last bit; damaged bytes are ignored.
  void recall(const std::string& bytes);
  // Legs for the next run to recall: all that were requested, and others up to 2000 legs in all. ""
  // when nothing was planned.
  std::string kept() const;

 private:
  std::string kept_locked() const;

  const Ground* ground_;
  std::uint64_t seed_;
  std::string ground_key_;
  std::vector<Obstacle> standing_;
  mutable std::mutex mutex_;  // guards all that follows; not held while a leg is planned
  std::map<std::string, PlannedLeg> legs_;  // key: hash of all that the leg depends on
  std::set<std::string> requested_;
  std::function<void(const std::string& bytes)> keep_;
  std::size_t planned_ = 0;       // number of legs that were not known
  std::size_t not_yet_kept_ = 0;  // of these, since `keep_` was last called
};

// What is kept of two runs; of more than can be kept, those of `later` first. Damaged bytes count
// as none.
std::string merged_legs(const std::string& earlier, const std::string& later);

}  // namespace lsos
