// How sure the sums of days are.
#include "mission/estimate/day_ranges.h"

#include <gtest/gtest.h>

namespace lsos {
namespace {

constexpr double day_s = 86400;

EventEstimate event(double start_s, double end_s) {
  EventEstimate event;
  event.rover_id = "A";
  event.start_s = start_s;
  event.end_s = end_s;
  event.energy_used_j = 1e6;
  event.energy_range_j = Expected{0.8e6, 1.4e6};
  event.solar_j = 2e6;
  event.charge_end = event.charge_min = 0.5;
  event.charge_end_range = event.charge_min_range = Expected{0.4, 0.55};
  return event;
}

DayEstimate day(int number) {
  DayEstimate day;
  day.rover_id = "A";
  day.day = number;
  day.energy_used_j = 3e6;
  day.solar_j = 2e6;
  day.charge_min = 0.45;
  day.charge_end = 0.7;
  return day;
}

void expect(const std::optional<Expected>& range, double low, double high) {
  ASSERT_TRUE(range);
  EXPECT_NEAR(range->low, low, 1e-9 * std::abs(high));
  EXPECT_NEAR(range->high, high, 1e-9 * std::abs(high));
}

TEST(DayRanges, hold_what_the_events_of_the_day_may_take_less_or_more) {
  std::vector<DayEstimate> days{day(1), day(2)};
  // The second event lies half on each day.
  std::vector<EventEstimate> events{event(0, 1000), event(day_s - 500, day_s + 500)};
  add_day_ranges(days, events);
  expect(days[0].energy_range_j, 3e6 - 0.3e6, 3e6 + 0.6e6);
  expect(days[1].energy_range_j, 3e6 - 0.1e6, 3e6 + 0.2e6);
  expect(days[0].charge_end_range, 0.6, 0.75);
  expect(days[0].charge_min_range, 0.35, 0.5);
}

TEST(DayRanges, of_charge_are_those_of_the_last_event_that_has_ended) {
  std::vector<DayEstimate> days{day(1), day(2)};
  std::vector<EventEstimate> events{event(0, 1000), event(2000, 3000)};
  events[1].charge_end_range.reset();
  add_day_ranges(days, events);
  EXPECT_FALSE(days[0].charge_end_range);
  EXPECT_FALSE(days[1].charge_end_range) << "no event has changed it since";
  EXPECT_FALSE(days[1].energy_range_j);
  events[1].charge_end_range = Expected{0.5, 0.6};
  add_day_ranges(days, events);
  expect(days[1].charge_end_range, 0.7, 0.8);
  days[1].charge_end = 1;
  add_day_ranges(days, events);
  EXPECT_FALSE(days[1].charge_end_range) << "a full battery is sure";
}

TEST(DayRanges, of_charge_grow_in_the_course_of_an_event) {
  std::vector<DayEstimate> days{day(1), day(2), day(3)};
  days[0].charge_min = days[0].charge_end = 0.8;
  days[1].charge_min = 0.8;
  days[2].charge_min = days[2].charge_end = 0.5;
  const std::vector<EventEstimate> events{event(0.5 * day_s, 2.5 * day_s)};
  add_day_ranges(days, events);
  // A quarter of the event is over.
  expect(days[0].charge_end_range, 0.8 - 0.025, 0.8 + 0.0125);
  expect(days[0].charge_min_range, 0.8 - 0.025, 0.8 + 0.0125);
  expect(days[1].charge_min_range, 0.8 - 0.025, 0.8 + 0.0125);
  expect(days[1].charge_end_range, 0.7 - 0.075, 0.7 + 0.0375);
  expect(days[2].charge_end_range, 0.4, 0.55);
  expect(days[2].charge_min_range, 0.4, 0.55);
}

TEST(DayRanges, of_a_day_without_events_are_as_those_before) {
  std::vector<DayEstimate> days{day(1), day(2)};
  days[1].charge_min = days[1].charge_end = 0;
  add_day_ranges(days, {event(0, 1000)});
  expect(days[1].charge_end_range, 0, 0.05);
  expect(days[1].charge_min_range, 0, 0.05);
}

TEST(DayRanges, are_none_where_they_are_narrow) {
  std::vector<DayEstimate> days{day(1)};
  days[0].energy_used_j = 1e9;
  EventEstimate narrow = event(0, 1000);
  narrow.charge_end_range = narrow.charge_min_range = Expected{0.498, 0.502};
  add_day_ranges(days, {narrow});
  EXPECT_FALSE(days[0].energy_range_j || days[0].charge_end_range || days[0].charge_min_range);
  days[0].energy_used_j = 3e6;
  add_day_ranges(days, {narrow});
  EXPECT_TRUE(days[0].energy_range_j && days[0].charge_end_range && days[0].charge_min_range)
      << "where the energy has one, so has the charge";
}

TEST(DayRanges, are_none_of_other_rovers) {
  std::vector<DayEstimate> days{day(1)};
  days[0].rover_id = "B";
  add_day_ranges(days, {event(0, 1000)});
  EXPECT_FALSE(days[0].energy_range_j || days[0].charge_end_range || days[0].charge_min_range);
}

}  // namespace
}  // namespace lsos
