// Where the cases of a study lie.
#include "study/sampling.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

namespace lsos::test {
namespace {

const std::vector<Dimension> three{{"b", 0}, {"a", 0}, {"c", 0}};

std::vector<double> column(const Sampler& sampler, const std::string& name, std::int64_t cases) {
  std::vector<double> values;
  for (std::int64_t number = 1; number <= cases; ++number) {
    values.push_back(sampler.shares(number).at(name));
  }
  return values;
}

class AnySampling : public ::testing::TestWithParam<Sampling> {};

TEST_P(AnySampling, gives_shares_of_one) {
  const Sampler sampler(GetParam(), 1, 100, three);
  for (const char* name : {"a", "b", "c"}) {
    for (const double share : column(sampler, name, 100)) {
      EXPECT_GE(share, 0);
      EXPECT_LT(share, 1);
    }
  }
}

TEST_P(AnySampling, depends_on_the_root_seed) {
  const Sampler one(GetParam(), 1, 100, three), two(GetParam(), 2, 100, three);
  EXPECT_NE(column(one, "a", 10), column(two, "a", 10));
  EXPECT_EQ(column(one, "a", 10), column(Sampler(GetParam(), 1, 100, three), "a", 10));
}

TEST_P(AnySampling, takes_dimensions_in_any_order) {
  const Sampler one(GetParam(), 1, 100, three),
      two(GetParam(), 1, 100, {{"c", 0}, {"b", 0}, {"a", 0}});
  for (const char* name : {"a", "b", "c"}) {
    EXPECT_EQ(column(one, name, 100), column(two, name, 100));
  }
}

INSTANTIATE_TEST_SUITE_P(Sampling, AnySampling,
                         ::testing::Values(Sampling::random, Sampling::latin_hypercube,
                                           Sampling::sobol),
                         [](const auto& each) { return std::string(to_string(each.param)); });

TEST(Sampler, keeps_earlier_cases_when_there_are_more) {
  for (const Sampling sampling : {Sampling::random, Sampling::sobol}) {
    const Sampler few(sampling, 3, 10, three), many(sampling, 3, 1000, three);
    EXPECT_EQ(column(few, "b", 10), column(many, "b", 10)) << to_string(sampling);
  }
  const std::vector<Dimension> grid{{"x", 3}, {"y", 4}};
  EXPECT_EQ(column(Sampler(Sampling::grid, 0, 5, grid), "y", 5),
            column(Sampler(Sampling::grid, 0, 12, grid), "y", 5));
}

// What a parameter draws at random depends on its own name alone, so that one more parameter
// changes nothing of the others.
TEST(Sampler, draws_each_dimension_by_its_name) {
  const Sampler three_of(Sampling::random, 3, 10, three), one(Sampling::random, 3, 10, {{"b", 0}});
  EXPECT_EQ(column(three_of, "b", 10), column(one, "b", 10));
}

TEST(Sampler, gives_each_stratum_of_a_latin_hypercube_once) {
  const Sampler sampler(Sampling::latin_hypercube, 5, 50, three);
  for (const char* name : {"a", "b", "c"}) {
    std::set<int> strata;
    for (const double share : column(sampler, name, 50)) {
      strata.insert(static_cast<int>(share * 50));
    }
    EXPECT_EQ(strata.size(), 50u) << name;
  }
}

// A (0, m, 2) net in base 2: each elementary interval of the first two dimensions holds one point.
TEST(Sampler, makes_a_net_of_sobols_points) {
  constexpr int power = 6, count = 1 << power;
  const Sampler sampler(Sampling::sobol, 9, count, {{"a", 0}, {"b", 0}});
  const std::vector<double> a = column(sampler, "a", count), b = column(sampler, "b", count);
  for (int bits = 0; bits <= power; ++bits) {
    const int columns = 1 << bits, rows = count / columns;
    std::set<std::pair<int, int>> cells;
    for (int i = 0; i < count; ++i) {
      cells.insert({static_cast<int>(a[static_cast<std::size_t>(i)] * columns),
                    static_cast<int>(b[static_cast<std::size_t>(i)] * rows)});
    }
    EXPECT_EQ(cells.size(), static_cast<std::size_t>(count)) << columns << " x " << rows;
  }
}

TEST(Sampler, goes_through_a_grid_with_its_last_dimension_first) {
  const std::vector<Dimension> grid{{"y", 2}, {"x", 3}};
  const Sampler sampler(Sampling::grid, 0, 6, grid);
  std::vector<std::pair<int, int>> points;
  for (std::int64_t number = 1; number <= 6; ++number) {
    const auto shares = sampler.shares(number);
    points.emplace_back(static_cast<int>(shares.at("x") * 3), static_cast<int>(shares.at("y") * 2));
  }
  EXPECT_THAT(points, ::testing::ElementsAre(std::pair(0, 0), std::pair(0, 1), std::pair(1, 0),
                                             std::pair(1, 1), std::pair(2, 0), std::pair(2, 1)));
  EXPECT_EQ(grid_size(grid), 6);
  EXPECT_EQ(grid_size({{"a", 5000}, {"b", 5000}}), cases_max + 1);
}

}  // namespace
}  // namespace lsos::test
