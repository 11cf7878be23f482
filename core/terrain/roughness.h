// A self-affine surface on the nodes of a grid: octaves of smooth random waves. The RMS deviation
// follows the power law from two nodes to a sixteenth of the longest wave, and levels off there.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "terrain/height_tile.h"
#include "terrain/terrain_spec.h"

namespace lsos {

// Every `stride`-th node of the grid from (column, row) on.
struct NodeLattice {
  std::int64_t column = 0;
  std::int64_t row = 0;
  std::int64_t stride = 1;
};

class RoughnessField {
 public:
  // `spacing_m` of the grid's nodes. Where the grid goes around the body after `period` nodes, so
  // does the surface; the longest wave must then divide it.
  RoughnessField(const Roughness& roughness, std::uint64_t seed, double spacing_m,
                 std::int64_t period = 0);

  // Adds the surface to all nodes of the tile, which lie on `at`. The height of a node does not
  // depend on the tile or the stride that it is asked with, but for rounding.
  void add_to(HeightTile& tile, const NodeLattice& at) const;

 private:
  // Normal random numbers on every `spacing`-th node, smoothed by cubic B-splines.
  struct Octave {
    std::uint64_t key;
    int spacing_log2;  // nodes
    double amplitude_m;
  };
  void add_octave(const Octave& octave, HeightTile& tile, const NodeLattice& at) const;

  std::vector<Octave> octaves_;
  std::int64_t period_;
};

}  // namespace lsos
