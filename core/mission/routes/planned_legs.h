// The legs that a mission's rovers have planned. What was planned once, in this run or an earlier
// one, is not planned again.
#pragma once

#include <map>
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

  // What stands on the ground for the whole mission, for all legs to go round. Before the first.
  void set_standing(std::vector<Obstacle> standing) { standing_ = std::move(standing); }
  const std::vector<Obstacle>& standing() const { return standing_; }

  // Plans, with a seed of the leg's own in place of the request's.
  const PlannedLeg& leg(const DriveCost& cost, LegRequest request);

  // Takes up legs of an earlier run of the same program. A leg is used only for the same ground,
  // rover, settings and places, to the last bit; what is damaged is left out.
  void recall(const std::string& bytes);
  // What the next run may recall: all legs that were asked for, and of the others as many as are
  // worth keeping. "" when nothing was planned.
  std::string kept() const;

 private:
  const Ground* ground_;
  std::uint64_t seed_;
  std::string ground_key_;
  std::vector<Obstacle> standing_;
  std::map<std::string, PlannedLeg> legs_;  // by a hash of all that they depend on
  std::set<std::string> asked_;
  bool has_planned_ = false;
};

}  // namespace lsos
