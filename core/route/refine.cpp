#include "route/refine.h"

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/PathSimplifier.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <cmath>
#include <memory>
#include <mutex>
#include <numbers>
#include <numeric>
#include <utility>

#include "route/fewer_points.h"

namespace lsos {

namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

// Points are moved by up to so many spacings, coarse first.
constexpr double moves_spacings[] = {8, 4, 2, 1};

// What differs between rovers that turn on the spot and others: states, and the way between two.
class Steering {
 public:
  virtual ~Steering() = default;
  virtual ob::StateSpacePtr space(const ob::RealVectorBounds& bounds) = 0;
  virtual void set(ob::State* state, const Pose2& pose) const = 0;
  virtual Line2 way(const ob::State* from, const ob::State* to) const = 0;
};

class OnTheSpot : public Steering {
 public:
  using State = ob::RealVectorStateSpace::StateType;

  ob::StateSpacePtr space(const ob::RealVectorBounds& bounds) override {
    auto plane = std::make_shared<ob::RealVectorStateSpace>(2);
    plane->setBounds(bounds);
    return plane;
  }
  void set(ob::State* state, const Pose2& pose) const override {
    state->as<State>()->values[0] = pose.at_m.x();
    state->as<State>()->values[1] = pose.at_m.y();
  }
  Line2 way(const ob::State* from, const ob::State* to) const override {
    const auto place = [](const ob::State* state) {
      const double* values = state->as<State>()->values;
      return Vec2(values[0], values[1]);
    };
    return {place(from), place(to)};
  }
};

// Poses joined by arcs and straight pieces. OMPL's own space of these stops the program where
// rounding leaves one of its equations off by a millionth.
class TurnsSpace : public ob::SE2StateSpace {
 public:
  explicit TurnsSpace(double radius_m) : radius_m_(radius_m) {}

  static Pose2 pose(const ob::State* state) {
    const auto* se2 = state->as<StateType>();
    return {{se2->getX(), se2->getY()}, se2->getYaw()};
  }
  static void set(ob::State* state, const Pose2& pose) {
    auto* se2 = state->as<StateType>();
    se2->setXY(pose.at_m.x(), pose.at_m.y());
    se2->setYaw(std::remainder(pose.yaw_rad, 2 * std::numbers::pi));
  }
  TurningWay way(const ob::State* from, const ob::State* to) const {
    return shortest_turns(pose(from), pose(to), radius_m_);
  }
  double distance(const ob::State* from, const ob::State* to) const override {
    return length_m(way(from, to));
  }
  void interpolate(const ob::State* from, const ob::State* to, double share,
                   ob::State* state) const override {
    const TurningWay turns = way(from, to);
    set(state, along_turns(pose(from), turns, share * length_m(turns)));
  }
  bool isMetricSpace() const override { return false; }
  bool hasSymmetricDistance() const override { return false; }
  bool hasSymmetricInterpolate() const override { return false; }

 private:
  double radius_m_;
};

class Turning : public Steering {
 public:
  Turning(double radius_m, double step_m)
      : step_m_(step_m), turns_(std::make_shared<TurnsSpace>(radius_m)) {}

  ob::StateSpacePtr space(const ob::RealVectorBounds& bounds) override {
    turns_->setBounds(bounds);
    return turns_;
  }
  void set(ob::State* state, const Pose2& pose) const override { TurnsSpace::set(state, pose); }
  Line2 way(const ob::State* from, const ob::State* to) const override {
    Line2 line = turns_line(TurnsSpace::pose(from), turns_->way(from, to), step_m_);
    line.back() = TurnsSpace::pose(to).at_m;
    return line;
  }

 private:
  double step_m_;
  std::shared_ptr<TurnsSpace> turns_;
};

class Objective : public ob::OptimizationObjective {
 public:
  Objective(const ob::SpaceInformationPtr& space, LegCosts& costs, const Steering& steering)
      : OptimizationObjective(space), costs_(costs), steering_(steering) {}
  ob::Cost stateCost(const ob::State*) const override { return identityCost(); }
  ob::Cost motionCost(const ob::State* from, const ob::State* to) const override {
    return ob::Cost(costs_.along(steering_.way(from, to)));
  }

 private:
  LegCosts& costs_;
  const Steering& steering_;
};

class Motions : public ob::MotionValidator {
 public:
  Motions(const ob::SpaceInformationPtr& space, LegCosts& costs, const Steering& steering)
      : MotionValidator(space), costs_(costs), steering_(steering) {}
  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    return std::isfinite(costs_.along(steering_.way(from, to)));
  }
  bool checkMotion(const ob::State* from, const ob::State* to,
                   std::pair<ob::State*, double>&) const override {
    return checkMotion(from, to);
  }

 private:
  LegCosts& costs_;
  const Steering& steering_;
};

Line2 line_of(const og::PathGeometric& path, const Steering& steering,
              const std::vector<std::size_t>& states) {
  Line2 line;
  for (std::size_t k = 0; k + 1 < states.size(); ++k) {
    const Line2 way = steering.way(path.getState(static_cast<unsigned int>(states[k])),
                                   path.getState(static_cast<unsigned int>(states[k + 1])));
    line.insert(line.end(), way.begin() + (k == 0 ? 0 : 1), way.end());
  }
  return line;
}

// All states, and those that are left when as many are passed over as that costs no more.
Line2 line_of(const og::PathGeometric& path, const Steering& steering) {
  std::vector<std::size_t> states(path.getStateCount());
  std::iota(states.begin(), states.end(), 0);
  return line_of(path, steering, states);
}

Line2 tight_line_of(const og::PathGeometric& path, const Steering& steering, LegCosts& costs) {
  const auto cost = [&](std::size_t from, std::size_t to) {
    return costs.along(steering.way(path.getState(static_cast<unsigned int>(from)),
                                    path.getState(static_cast<unsigned int>(to))));
  };
  std::vector<std::size_t> states{0};
  while (states.back() + 1 < path.getStateCount()) {
    const std::size_t at = states.back();
    std::size_t best = at + 1;
    double along = cost(at, at + 1);
    for (std::size_t to = at + 2; to < path.getStateCount(); ++to) {
      along += cost(to - 1, to);
      if (cost(at, to) <= along) best = to;
    }
    states.push_back(best);
  }
  return line_of(path, steering, states);
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

// Cuts corners, moves states and cuts again; the cheapest of `line` and all that came of it.
Refined refined_by(Steering& steering, LegCosts& costs, const Line2& line,
                   const std::vector<Pose2>& poses, std::uint64_t seed) {
  const std::lock_guard lock(one_at_a_time);
  {
    // It warns of a seed that is not the process' first, which is what is wanted here.
    const Messages unwanted;
    ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(seed % 0x7fffffff + 1));
  }
  Messages messages;
  const GroundMap& map = costs.map();
  ob::RealVectorBounds bounds(2);
  const Vec2 high_m = map.place_m(map.columns() - 1, map.rows() - 1);
  for (unsigned int k = 0; k < 2; ++k) {
    bounds.setLow(k, map.low_m()[k]);
    bounds.setHigh(k, high_m[k]);
  }
  const auto information = std::make_shared<ob::SpaceInformation>(steering.space(bounds));
  information->setStateValidityChecker([](const ob::State*) { return true; });
  information->setMotionValidator(std::make_shared<Motions>(information, costs, steering));
  information->setup();
  const auto objective = std::make_shared<Objective>(information, costs, steering);
  og::PathSimplifier simplifier(information, nullptr, objective);

  og::PathGeometric path(information);
  ob::State* state = information->allocState();
  for (const Pose2& pose : poses) {
    steering.set(state, pose);
    path.append(state);
  }
  information->freeState(state);
  Refined best{line, {}};
  double least = costs.along(line);
  const auto keep_if_better = [&](Line2 now) {
    const double cost = costs.along(now);
    if (!(cost < least)) return;
    least = cost;
    best.line = std::move(now);
  };
  const auto steps = static_cast<unsigned int>(std::max<std::size_t>(100, line.size()));
  simplifier.shortcutPath(path, steps, steps);
  keep_if_better(line_of(path, steering));
  for (const double move : moves_spacings) {
    simplifier.perturbPath(path, move * map.spacing_m(), steps, steps / 2);
    simplifier.shortcutPath(path, steps, steps / 2);
    keep_if_better(line_of(path, steering));
  }
  keep_if_better(tight_line_of(path, steering, costs));
  best.messages = messages.texts;
  return best;
}

}  // namespace

Refined refined(LegCosts& costs, const Line2& line, std::uint64_t seed) {
  if (line.size() < 3) return {line, {}};
  std::vector<Pose2> poses;
  for (const Vec2& at_m : line) poses.push_back({at_m, 0});
  OnTheSpot steering;
  Refined best = refined_by(steering, costs, line, poses, seed);
  best.line = with_fewer_points(costs, best.line);
  const Line2 straight{line.front(), line.back()};
  if (costs.along(straight) <= costs.along(best.line)) best.line = straight;
  return best;
}

Refined refined(LegCosts& costs, const TurningRoute& route, double radius_m, std::uint64_t seed) {
  if (route.line.size() < 2) return {route.line, {}};
  const double step_m = costs.map().spacing_m();
  Turning steering(radius_m, step_m);
  std::vector<Pose2> poses = route.poses;
  const Vec2 last_m = route.line.back() - route.line[route.line.size() - 2];
  poses.push_back({route.line.back(), std::atan2(last_m.y(), last_m.x())});
  Refined best = refined_by(steering, costs, route.line, poses, seed);
  for (const bool to_left : {true, false}) {
    const auto direct =
        arc_and_straight(poses.front(), route.line.back(), radius_m, to_left, step_m);
    if (direct && costs.along(*direct) <= costs.along(best.line)) best.line = *direct;
  }
  return best;
}

}  // namespace lsos
