#include "route/search/reachability.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <queue>
#include <tuple>
#include <vector>

namespace lsos {

namespace {

// Greatest number of expanded nodes: a square kilometre of a small rover's map, which takes some
// seconds.
constexpr std::size_t expanded_max = 6'000'000;
// The search for the place nearest to the goal ends when this many nodes, plus as many as were
// expanded before it, have brought nothing nearer.
constexpr std::size_t nearest_nodes = 50'000;

class Flood {
 public:
  // `mark` marks its nodes in `marks`; `to_m` is the place that it makes for. Backward: it expands
  // to nodes from which its first nodes can be reached.
  Flood(RouteCost& costs, std::vector<std::uint8_t>& marks, std::uint8_t mark, const Vec2& to_m,
        bool is_backward)
      : costs_(costs),
        map_(costs.map()),
        marks_(marks),
        mark_(mark),
        to_m_(to_m),
        is_backward_(is_backward) {}

  bool is_closed() const { return queue_.empty(); }
  bool is_at_border() const { return is_at_border_; }
  bool has_met() const { return has_met_; }
  std::size_t size() const { return size_; }
  double nearest_off_m() const { return nearest_off_m_; }
  const Vec2& nearest_m() const { return nearest_m_; }

  // Adds a node to begin with.
  void add(int column, int row) { expand(number(column, row)); }

  // Expands the next candidate, if its edge is free. An edge is evaluated when its node first comes
  // up: mostly one of eight.
  void expand_next() {
    const auto [off_m, node, from] = queue_.top();
    queue_.pop();
    if ((marks_[static_cast<std::size_t>(node)] & mark_) != 0) return;
    const Vec2 here_m = place(node), before_m = place(from);
    const bool is_free =
        is_backward_ ? costs_.is_free(here_m, before_m) : costs_.is_free(before_m, here_m);
    if (!is_free) return;
    expand(node);
    if (!is_backward_) update_nearest(here_m, before_m);
  }

  void set_nearest(const Vec2& at_m) {
    nearest_m_ = at_m;
    nearest_off_m_ = (at_m - to_m_).norm();
  }

 private:
  std::int32_t number(int column, int row) const { return row * map_.columns() + column; }
  Vec2 place(std::int32_t node) const {
    return map_.place_m(node % map_.columns(), node / map_.columns());
  }

  void expand(std::int32_t node) {
    auto& marks = marks_[static_cast<std::size_t>(node)];
    if ((marks & mark_) != 0) return;
    marks |= mark_;
    ++size_;
    has_met_ = has_met_ || marks != mark_;
    is_at_border_ = is_at_border_ || costs_.is_at_border(place(node));
    const int column = node % map_.columns(), row = node / map_.columns();
    for (int y = row - 1; y <= row + 1; ++y) {
      for (int x = column - 1; x <= column + 1; ++x) {
        if (x < 0 || y < 0 || x >= map_.columns() || y >= map_.rows()) continue;
        const std::int32_t next = number(x, y);
        if ((marks_[static_cast<std::size_t>(next)] & mark_) != 0) continue;
        queue_.push({static_cast<float>((place(next) - to_m_).norm()), next, node});
      }
    }
  }

  void update_nearest(const Vec2& at_m, const Vec2& from_m) {
    const double off_m = (at_m - to_m_).norm();
    if (off_m < nearest_off_m_ && costs_.can_stand(at_m, (at_m - from_m).normalized())) {
      set_nearest(at_m);
    }
  }

  RouteCost& costs_;
  GroundMap& map_;
  std::vector<std::uint8_t>& marks_;
  std::uint8_t mark_;
  Vec2 to_m_;
  bool is_backward_;
  bool is_at_border_ = false, has_met_ = false;
  std::size_t size_ = 0;
  double nearest_off_m_ = 0;
  Vec2 nearest_m_ = Vec2::Zero();
  using Entry = std::tuple<float, std::int32_t, std::int32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

}  // namespace

Reachability find_reachability(RouteCost& costs, const Vec2& start_m, const Vec2& goal_m,
                               bool only_nearest) {
  GroundMap& map = costs.map();
  std::vector<std::uint8_t> marks(static_cast<std::size_t>(map.columns()) *
                                  static_cast<std::size_t>(map.rows()));
  Flood from_start(costs, marks, 1, goal_m, false), to_goal(costs, marks, 2, start_m, true);
  const Vec2 start = (start_m - map.low_m()) / map.spacing_m();
  from_start.set_nearest(start_m);
  from_start.add(static_cast<int>(std::lround(start.x())),
                 static_cast<int>(std::lround(start.y())));
  // Nodes from which search_grid() reaches the goal.
  const Vec2 goal = (goal_m - map.low_m()) / map.spacing_m();
  const int column = static_cast<int>(std::lround(goal.x()));
  const int row = static_cast<int>(std::lround(goal.y()));
  for (int y = row - 1; y <= row + 1; ++y) {
    for (int x = column - 1; x <= column + 1; ++x) {
      if (x < 0 || y < 0 || x >= map.columns() || y >= map.rows()) continue;
      const Vec2 from_m = map.place_m(x, y);
      if ((from_m - goal_m).cwiseAbs().maxCoeff() > 1.01 * map.spacing_m()) continue;
      if (std::isfinite(costs.straight(from_m, goal_m))) to_goal.add(x, y);
    }
  }
  while (!only_nearest && !from_start.has_met() && !to_goal.has_met()) {
    if (from_start.is_closed() || to_goal.is_closed()) break;
    if (from_start.size() + to_goal.size() > expanded_max) break;
    Flood& smaller = to_goal.size() < from_start.size() ? to_goal : from_start;
    smaller.expand_next();
  }
  Reachability reach;
  if (!only_nearest && (from_start.has_met() || to_goal.has_met())) return reach;
  const bool is_start = from_start.is_closed();
  reach.is_at_border = is_start ? from_start.is_at_border() : to_goal.is_at_border();
  reach.answer = is_start              ? Reachability::Answer::start_enclosed
                 : to_goal.is_closed() ? Reachability::Answer::goal_enclosed
                                       : Reachability::Answer::given_up;
  // Nodes nearest to the goal are expanded first.
  const std::size_t more = nearest_nodes + from_start.size();
  std::size_t last = from_start.size();
  for (double off_m = from_start.nearest_off_m(); !from_start.is_closed();) {
    from_start.expand_next();
    if (from_start.nearest_off_m() < off_m) last = from_start.size();
    off_m = from_start.nearest_off_m();
    if (from_start.size() > last + more) break;
  }
  if (only_nearest) reach.is_at_border = from_start.is_at_border();
  reach.nearest_m = from_start.nearest_m();
  reach.expanded = from_start.size() + to_goal.size();
  return reach;
}

}  // namespace lsos
