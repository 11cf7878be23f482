// A share of time in which something holds, looked at from time to time.
#include "mission/estimate/held_share.h"

#include <gtest/gtest.h>

namespace lsos {
namespace {

constexpr bool stands = false, drives = true;

class Held : public ::testing::Test {
 protected:
  void look(bool surely, bool perhaps, double ahead_s = 0) {
    share.find(surely, perhaps, true, ahead_s, sums);
  }
  void pass(double passed_s, bool is_driving) { share.pass(passed_s, is_driving, sums); }
  void expect(double surely_s, double perhaps_s) {
    EXPECT_DOUBLE_EQ(sums.surely_s, surely_s);
    EXPECT_DOUBLE_EQ(sums.perhaps_s, perhaps_s);
  }
  HeldShare share;
  HeldSums sums;
};

TEST_F(Held, holds_from_one_look_to_the_next_where_nothing_drives) {
  look(true, true);
  pass(10, stands);
  look(false, true);
  pass(20, stands);
  look(false, false);
  pass(40, stands);
  expect(10, 30);
}

TEST_F(Held, may_change_anywhere_between_two_looks_of_a_drive) {
  look(true, true);
  pass(10, drives);
  pass(5, drives);
  look(false, false);
  expect(0, 15);
  pass(20, drives);
  look(true, true);
  expect(0, 35);
  pass(40, drives);
  look(true, true);
  expect(40, 75);
}

TEST_F(Held, is_sure_of_what_came_before_the_last_look) {
  look(true, true);
  pass(10, drives);
  look(true, true);
  pass(5, drives);
  // What is found without a new look has changed since the last one.
  share.find(false, false, false, 0, sums);
  expect(10, 15);
}

TEST_F(Held, counts_a_drive_from_where_it_begins) {
  look(true, true);
  pass(100, stands);
  pass(5, drives);
  look(false, false);
  expect(100, 105);
}

TEST_F(Held, changes_between_the_moments_that_looks_ahead_see) {
  look(true, true, 5);
  pass(10, drives);
  look(false, false, 5);
  expect(5, 10);  // until 5 s, and perhaps until 15 s
  pass(10, drives);
  expect(5, 15);
  look(true, true, 2);
  expect(5, 20);  // perhaps from 15 s on, surely from 22 s on
  pass(4, drives);
  expect(7, 24);
  look(true, true);
  pass(10, stands);
  expect(17, 34);
}

TEST_F(Held, is_not_known_between_the_last_look_and_the_end_of_the_event) {
  look(true, true, 5);
  pass(9, drives);
  share.end_event(sums);
  expect(5, 9);
  HeldSums next;
  share.pass(1, drives, next);
  share.find(false, false, true, 0, next);
  EXPECT_DOUBLE_EQ(next.surely_s, 0);
  EXPECT_DOUBLE_EQ(next.perhaps_s, 1);
  share.pass(3, drives, next);
  share.end_event(next);
  EXPECT_DOUBLE_EQ(next.perhaps_s, 4);
  expect(5, 9);
}

TEST_F(Held, is_known_to_the_end_of_an_event_in_which_nothing_moves) {
  look(true, true);
  pass(100, stands);
  share.end_event(sums);
  expect(100, 100);
}

}  // namespace
}  // namespace lsos
