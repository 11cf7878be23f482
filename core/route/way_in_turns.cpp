#include "route/way_in_turns.h"

#include <limits>
#include <utility>

#include "base/polyline.h"
#include "route/refine/fewer_points.h"
#include "route/refine/fewer_poses.h"
#include "route/search/grid_search.h"
#include "route/search/turning_search.h"

namespace lsos {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
// A piece shorter than this leads nowhere.
constexpr double same_m = 1e-3;
// Points nearer than this to the line between their neighbours are left out.
constexpr double thinned_m = 0.01;
constexpr double thinned_worth = 1.001;
// Poses are searched where the rounded way costs so much more than that over the lattice; and no
// more than so many of them, where there is a rounded way and where there is none.
constexpr double poses_worth = 1.05;
constexpr std::size_t poses_to_better = 160'000, poses_max = 520'000;
// About the way over the lattice first, so many radii to either side: over 400 m of rough ground
// that takes less than half of the time, for ways that cost 1 % more in the mean. With 8 for 6 a
// kilometre takes a fifth longer, for 0.1 % less.
constexpr double near_radii = 6;

// The cheapest of the ways that are offered.
class Planner {
 public:
  Planner(LegCosts& costs, const DriveCost& cost, const Pose2& start, const Vec2& goal_m,
          double radius_m, std::uint64_t seed)
      : costs_(costs),
        spacing_m_(costs.map().spacing_m()),
        start_(start),
        goal_m_(goal_m),
        radius_m_(radius_m),
        seed_(seed),
        steering_(RouteSteering::in_turns(radius_m, spacing_m_,
                                          [&](double of_m) { return arc_price_m(cost, of_m); })) {}

  // The way over the lattice with its corners rounded is found at once and mostly smooth; poses are
  // searched where it costs more than that of a rover without turns to make.
  WayInTurns run(const std::vector<Pose2>& known) {
    WayInTurns answer;
    answer.nearest_m = start_.at_m;
    if (driven(known) < infinite) offer_refined(known);
    if (!best_) look(answer);
    if (!best_) return answer;
    // Points so near to each other that the rover slows down for corners that are none.
    Line2 thin = simplified(best_->line, thinned_m);
    if (costs_.driven(thin) <= thinned_worth * least_) best_->line = std::move(thin);
    answer.way = std::move(best_);
    answer.unrefined = std::move(unrefined_);
    return answer;
  }

 private:
  void look(WayInTurns& answer) {
    const GridRoute over_lattice = search_grid(costs_, start_.at_m, goal_m_);
    round(over_lattice.line);
    if (!(least_ <= poses_worth * over_lattice.cost)) {
      search(over_lattice.line, answer);
      answer.is_turn_too_wide = !best_;
    }
  }

  void offer(Refined other, std::vector<Pose2> unrefined = {}) {
    const double cost = costs_.driven(other.line);
    if (!(cost < least_)) return;
    least_ = cost;
    best_ = std::move(other);
    unrefined_ = std::move(unrefined);
  }
  void offer_refined(const std::vector<Pose2>& poses) {
    offer(refined(costs_, steering_, poses, seed_), poses);
  }

  // A line with sharp corners made as cheap as their rounding lets it be, then rounded. Where its
  // arcs have no room they hardly ever have it after moves.
  void round(const Line2& over_lattice) {
    if (over_lattice.empty()) return;
    const RouteSteering sharp = RouteSteering::on_the_spot();
    std::vector<Pose2> poses;
    for (const Vec2& at_m : corners(over_lattice)) poses.push_back({at_m, 0});
    costs_.set_rounding(true);
    poses = with_fewer_poses(costs_, sharp, std::move(poses));
    costs_.set_rounding(false);
    std::vector<Pose2> arcs = rounded(sharp.line(poses));
    if (driven(arcs) == infinite) return;
    costs_.set_rounding(true);
    const Line2 better = moved(costs_, sharp, poses, seed_).line;
    costs_.set_rounding(false);
    std::vector<Pose2> other = rounded(better);
    if (driven(other) < driven(arcs)) arcs = std::move(other);
    offer_refined(arcs);
  }

  // By way of the middle of each of its pieces.
  std::vector<Pose2> rounded(const Line2& sharp) const {
    std::vector<Pose2> poses{start_};
    for (std::size_t k = 0; k + 1 < sharp.size(); ++k) {
      const Vec2 way_m = sharp[k + 1] - sharp[k];
      if (way_m.norm() < same_m) continue;
      const double yaw_rad = std::atan2(way_m.y(), way_m.x());
      const bool is_last = k + 2 == sharp.size();
      poses.push_back({is_last ? sharp[k + 1] : Vec2(sharp[k] + way_m / 2), yaw_rad});
    }
    if (poses.size() > 1) poses.back().at_m = sharp.back();  // whatever was left out
    return poses;
  }
  // Infinite where arcs have no room.
  double driven(const std::vector<Pose2>& arcs) {
    return arcs.size() > 1 ? costs_.driven(steering_.line(arcs)) : infinite;
  }

  void search(const Line2& over_lattice, WayInTurns& answer) {
    const Tube near(costs_.map(), over_lattice, near_radii * radius_m_);
    const std::size_t poses = best_ ? poses_to_better : poses_max;
    const auto look = [&](std::size_t poses_left, const TurningGuide& guide) {
      return search_turning(costs_, start_, goal_m_, radius_m_, poses_left, guide);
    };
    TurningRoute way = look(poses_to_better, {&near, true});
    if (way.line.empty()) way = look(poses_to_better, {&near, false});
    if (way.line.empty() && !way.is_shut_in) way = look(poses, {});
    answer.is_at_border = way.is_at_border;
    answer.nearest_m = way.nearest_m;
    if (!way.line.empty()) {
      offer_refined(way.poses);
      // What its poses are joined by may look at other places than the search did.
      offer({way.line, {}});
    }
    // The yaw at the goal is free.
    for (const bool to_left : {true, false}) {
      for (const double wider : {1, 2, 4, 8}) {
        auto direct = arc_and_straight(start_, goal_m_, wider * radius_m_, to_left, spacing_m_);
        if (direct) offer({std::move(*direct), {}});
      }
    }
  }

  LegCosts& costs_;
  double spacing_m_;
  Pose2 start_;
  Vec2 goal_m_;
  double radius_m_;
  std::uint64_t seed_;
  RouteSteering steering_;
  std::optional<Refined> best_;
  std::vector<Pose2> unrefined_;  // of it
  double least_ = infinite;
};

}  // namespace

WayInTurns way_in_turns(LegCosts& costs, const DriveCost& cost, const Pose2& start,
                        const Vec2& goal_m, double radius_m, std::uint64_t seed,
                        const std::vector<Pose2>& known) {
  return Planner(costs, cost, start, goal_m, radius_m, seed).run(known);
}

}  // namespace lsos
