// Finds circles in a directed graph, such as events that wait for each other.
#pragma once

#include <cstddef>
#include <vector>

namespace lsos {

// A step along an edge: from a node, by which of its edges.
struct CircleStep {
  std::size_t node = 0, edge = 0;

  bool operator==(const CircleStep&) const = default;
};

// `edges`: where those of each node lead. Each circle is a list of steps from one node back to it.
// At least one circle is found of every set of nodes that reach each other. Circles may share
// nodes; all are found in one pass, so their number is at most that of the edges. The search does
// not recurse: plans have chains of thousands of events.
std::vector<std::vector<CircleStep>> find_circles(
    const std::vector<std::vector<std::size_t>>& edges);

}  // namespace lsos
