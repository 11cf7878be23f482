// A self-affine surface on the nodes of a grid: octaves of smooth random waves. The RMS deviation
// follows the power law from two nodes to a sixteenth of the longest wave, and levels off there.
#pragma once

#include <cstdint>
#include <vector>

#include "terrain/detail/volume_lattice.h"
#include "terrain/grid/node_lattice.h"
#include "terrain/spec/terrain_spec.h"

namespace lsos {

// Grid that carries the surface.
struct RoughnessGrid {
  double spacing_m = 1;        // mean spacing of the nodes along rows and columns
  double height_to_width = 1;  // aspect of cells; waves are round to a factor of sqrt 2 even so
  // Nodes once around the body, after which the surface repeats; its waves then divide that. 0: the
  // grid does not go around.
  std::int64_t period = 0;
};

class RoughnessField {
 public:
  RoughnessField(const Roughness& roughness, std::uint64_t seed, const RoughnessGrid& grid);

  // Adds the surface to all nodes of the tile, which lie on `at`. But for rounding, the height of a
  // node does not depend on the tile or the stride that it is computed with.
  void add_to(HeightTile& tile, const NodeLattice& at) const;
  // Adds the volumes of waves of that level and above at the lattice's scale. Waves of less than
  // half its spacing hold next to nothing there.
  void add_volumes(VolumeLattice& lattice, int level) const;

 private:
  // Normal random numbers on every 2^k-th node, smoothed by cubic B-splines.
  struct Octave {
    std::uint64_t key;
    int k;
    double amplitude_m;
  };
  void add_octave(const Octave& octave, HeightTile& tile, const NodeLattice& at) const;
  void add_volumes(const Octave& octave, VolumeLattice& lattice) const;
  // Amplitudes of an octave's waves along a row of its lattice, from a column on.
  void fill_row(const Octave& octave, std::int64_t first, std::int64_t row,
                std::vector<double>& values) const;

  std::vector<Octave> octaves_;
  std::int64_t period_;
  int along_row_log2_ = 0;  // log2 of how many times more nodes lie along rows
  int along_column_log2_ = 0;
};

}  // namespace lsos
