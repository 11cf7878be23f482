#include "route/fewer_poses.h"

#include <algorithm>
#include <array>
#include <limits>

namespace lsos {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
// A piece is as long as so many distances of the poses, and passes over no more than so many.
constexpr double reach_aparts = 5;
constexpr std::size_t reach = 5;
// Distance of the poses at first, in spacings of the map, and from one look to the next.
constexpr double first_apart_spacings = 2, growth = 4;
constexpr double gain_worth = 0.002;

std::vector<Pose2> with_poses_between(const RouteSteering& steering,
                                      const std::vector<Pose2>& poses, double apart_m) {
  std::vector<Pose2> dense{poses.front()};
  for (std::size_t k = 0; k + 1 < poses.size(); ++k) {
    const int pieces =
        std::max(1, static_cast<int>(steering.length_m(poses[k], poses[k + 1]) / apart_m));
    for (int piece = 1; piece < pieces; ++piece) {
      dense.push_back(
          steering.between(poses[k], poses[k + 1], static_cast<double>(piece) / pieces));
    }
    dense.push_back(poses[k + 1]);
  }
  return dense;
}

// A way to a pose by a piece over so many of them.
struct Arrival {
  double cost = infinite;
  std::size_t over_before = 0;  // of the piece before it
};

// The cheapest route over `poses` whose pieces are no longer than that.
std::vector<Pose2> cheapest_over(LegCosts& costs, const RouteSteering& steering,
                                 const std::vector<Pose2>& poses, double longest_m) {
  std::vector<std::array<Arrival, reach + 1>> arrivals(poses.size());
  for (std::size_t to = 1; to < poses.size(); ++to) {
    double least_here = infinite;
    for (std::size_t over = 1; over <= std::min(reach, to); ++over) {
      const std::size_t from = to - over;
      if (over > 1 && (poses[to].at_m - poses[from].at_m).norm() > longest_m) break;
      // Without corners only the cheapest arrival counts.
      double most = infinite;
      if (!steering.is_straight() && from > 0) {
        const double before = std::ranges::min_element(arrivals[from], {}, &Arrival::cost)->cost;
        if (before == infinite) continue;
        most = least_here - before;
      }
      const double piece = costs.driven(steering.way(poses[from], poses[to]), most);
      if (piece == infinite) continue;
      Arrival& best = arrivals[to][over];
      if (from == 0) best.cost = piece;
      for (std::size_t over_before = 1; over_before <= std::min(reach, from); ++over_before) {
        const double least = arrivals[from][over_before].cost + piece;
        if (least >= best.cost) continue;
        const double cost =
            least + costs.corner(poses[from - over_before].at_m, poses[from].at_m, poses[to].at_m);
        if (cost < best.cost) best = {cost, over_before};
      }
      least_here = std::min(least_here, best.cost);
    }
  }
  std::size_t to = poses.size() - 1;
  const auto& ends = arrivals[to];
  const auto best = std::ranges::min_element(ends, {}, &Arrival::cost);
  if (best->cost == infinite) return poses;
  auto over = static_cast<std::size_t>(best - ends.begin());
  std::vector<Pose2> fewer{poses.back()};
  while (to > 0) {
    const std::size_t over_before = arrivals[to][over].over_before;
    to -= over;
    over = over_before;
    fewer.push_back(poses[to]);
  }
  std::ranges::reverse(fewer);
  return fewer;
}

}  // namespace

std::vector<Pose2> with_fewer_poses(LegCosts& costs, const RouteSteering& steering,
                                    std::vector<Pose2> poses) {
  double length_m = 0;
  for (std::size_t k = 0; k + 1 < poses.size(); ++k) {
    length_m += steering.length_m(poses[k], poses[k + 1]);
  }
  double least = costs.driven(steering.line(poses));
  bool gains = true;
  // At the end without poses between, as long as that is worth the work.
  for (double apart_m = first_apart_spacings * costs.map().spacing_m(); apart_m < length_m || gains;
       apart_m *= growth) {
    std::vector<Pose2> fewer = cheapest_over(
        costs, steering, with_poses_between(steering, poses, apart_m), reach_aparts * apart_m);
    const double cost = costs.driven(steering.line(fewer));
    gains = cost < (1 - gain_worth) * least;
    if (!(cost < least)) continue;
    least = cost;
    poses = std::move(fewer);
  }
  const std::vector<Pose2> direct{poses.front(), poses.back()};
  const double straight = costs.driven(steering.line(direct));
  return straight < infinite && straight <= least ? direct : poses;
}

}  // namespace lsos
