// Values of the nodes of a sparse lattice are independent of each other.
#include "route/map/tiled_grid.h"

#include <gtest/gtest.h>

namespace lsos::test {
namespace {

struct Note {
  int of = -1;
};

TEST(TiledGrid, keeps_what_is_set_of_each_node) {
  // Neither is a whole number of tiles.
  constexpr int columns = 37, rows = 50;
  TiledGrid<Note> notes(columns, rows);
  const auto number = [&](int column, int row) { return row * columns + column; };
  for (int row = 0; row < rows; ++row) {
    for (int column = row % 2; column < columns; column += 2) {
      notes(column, row).of = number(column, row);
    }
  }
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const bool is_set = column % 2 == row % 2;
      EXPECT_EQ(notes(column, row).of, is_set ? number(column, row) : -1) << column << ' ' << row;
    }
  }
}

}  // namespace
}  // namespace lsos::test
