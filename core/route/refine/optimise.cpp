#include "route/refine/optimise.h"

#include <fmt/format.h>
#include <gnu/libc-version.h>
#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/config.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/PathSimplifier.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <cmath>
#include <memory>
#include <mutex>
#include <numbers>
#include <utility>

#include "route/refine/shortcut.h"

namespace lsos {

namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

// Number of random shortcuts that are tried first.
constexpr unsigned int shortcuts = 32;
// Greatest perturbations of poses, in map spacings, coarse first. Dubins paths are not perturbed:
// they allow hardly any move of a single pose, and 18 routes of a kilometre got no cheaper by it.
constexpr double moves_spacings[] = {8, 4, 2, 1};
// Perturbations tried per length of a move along the route; twice as many gain nothing.
constexpr double tries_a_move = 0.5;

// State space whose motions are those of RouteSteering. OMPL's own Dubins space stops the program
// where rounding leaves one of its equations off by a millionth.
class PoseSpace : public ob::SE2StateSpace {
 public:
  explicit PoseSpace(const RouteSteering& steering) : steering_(steering) {}

  static Pose2 pose(const ob::State* state) {
    const auto* se2 = state->as<StateType>();
    return {{se2->getX(), se2->getY()}, se2->getYaw()};
  }
  static void set(ob::State* state, const Pose2& pose) {
    auto* se2 = state->as<StateType>();
    se2->setXY(pose.at_m.x(), pose.at_m.y());
    se2->setYaw(std::remainder(pose.yaw_rad, 2 * std::numbers::pi));
  }
  double cost(RouteCost& costs, const ob::State* from, const ob::State* to) const {
    return costs.driven(steering_.path(pose(from), pose(to)));
  }
  double distance(const ob::State* from, const ob::State* to) const override {
    return steering_.length_m(pose(from), pose(to));
  }
  void interpolate(const ob::State* from, const ob::State* to, double share,
                   ob::State* state) const override {
    set(state, steering_.between(pose(from), pose(to), share));
  }
  bool isMetricSpace() const override { return false; }
  bool hasSymmetricDistance() const override { return false; }
  bool hasSymmetricInterpolate() const override { return false; }

 private:
  const RouteSteering& steering_;
};

class Objective : public ob::OptimizationObjective {
 public:
  Objective(const ob::SpaceInformationPtr& information, RouteCost& costs)
      : OptimizationObjective(information), costs_(costs) {}
  ob::Cost stateCost(const ob::State*) const override { return identityCost(); }
  ob::Cost motionCost(const ob::State* from, const ob::State* to) const override {
    return ob::Cost(si_->getStateSpace()->as<PoseSpace>()->cost(costs_, from, to));
  }

 private:
  RouteCost& costs_;
};

// Accepts every motion: a motion across a hazard has infinite cost, so that none need be evaluated
// twice.
class AnyMotion : public ob::MotionValidator {
 public:
  using MotionValidator::MotionValidator;
  bool checkMotion(const ob::State*, const ob::State*) const override { return true; }
  bool checkMotion(const ob::State*, const ob::State*,
                   std::pair<ob::State*, double>&) const override {
    return true;
  }
};

std::mutex one_at_a_time;

// Collects OMPL's messages while it lives, which else go to standard output.
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

ob::SpaceInformationPtr information_on(const RouteSteering& steering, const GroundMap& map) {
  ob::RealVectorBounds bounds(2);
  const Vec2 high_m = map.place_m(map.columns() - 1, map.rows() - 1);
  for (unsigned int k = 0; k < 2; ++k) {
    bounds.setLow(k, map.low_m()[k]);
    bounds.setHigh(k, high_m[k]);
  }
  auto space = std::make_shared<PoseSpace>(steering);
  space->setBounds(bounds);
  auto information = std::make_shared<ob::SpaceInformation>(std::move(space));
  information->setStateValidityChecker([](const ob::State*) { return true; });
  information->setMotionValidator(std::make_shared<AnyMotion>(information));
  information->setup();
  return information;
}

// Shortcuts and random perturbations of poses, as long as they make the route cheaper.
std::vector<Pose2> perturb_at_random(RouteCost& costs, const RouteSteering& steering,
                                     const std::vector<Pose2>& poses) {
  const ob::SpaceInformationPtr information = information_on(steering, costs.map());
  og::PathGeometric path(information);
  ob::State* state = information->allocState();
  for (const Pose2& pose : poses) {
    PoseSpace::set(state, pose);
    path.append(state);
  }
  information->freeState(state);
  og::PathSimplifier simplifier(information, nullptr,
                                std::make_shared<Objective>(information, costs));
  const double length_m = path.length();
  if (length_m < costs.map().spacing_m()) return poses;
  simplifier.shortcutPath(path, shortcuts, shortcuts);
  if (steering.is_straight()) {
    for (const double move_spacings : moves_spacings) {
      const double move_m = move_spacings * costs.map().spacing_m();
      const auto steps = static_cast<unsigned int>(std::ceil(tries_a_move * length_m / move_m));
      simplifier.perturbPath(path, move_m, steps, steps);
    }
  }
  std::vector<Pose2> now;
  for (const ob::State* of : path.getStates()) now.push_back(PoseSpace::pose(of));
  return now;
}

}  // namespace

std::string optimiser_stamp() {
  std::string stamp = fmt::format("ompl {} libc {}", OMPL_VERSION, gnu_get_libc_version());
  // With these instructions the C library's functions round differently.
  if (__builtin_cpu_supports("fma")) stamp += " fma";
  if (__builtin_cpu_supports("avx2")) stamp += " avx2";
  return stamp;
}

OptimisedRoute optimise(RouteCost& costs, const RouteSteering& steering, std::vector<Pose2> poses,
                        std::uint64_t seed) {
  return perturb(costs, steering, shortcut(costs, steering, std::move(poses)), seed);
}

OptimisedRoute perturb(RouteCost& costs, const RouteSteering& steering,
                       const std::vector<Pose2>& poses, std::uint64_t seed) {
  const std::lock_guard lock(one_at_a_time);
  {
    // OMPL warns of any seed that is not the first of the process, which is intended here.
    const Messages unwanted;
    ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(seed % 0x7fffffff + 1));
  }
  Messages messages;
  OptimisedRoute answer{steering.line(poses), {}};
  const std::vector<Pose2> now =
      shortcut(costs, steering, perturb_at_random(costs, steering, poses));
  if (Line2 line = steering.line(now); costs.driven(line) < costs.driven(answer.line)) {
    answer.line = std::move(line);
  }
  answer.messages = messages.texts;
  return answer;
}

}  // namespace lsos
