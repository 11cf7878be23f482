#include "base/circles.h"

#include <gtest/gtest.h>

namespace lsos {
namespace {

using Circle = std::vector<CircleStep>;

TEST(Circles, are_none_in_a_graph_without_any) {
  EXPECT_TRUE(find_circles({}).empty());
  EXPECT_TRUE(find_circles({{1, 2}, {2}, {}}).empty());
}

TEST(Circles, have_the_edges_that_they_go_along) {
  const auto circles = find_circles({{2, 1}, {3, 0}, {}, {}});
  ASSERT_EQ(circles.size(), 1u);
  EXPECT_EQ(circles[0], (Circle{{0, 1}, {1, 1}}));
}

TEST(Circles, of_one_node_are_found) { EXPECT_EQ(find_circles({{0}})[0], (Circle{{0, 0}})); }

// The search goes on behind a circle: others that begin on the same path are found too.
TEST(Circles, are_all_found_in_one_pass) {
  const auto circles = find_circles({{1}, {0, 2}, {3}, {2}, {5}, {4}});
  ASSERT_EQ(circles.size(), 3u);
  EXPECT_EQ(circles[0], (Circle{{0, 0}, {1, 0}}));
  EXPECT_EQ(circles[1], (Circle{{2, 0}, {3, 0}}));
  EXPECT_EQ(circles[2], (Circle{{4, 0}, {5, 0}}));
}

TEST(Circles, are_found_at_the_end_of_long_chains) {
  std::vector<std::vector<std::size_t>> edges(100000);
  for (std::size_t i = 0; i < edges.size(); ++i) edges[i] = {(i + 1) % edges.size()};
  EXPECT_EQ(find_circles(edges)[0].size(), edges.size());
}

}  // namespace
}  // namespace lsos
