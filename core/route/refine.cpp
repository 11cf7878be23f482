#include "route/refine.h"

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/PathSimplifier.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <cmath>
#include <memory>
#include <mutex>

namespace lsos {

namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using PlaceState = ob::RealVectorStateSpace::StateType;

// Points are moved by up to so many spacings, coarse first.
constexpr double moves_spacings[] = {8, 4, 2, 1};

Vec2 place_of(const ob::State* state) {
  const auto* place = state->as<PlaceState>();
  return {place->values[0], place->values[1]};
}

class Objective : public ob::OptimizationObjective {
 public:
  Objective(const ob::SpaceInformationPtr& space, LegCosts& costs)
      : OptimizationObjective(space), costs_(costs) {}
  ob::Cost stateCost(const ob::State*) const override { return identityCost(); }
  ob::Cost motionCost(const ob::State* from, const ob::State* to) const override {
    return ob::Cost(costs_.straight(place_of(from), place_of(to)));
  }

 private:
  LegCosts& costs_;
};

class Motions : public ob::MotionValidator {
 public:
  Motions(const ob::SpaceInformationPtr& space, LegCosts& costs)
      : MotionValidator(space), costs_(costs) {}
  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    return std::isfinite(costs_.straight(place_of(from), place_of(to)));
  }
  bool checkMotion(const ob::State* from, const ob::State* to,
                   std::pair<ob::State*, double>&) const override {
    return checkMotion(from, to);
  }

 private:
  LegCosts& costs_;
};

double cost_of(LegCosts& costs, const Line2& line) {
  double sum = 0;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) sum += costs.straight(line[k], line[k + 1]);
  return sum;
}

Line2 line_of(const og::PathGeometric& path) {
  Line2 line;
  for (std::size_t k = 0; k < path.getStateCount(); ++k) {
    line.push_back(place_of(path.getState(static_cast<unsigned int>(k))));
  }
  return line;
}

// Points left out as far ahead as that costs no more.
Line2 pulled_tight(LegCosts& costs, const Line2& line) {
  Line2 tight{line.front()};
  for (std::size_t at = 0; at + 1 < line.size();) {
    std::size_t best = at + 1;
    double along = costs.straight(line[at], line[at + 1]);
    for (std::size_t to = at + 2; to < line.size(); ++to) {
      along += costs.straight(line[to - 1], line[to]);
      if (costs.straight(line[at], line[to]) <= along) best = to;
    }
    tight.push_back(line[best]);
    at = best;
  }
  return tight;
}

std::mutex one_at_a_time;

// Keeps OMPL's messages from standard output while it lives.
class Messages : public ompl::msg::OutputHandler {
 public:
  Messages() { ompl::msg::useOutputHandler(this); }
  ~Messages() override { ompl::msg::restorePreviousOutputHandler(); }
  Messages(const Messages&) = delete;
  Messages& operator=(const Messages&) = delete;

  void log(const std::string& text, ompl::msg::LogLevel level, const char*, int) override {
    if (level >= ompl::msg::LOG_WARN) texts.push_back(text);
  }
  std::vector<std::string> texts;
};

}  // namespace

Refined refined(LegCosts& costs, const Line2& line, std::uint64_t seed) {
  if (line.size() < 3) return {line, {}};
  const std::lock_guard lock(one_at_a_time);
  {
    // It warns of a seed that is not the process' first, which is what is wanted here.
    const Messages unwanted;
    ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(seed % 0x7fffffff + 1));
  }
  Messages messages;
  const GroundMap& map = costs.map();
  auto space = std::make_shared<ob::RealVectorStateSpace>(2);
  ob::RealVectorBounds bounds(2);
  const Vec2 high_m = map.place_m(map.columns() - 1, map.rows() - 1);
  for (unsigned int k = 0; k < 2; ++k) {
    bounds.setLow(k, map.low_m()[k]);
    bounds.setHigh(k, high_m[k]);
  }
  space->setBounds(bounds);
  const auto information = std::make_shared<ob::SpaceInformation>(space);
  information->setStateValidityChecker([](const ob::State*) { return true; });
  information->setMotionValidator(std::make_shared<Motions>(information, costs));
  information->setup();
  const auto objective = std::make_shared<Objective>(information, costs);
  og::PathSimplifier simplifier(information, nullptr, objective);

  og::PathGeometric path(information);
  for (const Vec2& at_m : line) {
    ob::State* state = space->allocState();
    state->as<PlaceState>()->values[0] = at_m.x();
    state->as<PlaceState>()->values[1] = at_m.y();
    path.append(state);
    space->freeState(state);
  }
  Line2 best = line;
  double least = cost_of(costs, line);
  const auto keep_if_better = [&] {
    const Line2 now = line_of(path);
    const double cost = cost_of(costs, now);
    if (cost < least) {
      least = cost;
      best = now;
    }
  };
  const auto steps = static_cast<unsigned int>(std::max<std::size_t>(100, line.size()));
  simplifier.shortcutPath(path, steps, steps);
  keep_if_better();
  for (const double move : moves_spacings) {
    simplifier.perturbPath(path, move * map.spacing_m(), steps, steps / 2);
    simplifier.shortcutPath(path, steps, steps / 2);
    keep_if_better();
  }
  best = pulled_tight(costs, best);
  const Line2 straight{line.front(), line.back()};
  if (cost_of(costs, straight) <= cost_of(costs, best)) best = straight;
  return {best, messages.texts};
}

}  // namespace lsos
