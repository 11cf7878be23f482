// The choice of samples that show a rover's mission on a map.
#include "product/drive_marks.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace lsos {
namespace {

using ::testing::Contains;

SimTime after(double time_s) { return from_seconds(time_s); }

SampleRow row_at(double time_s, double distance_m, double speed_mps) {
  SampleRow row;
  row.time = after(time_s);
  row.distance_m = distance_m;
  row.speed_mps = speed_mps;
  return row;
}

EventRow drive_event(double start_s, double end_s) {
  EventRow event;
  event.rover_id = "A";
  event.start = after(start_s);
  event.end = after(end_s);
  return event;
}

// Three days at 60 s, then 20 m at 2 s, then an hour.
std::vector<SampleRow> pause_and_drive() {
  std::vector<SampleRow> rows;
  double time_s = 0;
  for (; time_s < 3 * 86400; time_s += 60) rows.push_back(row_at(time_s, 0, 0));
  for (double driven_m = 0; driven_m <= 20; driven_m += 2, time_s += 2) {
    rows.push_back(row_at(time_s, driven_m, driven_m < 20 ? 1 : 0));
  }
  for (int k = 0; k < 60; ++k, time_s += 60) rows.push_back(row_at(time_s, 20, 0));
  return rows;
}

SampleTotals totals_of(const std::vector<SampleRow>& rows) {
  SampleTotals totals{rows.size(), 0, rows.back().distance_m};
  for (const SampleRow& row : rows) totals.moving += row.speed_mps > moving_mps;
  return totals;
}

std::vector<double> kept_s(const std::vector<SampleRow>& rows, const std::vector<EventRow>& events,
                           std::size_t most) {
  DriveMarks marks(totals_of(rows), events, "A", most);
  KeptRows kept;
  for (const SampleRow& row : rows) kept.add(row, marks.next(row));
  std::vector<double> times_s;
  for (const SampleRow& row : kept.rows()) times_s.push_back(seconds(row.time));
  return times_s;
}

TEST(DriveMarks, show_all_of_a_short_drive_after_days_of_standing) {
  const double drive_s = 3 * 86400;
  const std::vector<EventRow> events{drive_event(0.1, drive_s),
                                     drive_event(drive_s, drive_s + 20.3)};
  const std::vector<double> times_s = kept_s(pause_and_drive(), events, 2000);
  for (double at_s = drive_s; at_s <= drive_s + 20; at_s += 2) {
    EXPECT_THAT(times_s, Contains(at_s));
  }
  EXPECT_EQ(times_s.front(), 0);
  EXPECT_EQ(times_s.back(), seconds(pause_and_drive().back().time));
  EXPECT_LT(times_s.size(), 25u) << "a few at a stop";
  EXPECT_TRUE(std::ranges::is_sorted(times_s));
  EXPECT_EQ(std::ranges::adjacent_find(times_s), times_s.end());
}

TEST(DriveMarks, are_evenly_spaced_along_a_drive_of_changing_speed) {
  std::vector<SampleRow> rows;
  double driven_m = 0;
  for (int k = 0; k < 200'000; ++k) {
    const double speed_mps = 1.2 + std::sin(1e-4 * k);
    rows.push_back(row_at(2 * k, driven_m, speed_mps));
    driven_m += 2 * speed_mps;
  }
  const std::vector<double> times_s = kept_s(rows, {}, 2000);
  EXPECT_LE(times_s.size(), 2000u);
  EXPECT_GT(times_s.size(), 1500u);
  std::vector<double> gaps_m;
  for (std::size_t k = 1; k + 1 < times_s.size(); ++k) {
    const auto of = [&](std::size_t i) {
      return rows[static_cast<std::size_t>(times_s[i] / 2)].distance_m;
    };
    gaps_m.push_back(of(k) - of(k - 1));
  }
  const auto [least_m, most_m] = std::ranges::minmax(gaps_m);
  EXPECT_LT(most_m - least_m, 2 * 4.4) << "rows are up to 4.4 m apart";
}

TEST(DriveMarks, have_the_first_and_last_row_of_each_event) {
  std::vector<SampleRow> rows;
  for (int k = 0; k < 50'000; ++k) rows.push_back(row_at(2 * k, 0, 0));
  std::vector<EventRow> events;
  for (int k = 0; k < 100; ++k) events.push_back(drive_event(1000.5 * k, 1000.5 * k + 61));
  const std::vector<double> times_s = kept_s(rows, events, 2000);
  for (const EventRow& event : events) {
    EXPECT_THAT(times_s, Contains(2 * std::ceil(seconds(*event.start) / 2)));
    EXPECT_THAT(times_s, Contains(2 * std::floor(seconds(*event.end) / 2)));
  }
  EXPECT_LE(times_s.size(), 502u);
}

// Stops or events alone would take up more rows than are allowed.
TEST(DriveMarks, keep_to_their_number_among_thousands_of_stops_and_events) {
  std::vector<SampleRow> rows;
  std::vector<EventRow> events;
  for (int k = 0; k < 30'000; ++k) {
    rows.push_back(row_at(2 * k, 0.5 * k, k % 3 == 0 ? 0 : 1));
    if (k % 5 == 0) events.push_back(drive_event(2 * k, 2 * k + 5));
  }
  for (const std::size_t most : {10u, 100u, 2000u}) {
    const std::vector<double> times_s = kept_s(rows, events, most);
    EXPECT_LE(times_s.size(), most);
    EXPECT_GT(times_s.size(), most / 3);
    EXPECT_EQ(std::ranges::adjacent_find(times_s), times_s.end());
  }
}

TEST(DriveMarks, show_a_rover_that_never_moves_once_and_at_its_end) {
  std::vector<SampleRow> rows;
  for (int k = 0; k < 10'000; ++k) rows.push_back(row_at(60 * k, 0, 0));
  EXPECT_EQ(kept_s(rows, {}, 2000), (std::vector<double>{0, 60.0 * 9999}));
}

}  // namespace
}  // namespace lsos
