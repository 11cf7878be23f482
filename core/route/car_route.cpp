#include "route/car_route.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/polyline.h"
#include "base/rounding.h"
#include "route/refine/optimise.h"
#include "route/refine/shortcut.h"
#include "route/refine/simplify.h"
#include "route/search/grid_search.h"
#include "route/search/pose_search.h"

namespace lsos {

namespace {

// A piece shorter than this has no direction.
constexpr double same_place_m = 1e-3;
// Points nearer than `simplify_m` to the line between their neighbours are removed, unless the cost
// rises by more than the factor `simplify_cost_ratio`.
constexpr double simplify_m = 0.01;
constexpr double simplify_cost_ratio = 1.001;
// Poses are searched where the rounded route costs more than `poses_cost_ratio` times the lattice
// route; the search expands at most `poses_to_better` of them where there is a rounded route, and
// `poses_max` where there is none.
constexpr double poses_cost_ratio = 1.05;
constexpr std::size_t poses_to_better = 160'000, poses_max = 520'000;
// Half width, in radii, of the corridor around the lattice route that is searched first. Over 400 m
// of rough ground it takes less than half of the time, for routes that cost 1 % more in the mean.
// Larger: 8 in place of 6 takes a fifth longer over a kilometre, for 0.1 % less.
constexpr double corridor_radii = 6;

// Keeps the cheapest of the routes offered.
class Planner {
 public:
  Planner(RouteCost& costs, const DriveCost& cost, const Pose2& start, const Vec2& goal_m,
          double radius_m, std::uint64_t seed, std::size_t& poses_left)
      : costs_(costs),
        spacing_m_(costs.map().spacing_m()),
        start_(start),
        goal_m_(goal_m),
        radius_m_(radius_m),
        seed_(seed),
        poses_left_(poses_left),
        steering_(RouteSteering::dubins(radius_m, spacing_m_,
                                        [&](double of_m) { return arc_price_m(cost, of_m); })) {}

  // The lattice route with rounded corners is found fast and is mostly smooth. Poses are searched
  // where it costs notably more than the lattice route itself, which a rover that turns on the spot
  // would take.
  CarRoute run(const Stretches& known) {
    best_.nearest_m = start_.at_m;
    if (driven(known) < infinite) offer_optimised(known);
    if (!best_.is_found()) look();
    // Where points are too close together the rover slows down for corners that do not exist.
    for (Stretch& stretch : best_.stretches) {
      RouteCost costs = stretch.is_backward ? costs_.backing() : costs_;
      Line2 thin = simplified(stretch.line, simplify_m);
      if (costs.driven(thin) <= simplify_cost_ratio * costs.driven(stretch.line)) {
        stretch.line = std::move(thin);
      }
    }
    return std::move(best_);
  }

 private:
  void look() {
    const GridRoute over_lattice = search_grid(costs_, start_.at_m, goal_m_);
    round(over_lattice.line);
    if (!(least_ <= poses_cost_ratio * over_lattice.cost)) {
      search(over_lattice.line);
      best_.is_turn_too_wide = !best_.is_found();
    }
  }

  void offer(Stretches stretches, std::vector<std::string> messages = {},
             Stretches before_optimising = {}) {
    const double cost = lsos::driven(costs_, stretches);
    if (!(cost < least_)) return;
    least_ = cost;
    best_.stretches = std::move(stretches);
    best_.messages = std::move(messages);
    best_.before_optimising = std::move(before_optimising);
  }
  void offer_line(Line2 line) { offer({{{}, std::move(line), false}}); }
  // Each stretch is optimised between the poses at which it begins and ends.
  void offer_optimised(const Stretches& over) {
    Stretches better = over;
    std::vector<std::string> messages;
    for (Stretch& stretch : better) {
      RouteCost costs = stretch.is_backward ? costs_.backing() : costs_;
      OptimisedRoute found = optimise(costs, steering_, stretch.poses, seed_);
      stretch.line = std::move(found.line);
      std::ranges::move(found.messages, std::back_inserter(messages));
    }
    offer(std::move(better), std::move(messages), over);
  }

  // Optimises the line with sharp corners by the cost of rounding them, then rounds it. Where its
  // arcs have no room, perturbation hardly ever makes room for them.
  void round(const Line2& over_lattice) {
    if (over_lattice.empty()) return;
    const RouteSteering sharp = RouteSteering::on_the_spot();
    std::vector<Pose2> poses;
    for (const Vec2& at_m : corners(over_lattice)) poses.push_back({at_m, 0});
    RouteCost rounding = costs_.of_rounded_corners();
    poses = shortcut(rounding, sharp, std::move(poses));
    std::vector<Pose2> arcs = rounded(sharp.line(poses));
    if (driven(arcs) == infinite) return;
    const Line2 better = perturb(rounding, sharp, poses, seed_).line;
    std::vector<Pose2> other = rounded(better);
    if (driven(other) < driven(arcs)) arcs = std::move(other);
    offer_optimised({{std::move(arcs), {}, false}});
  }

  // Poses in the middle of each piece of the line.
  std::vector<Pose2> rounded(const Line2& sharp) const {
    std::vector<Pose2> poses{start_};
    for (std::size_t k = 0; k + 1 < sharp.size(); ++k) {
      const Vec2 delta_m = sharp[k + 1] - sharp[k];
      if (delta_m.norm() < same_place_m) continue;
      const double yaw_rad = std::atan2(delta_m.y(), delta_m.x());
      const bool is_last = k + 2 == sharp.size();
      poses.push_back({is_last ? sharp[k + 1] : Vec2(sharp[k] + delta_m / 2), yaw_rad});
    }
    if (poses.size() > 1) poses.back().at_m = sharp.back();  // even if the last piece was left out
    return poses;
  }
  // Cost of driving over these poses; infinite where arcs have no room.
  double driven(const std::vector<Pose2>& arcs) {
    return arcs.size() > 1 ? costs_.driven(steering_.line(arcs)) : infinite;
  }
  double driven(Stretches over) {
    for (Stretch& stretch : over) stretch.line = steering_.line(stretch.poses);
    return lsos::driven(costs_, over);
  }

  void search(const Line2& over_lattice) {
    const Corridor corridor(costs_.map(), over_lattice, corridor_radii * radius_m_);
    const bool is_only_to_better = best_.is_found();
    PoseRoute found;
    const auto look = [&](std::size_t poses_most, const PoseGuide& guide) {
      const std::size_t poses = std::min(poses_most, poses_left_);
      found = search_poses(costs_, start_, goal_m_, radius_m_, poses, guide);
      poses_left_ -= std::min(poses_left_, found.expanded);
      const auto off_m = [&](const Vec2& at_m) { return (at_m - goal_m_).norm(); };
      if (off_m(found.nearest_m) < off_m(best_.nearest_m)) best_.nearest_m = found.nearest_m;
    };
    look(poses_to_better, {&corridor, true, false});
    if (!found.is_found() && is_only_to_better) look(poses_to_better, {&corridor, false, false});
    if (!found.is_found() && !is_only_to_better) {
      look(poses_to_better, {&corridor, true, true});
      if (!found.is_found()) look(poses_max, {nullptr, false, true});
      best_.is_start_blocked = found.is_start_blocked;
    }
    best_.is_at_border = found.is_at_border;
    if (found.is_found()) {
      offer_optimised(found.stretches);
      // Steering between its poses may lead over other places than the line that was searched.
      offer(std::move(found.stretches));
    }
    // The yaw at the goal is free, so one arc and a straight line may do.
    for (const bool to_left : {true, false}) {
      for (const double wider : {1, 2, 4, 8}) {
        auto direct = arc_and_straight(start_, goal_m_, wider * radius_m_, to_left, spacing_m_);
        if (direct) offer_line(std::move(*direct));
      }
    }
  }

  RouteCost& costs_;
  double spacing_m_;
  Pose2 start_;
  Vec2 goal_m_;
  double radius_m_;
  std::uint64_t seed_;
  std::size_t& poses_left_;
  RouteSteering steering_;
  CarRoute best_;
  double least_ = infinite;
};

}  // namespace

CarRoute car_route(RouteCost& costs, const DriveCost& cost, const Pose2& start, const Vec2& goal_m,
                   double radius_m, std::uint64_t seed, std::size_t& poses_left,
                   const Stretches& known) {
  return Planner(costs, cost, start, goal_m, radius_m, seed, poses_left).run(known);
}

}  // namespace lsos
