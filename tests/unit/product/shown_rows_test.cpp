// What pages show of layers that grow with a run.
#include "product/shown_rows.h"

#include <gmock/gmock.h>

#include "unit/record/log_fixture.h"

namespace lsos {
namespace {

PlannedPathRow path(int number, std::size_t points) {
  PlannedPathRow row;
  row.time = SimTime{number * 1'000'000LL};
  row.rover_id = "SEV1";
  for (std::size_t k = 0; k < points; ++k) {
    row.line.push_back(geodetic_from_degrees(20 + 1e-6 * static_cast<double>(k), 30, 0));
  }
  return row;
}

struct Seen {
  ShownRows rows;
  std::vector<double> times_s;
};

Seen seen_of(std::size_t count, std::size_t points) {
  const TestFolder folder;
  LogWriter log(folder / "log.gpkg", moon_crs, test_start());
  for (std::size_t k = 0; k < count; ++k) log.write(path(static_cast<int>(k), points));
  log.finish();
  Seen seen;
  seen.rows = for_each_shown_path(LogReader(folder / "log.gpkg"), [&](const PlannedPathRow& row) {
    seen.times_s.push_back(seconds(row.time));
    EXPECT_EQ(row.line.size(), points);
  });
  return seen;
}

TEST(ShownPaths, are_all_where_there_are_few) {
  const Seen seen = seen_of(300, 2);
  EXPECT_TRUE(seen.rows.is_whole());
  EXPECT_EQ(seen.times_s.size(), 300u);
}

TEST(ShownPaths, are_spread_over_the_run_where_there_are_many) {
  const Seen seen = seen_of(3 * shown_paths_max, 2);
  EXPECT_EQ(seen.times_s.size(), shown_paths_max);
  EXPECT_EQ(seen.rows.in_log, 3 * shown_paths_max);
  EXPECT_EQ(seen.times_s.front(), 0);
  EXPECT_EQ(seen.times_s.back(), 3 * shown_paths_max - 1);
  EXPECT_EQ(shown_text(seen.rows, "planned paths"),
            "5000 of 15000 planned paths; log.gpkg has all");
}

TEST(ShownPaths, have_few_points_together) {
  const std::size_t points = shown_path_points_max / 20;
  const Seen seen = seen_of(25, points);
  EXPECT_EQ(seen.times_s.size(), 20u);
  EXPECT_FALSE(seen.rows.is_whole());
}

}  // namespace
}  // namespace lsos
