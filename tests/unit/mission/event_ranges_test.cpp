// How what drives may take less or more is carried on through the events of an estimate.
#include "mission/estimate/event_ranges.h"

#include <gtest/gtest.h>

namespace lsos {
namespace {

class EventRanges : public ::testing::Test {
 protected:
  // Adds an event that may end that much earlier or later, and use that much less or more.
  PlanEvent& add(const char* rover_id, std::int64_t sequence, double start_s, double end_s,
                 const DriveDoubt& drives = {}) {
    PlanEvent& event = plan[events.size()];
    event.rover_id = rover_id;
    event.sequence = sequence;
    EventEstimate& estimate = events.emplace_back();
    estimate.rover_id = rover_id;
    estimate.sequence = sequence;
    estimate.start_s = start_s;
    estimate.end_s = end_s;
    estimate.energy_used_j = 1e6;
    estimate.charge_end = estimate.charge_min = 0.5;
    doubts.push_back(drives);
    return event;
  }
  void find() {
    std::vector<DoubtedEvent> all;
    for (std::size_t k = 0; k < events.size(); ++k) {
      DoubtedEvent& doubt = all.emplace_back();
      doubt.estimate = &events[k];
      doubt.planned = &plan[k];
      doubt.drives = doubts[k];
      doubt.capacity_j = 1e7;
      doubt.sun_less_j = sun_less_j[k];
      doubt.sun_more_j = sun_more_j[k];
      doubt.loads_more_j = loads_more_j[k];
      doubt.was_full = was_full[k];
      doubt.charging_w = charging_w[k];
    }
    add_ranges(all, start);
  }
  void expect_end(std::size_t k, double low_s, double high_s) {
    ASSERT_TRUE(events[k].end_range_s) << k;
    EXPECT_DOUBLE_EQ(events[k].end_range_s->low, low_s) << k;
    EXPECT_DOUBLE_EQ(events[k].end_range_s->high, high_s) << k;
  }

  const Instant start = *parse_utc("2026-07-01T06:00:00Z").value;
  std::array<PlanEvent, 8> plan;
  std::vector<EventEstimate> events;
  std::vector<DriveDoubt> doubts;
  std::array<double, 8> sun_less_j{}, sun_more_j{};
  std::array<double, 8> loads_more_j{}, charging_w{};
  std::array<bool, 8> was_full{};
};

// A drive that is expected to use all of its energy by itself.
constexpr DriveDoubt drive{20, 40, 1e5, 2e5, 1e6};

TEST_F(EventRanges, are_none_where_nothing_drives) {
  add("A", 1, 0, 100);
  find();
  EXPECT_FALSE(events[0].end_range_s || events[0].energy_range_j || events[0].charge_end_range);
}

TEST_F(EventRanges, of_charge_hold_what_a_sun_along_the_horizon_may_give) {
  for (int k = 0; k < 3; ++k) add("A", k, 100 * k, 100 * (k + 1));
  sun_less_j[0] = 1e5, sun_more_j[0] = 2e6;
  sun_more_j[1] = 1e6;
  sun_more_j[2] = 5e5, was_full[2] = true;
  find();
  EXPECT_DOUBLE_EQ(events[0].charge_end_range->low, 0.49);
  EXPECT_DOUBLE_EQ(events[0].charge_end_range->high, 0.7);
  EXPECT_DOUBLE_EQ(events[1].charge_end_range->high, 0.8);
  EXPECT_DOUBLE_EQ(events[2].charge_end_range->low, 0.5);
  EXPECT_DOUBLE_EQ(events[2].charge_end_range->high, 0.55);
  EXPECT_FALSE(events[0].energy_range_j) << "what is used is sure";
}

// A low Sun switches heaters off, or does not.
TEST_F(EventRanges, of_energy_hold_what_loads_may_use_in_the_dark) {
  add("A", 1, 0, 100);
  loads_more_j[0] = sun_less_j[0] = 3e5;
  find();
  ASSERT_TRUE(events[0].energy_range_j && events[0].charge_end_range);
  EXPECT_DOUBLE_EQ(events[0].energy_range_j->low, 1e6);
  EXPECT_DOUBLE_EQ(events[0].energy_range_j->high, 1.3e6);
  EXPECT_DOUBLE_EQ(events[0].charge_end_range->low, 0.47);
}

TEST_F(EventRanges, of_a_wait_for_a_charge_are_those_of_what_there_was_before) {
  for (int k = 0; k < 3; ++k) add("A", k, 1000 * k, 1000 * (k + 1));
  sun_less_j[0] = 1e5, sun_more_j[0] = 2e5;
  charging_w[1] = 1000;
  find();
  ASSERT_TRUE(events[1].energy_range_j);
  expect_end(1, 1800, 2100);
  EXPECT_DOUBLE_EQ(events[1].energy_range_j->low, 0.8e6) << "1 kW of loads for 200 s less";
  EXPECT_DOUBLE_EQ(events[1].energy_range_j->high, 1.1e6);
  EXPECT_FALSE(events[1].charge_end_range) << "it ends at its charge";
  expect_end(2, 2800, 3100);
  EXPECT_FALSE(events[2].charge_end_range);
}

TEST_F(EventRanges, never_end_before_they_begin) {
  add("A", 1, 0, 1000, drive);
  add("A", 2, 1000, 1005);
  find();
  ASSERT_TRUE(events[1].start_range_s && events[1].end_range_s);
  EXPECT_DOUBLE_EQ(events[1].start_range_s->low, 980);
  EXPECT_DOUBLE_EQ(events[1].end_range_s->low, 985);
}

TEST_F(EventRanges, add_up_from_event_to_event) {
  add("A", 1, 0, 1000, drive);
  add("A", 2, 1000, 2000);
  add("A", 3, 2000, 3000, drive);
  find();
  expect_end(0, 980, 1040);
  expect_end(1, 1980, 2040);
  expect_end(2, 2960, 3080);
  EXPECT_DOUBLE_EQ(events[0].energy_range_j->low, 0.9e6);
  EXPECT_DOUBLE_EQ(events[0].energy_range_j->high, 1.2e6);
  EXPECT_FALSE(events[1].energy_range_j);
  EXPECT_DOUBLE_EQ(events[1].charge_end_range->low, 0.5 - 0.02);
  EXPECT_DOUBLE_EQ(events[1].charge_end_range->high, 0.5 + 0.01);
  EXPECT_DOUBLE_EQ(events[2].charge_end_range->low, 0.5 - 0.04);
}

TEST_F(EventRanges, of_charge_are_there_where_the_energy_has_one) {
  add("A", 1, 0, 1000, {0, 0, 1e4, 2e4, 1e6});
  find();
  ASSERT_TRUE(events[0].energy_range_j && events[0].charge_end_range);
  EXPECT_DOUBLE_EQ(events[0].charge_end_range->low, 0.498);
  EXPECT_DOUBLE_EQ(events[0].charge_end_range->high, 0.501);
}

TEST_F(EventRanges, of_energy_count_what_else_is_used_while_it_takes_longer) {
  add("A", 1, 0, 1000, {0, 100, 0, 0, 0.4e6});
  find();
  EXPECT_DOUBLE_EQ(events[0].energy_range_j->high, 1e6 + 600 * 100);
}

TEST_F(EventRanges, begin_anew_at_a_time_of_day_that_is_waited_for) {
  add("A", 1, 0, 1000, drive);
  add("A", 2, 1030, 2000).start_time = start + from_seconds(1030);
  add("A", 3, 2000, 3000, drive);
  add("A", 4, 3000, 4000).params["until"] = start + from_seconds(4000);
  find();
  // The drive may be ten seconds late for it.
  ASSERT_TRUE(events[1].start_range_s);
  EXPECT_DOUBLE_EQ(events[1].start_range_s->low, 1030);
  EXPECT_DOUBLE_EQ(events[1].start_range_s->high, 1040);
  expect_end(1, 2000, 2010);
  expect_end(2, 2980, 3050);
  EXPECT_FALSE(events[3].end_range_s);
}

TEST_F(EventRanges, of_an_event_that_a_clock_ends_may_end_when_it_begins_late) {
  add("A", 1, 0, 1000, drive);
  add("A", 2, 1000, 1010).params["until"] = start + from_seconds(1010);
  add("A", 3, 1010, 1100);
  find();
  expect_end(1, 1010, 1040);
  ASSERT_TRUE(events[2].start_range_s);
  EXPECT_DOUBLE_EQ(events[2].start_range_s->low, 1010);
  EXPECT_DOUBLE_EQ(events[2].start_range_s->high, 1040);
}

TEST_F(EventRanges, are_told_of_a_start_where_the_end_may_come_before_it) {
  add("A", 1, 0, 1000, {5, 4, 0, 0, 1e6});  // its end is told as sure
  add("A", 2, 1000, 1001, {0, 10, 0, 0, 0});
  find();
  EXPECT_FALSE(events[0].end_range_s);
  expect_end(1, 996, 1015);
  ASSERT_TRUE(events[1].start_range_s);
  EXPECT_DOUBLE_EQ(events[1].start_range_s->low, 995);
}

TEST_F(EventRanges, begin_anew_where_something_else_is_waited_for) {
  add("A", 1, 0, 1000, drive);
  add("A", 2, 1500, 2000);
  find();
  EXPECT_FALSE(events[1].end_range_s);
}

TEST_F(EventRanges, are_those_of_the_rover_that_is_waited_for) {
  add("A", 1, 0, 1000, drive);
  add("B", 1, 0, 10);
  add("B", 2, 1000, 2000).start_after = {{"A", 1}};
  find();
  expect_end(2, 1980, 2040);
}

TEST_F(EventRanges, of_charge_begin_anew_where_the_battery_is_full) {
  add("A", 1, 0, 1000, drive);
  add("A", 2, 1000, 2000);
  events[1].charge_end = 1;
  add("A", 3, 2000, 3000);
  find();
  EXPECT_TRUE(events[0].charge_end_range);
  EXPECT_FALSE(events[1].charge_end_range);
  EXPECT_FALSE(events[2].charge_end_range);
}

TEST(DriveSlack, grows_with_slip) {
  DriveSlackSum level, steep;
  level.add(100, 1000, 0);
  steep.add(100, 1000, 0.6);
  EXPECT_DOUBLE_EQ(level.slack().time_high, 1 + drive_time_error);
  EXPECT_DOUBLE_EQ(level.slack().energy_low, 1 - drive_energy_error);
  // Slip may be 0.4 to 0.8: the wheels roll 1.67 to 5 m a metre of ground, in place of 2.5 m.
  EXPECT_DOUBLE_EQ(steep.slack().time_high, (1 + drive_time_error) * 2);
  EXPECT_DOUBLE_EQ(steep.slack().energy_low, (1 - drive_energy_error) * 2 / 3);
}

TEST(DriveSlack, of_a_line_is_that_of_its_slopes) {
  DriveCost cost;
  cost.soils = {{-1, 0.5, {{0, 1, 1}, {0, 1, 1}, {0, 1, 1}, {0.6, 1, 1}, {0.6, 1, 1}}, {}}};
  EXPECT_NEAR(line_slack(cost, {{0, 0, 0}, {1, 0, 0}, {5, 0, 0}}).time_high, 1 + drive_time_error,
              1e-12);
  EXPECT_GT(line_slack(cost, {{0, 0, 0}, {5, 0, 2}}).time_high, 1.3);
}

}  // namespace
}  // namespace lsos
