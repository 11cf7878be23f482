// A share of time in which something holds, looked at from time to time.
#include "mission/estimate/held_share.h"

#include <gtest/gtest.h>

namespace lsos {
namespace {

constexpr bool stands = false, drives = true;

class Held : public ::testing::Test {
 protected:
  void look(bool surely, bool perhaps) { share.find(surely, perhaps, true, sums); }
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
  share.find(false, false, false, sums);
  expect(10, 15);
}

TEST_F(Held, counts_a_drive_from_where_it_begins) {
  look(true, true);
  pass(100, stands);
  pass(5, drives);
  look(false, false);
  expect(100, 105);
}

}  // namespace
}  // namespace lsos
