#include "route/refine/shortcut.h"

#include <algorithm>
#include <array>
#include <limits>

#include "base/rounding.h"

namespace lsos {

namespace {

// Greatest length of a piece, in distances between poses, and how many poses it advances at most.
constexpr double reach_aparts = 5;
constexpr std::size_t reach = 5;
// Distance between poses in the first pass, in map spacings, and its growth from pass to pass.
constexpr double first_apart_spacings = 2, growth = 4;
constexpr double gain_min = 0.002;

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

struct Shortcut {
  std::vector<Pose2> poses;
  bool was_limited = false;  // longer pieces might change the result
};

// Always false for neighbours, between which there is no shorter piece.
bool is_longer(const std::vector<Pose2>& poses, std::size_t from, std::size_t to, double most_m) {
  return to - from > 1 && (poses[to].at_m - poses[from].at_m).norm() > most_m;
}

// Cheapest route to a pose whose last piece advances a given number of poses.
struct Arrival {
  double cost = infinite;
  std::size_t over_before = 0;  // advance of the piece before it
};

// Cheapest route over `poses` with pieces up to `longest_m`, corners included.
Shortcut cheapest_by_corners(RouteCost& costs, const RouteSteering& steering,
                             const std::vector<Pose2>& poses, double longest_m) {
  Shortcut result{{poses.back()}};
  std::vector<std::array<Arrival, reach + 1>> arrivals(poses.size());
  for (std::size_t to = 1; to < poses.size(); ++to) {
    for (std::size_t over = 1; over <= std::min(reach, to); ++over) {
      const std::size_t from = to - over;
      result.was_limited = result.was_limited || is_longer(poses, from, to, longest_m);
      if (is_longer(poses, from, to, longest_m)) break;
      const double piece = costs.driven(steering.path(poses[from], poses[to]));
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
    }
  }
  std::size_t to = poses.size() - 1;
  const auto& ends = arrivals[to];
  const auto best = std::ranges::min_element(ends, {}, &Arrival::cost);
  if (best->cost == infinite) return {poses, result.was_limited};
  auto over = static_cast<std::size_t>(best - ends.begin());
  while (to > 0) {
    const std::size_t over_before = arrivals[to][over].over_before;
    to -= over;
    over = over_before;
    result.poses.push_back(poses[to]);
  }
  std::ranges::reverse(result.poses);
  return result;
}

// The same for Dubins paths: keeps the cheapest route to each pose and the speeds of the rover
// there. Pieces priced one by one would each begin at full speed, so that routes of many pieces
// would seem too costly.
Shortcut cheapest_dubins(RouteCost& costs, const RouteSteering& steering,
                         const std::vector<Pose2>& poses, double longest_m) {
  struct Reached {
    double cost = infinite;
    std::size_t from = 0;
    RouteCost::ArcState speeds;
  };
  Shortcut result{{poses.back()}};
  std::vector<Reached> reached(poses.size());
  reached.front().cost = 0;
  for (std::size_t to = 1; to < poses.size(); ++to) {
    Reached& best = reached[to];
    for (std::size_t from = to; from-- > to - std::min(reach, to);) {
      result.was_limited = result.was_limited || is_longer(poses, from, to, longest_m);
      if (is_longer(poses, from, to, longest_m)) break;
      if (reached[from].cost >= best.cost) continue;
      const Line2 path = steering.path(poses[from], poses[to]);
      RouteCost::ArcState speeds = reached[from].speeds;
      const double before = reached[from].cost + costs.arcs(speeds, path);
      const double cost = before + costs.along(path, best.cost - before);
      if (cost < best.cost) best = {cost, from, speeds};
    }
  }
  if (reached.back().cost == infinite) return {poses, result.was_limited};
  for (std::size_t at = poses.size() - 1; at > 0;) {
    at = reached[at].from;
    result.poses.push_back(poses[at]);
  }
  std::ranges::reverse(result.poses);
  return result;
}

}  // namespace

std::vector<Pose2> shortcut(RouteCost& costs, const RouteSteering& steering,
                            std::vector<Pose2> poses) {
  double length_m = 0;
  for (std::size_t k = 0; k + 1 < poses.size(); ++k) {
    length_m += steering.length_m(poses[k], poses[k + 1]);
  }
  double least = costs.driven(steering.line(poses));
  bool gains = true;
  // When `apart_m` exceeds the length no poses are inserted, and passes go on while they gain
  // enough.
  for (double apart_m = first_apart_spacings * costs.map().spacing_m(); apart_m < length_m || gains;
       apart_m *= growth) {
    const std::vector<Pose2> dense = with_poses_between(steering, poses, apart_m);
    const auto cheapest = steering.is_straight() ? cheapest_by_corners : cheapest_dubins;
    Shortcut result = cheapest(costs, steering, dense, reach_aparts * apart_m);
    const double cost = costs.driven(steering.line(result.poses));
    gains = cost < (1 - gain_min) * least;
    if (cost < least) {
      least = cost;
      poses = std::move(result.poses);
    } else if (dense.size() == poses.size() && !result.was_limited) {
      break;  // further passes would be the same
    }
  }
  const std::vector<Pose2> direct{poses.front(), poses.back()};
  const double straight = costs.driven(steering.line(direct));
  return straight < infinite && straight <= least ? direct : poses;
}

}  // namespace lsos
