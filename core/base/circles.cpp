#include "base/circles.h"

#include <algorithm>

namespace lsos {

namespace {

enum class Colour { unseen, on_path, done };

}  // namespace

std::vector<std::vector<CircleStep>> find_circles(
    const std::vector<std::vector<std::size_t>>& edges) {
  std::vector<std::vector<CircleStep>> circles;
  std::vector<Colour> colours(edges.size());
  // The depth-first search's path. The edge of its last step is the one that is tried next.
  std::vector<CircleStep> path;
  const auto enter = [&](std::size_t node) {
    colours[node] = Colour::on_path;
    path.push_back({node, 0});
  };
  for (std::size_t start = 0; start < edges.size(); ++start) {
    if (colours[start] == Colour::unseen) enter(start);
    while (!path.empty()) {
      const CircleStep step = path.back();
      if (step.edge == edges[step.node].size()) {
        colours[step.node] = Colour::done;
        path.pop_back();
        if (!path.empty()) ++path.back().edge;
        continue;
      }
      const std::size_t to = edges[step.node][step.edge];
      if (colours[to] == Colour::unseen) {
        enter(to);
        continue;
      }
      if (colours[to] == Colour::on_path) {
        circles.emplace_back(std::ranges::find(path, to, &CircleStep::node), path.end());
      }
      ++path.back().edge;
    }
  }
  return circles;
}

}  // namespace lsos
