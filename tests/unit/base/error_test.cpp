#include "base/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lsos {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(Fault, is_told_with_file_and_line) {
  EXPECT_EQ(to_string(Fault{Severity::error, {"plans/a.kml", 41}, "Speed = -1"}),
            "plans/a.kml:41: Speed = -1");
  EXPECT_EQ(to_string(Fault{Severity::warning, {"plans/a.kml", 41}, "far away"}),
            "plans/a.kml:41: warning: far away");
}

TEST(Fault, leaves_out_the_place_that_it_does_not_have) {
  EXPECT_EQ(to_string(Fault{Severity::error, {"plans/a.kml", 0}, "no such file"}),
            "plans/a.kml: no such file");
  EXPECT_EQ(to_string(Fault{Severity::error, {}, "unknown option"}), "unknown option");
}

TEST(Faults, come_in_order_of_file_and_line) {
  Faults faults;
  faults.error({"b.kml", 1}, "third");
  faults.warning({"a.kml", 10}, "second");
  faults.error({"a.kml", 9}, "first");
  std::vector<std::string> order;
  for (const Fault& fault : faults.sorted()) order.push_back(fault.what);
  EXPECT_THAT(order, ::testing::ElementsAre("first", "second", "third"));
}

TEST(Faults, keep_the_order_of_finding_within_a_line) {
  Faults faults;
  faults.error({"a.kml", 9}, "z");
  faults.error({"a.kml", 9}, "a");
  EXPECT_EQ(faults.sorted().front().what, "z");
}

TEST(Faults, throw_all_errors_at_once_without_the_warnings) {
  Faults faults;
  faults.error({"a.kml", 2}, "two");
  faults.warning({"a.kml", 3}, "odd");
  faults.error({"a.kml", 1}, "one");
  try {
    faults.throw_if_errors();
    FAIL() << "nothing was thrown";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "a.kml:1: one\na.kml:2: two");
    EXPECT_EQ(error.faults().size(), 2u);
  }
}

TEST(Faults, let_warnings_pass) {
  Faults faults;
  EXPECT_FALSE(faults.has_errors());
  faults.warning({"a.kml", 3}, "odd");
  EXPECT_FALSE(faults.has_errors());
  EXPECT_NO_THROW(faults.throw_if_errors());
}

TEST(Faults, take_over_those_of_another_reader) {
  Faults faults;
  faults.add({{Severity::error, {"a.kml", 1}, "one"}, {Severity::warning, {"a.kml", 2}, "two"}});
  EXPECT_TRUE(faults.has_errors());
  EXPECT_EQ(faults.sorted().size(), 2u);
}

TEST(EditDistance, equals_the_textbook_examples) {
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);  // Wagner and Fischer 1974 count the same
  EXPECT_EQ(edit_distance("Saturday", "Sunday"), 3);
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("abc", ""), 3);
  EXPECT_EQ(edit_distance("same", "same"), 0);
}

TEST(DidYouMean, names_the_nearest) {
  const std::vector<std::string> known = {"Duration", "Speed", "ArrivalRadius"};
  EXPECT_EQ(did_you_mean("Sped", known), "; did you mean 'Speed'?");
  EXPECT_EQ(did_you_mean("arrivalradius", known), "; did you mean 'ArrivalRadius'?");
}

TEST(DidYouMean, takes_no_letter_for_another) {
  const std::vector<std::string> ids{"A", "B1"};
  EXPECT_EQ(did_you_mean("C", ids), "");
  EXPECT_EQ(did_you_mean("A2", {{"B1"}}), "");
  EXPECT_EQ(did_you_mean("a", ids), "; did you mean 'A'?");
  EXPECT_EQ(did_you_mean("B", ids), "; did you mean 'B1'?");
}

TEST(DidYouMean, is_silent_when_nothing_is_near) {
  const std::vector<std::string> known = {"Duration", "Speed"};
  EXPECT_EQ(did_you_mean("Colour", known), "");
  EXPECT_EQ(did_you_mean("Speed", {}), "");
}

TEST(Assert, names_the_broken_promise_and_its_place) {
  const int wheels = 3;
  EXPECT_NO_THROW(LSOS_ASSERT(wheels == 3));
  try {
    LSOS_ASSERT(wheels == 4);
    FAIL() << "nothing was thrown";
  } catch (const InternalError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("wheels == 4"), HasSubstr("error_test.cpp:")));
    EXPECT_THAT(error.what(), Not(HasSubstr("error_test.cpp:0")));
  }
}

}  // namespace
}  // namespace lsos
