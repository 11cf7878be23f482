// Limits that messages on fields tell.
#include <gmock/gmock.h>

#include "plan_fixture.h"

namespace lsos {
namespace {

// What the message on a Route's Speed says is allowed; "" where the value is.
std::string told_limits(std::optional<double> min_si, std::optional<double> max_si,
                        const char* unit, const std::string& text) {
  Declarations known = test::declarations();
  FieldDeclaration& speed = known.events["Route"].fields[0];
  speed.min_si = min_si;
  speed.max_si = max_si;
  speed.unit = find_unit(unit);
  const std::string plan =
      test::document(test::mission() + test::rover() +
                     test::event("Route", "a", "A", 1, {{"Speed", text}}, test::line()));
  Faults faults;
  read_plan(test::write_file(plan), known, faults);
  const std::string told = test::faults_text(faults);
  const std::size_t at = told.find("must be ");
  return at == std::string::npos ? told : told.substr(at, told.find('\n', at) - at);
}

TEST(ToldLimits, are_in_the_unit_that_was_written) {
  EXPECT_EQ(told_limits({}, 20, "m/s", "72.1 km/h"), "must be at most 72 km/h");
  EXPECT_EQ(told_limits(0, 1, "1", "-1"), "must be from 0 to 1");
}

// 0.036 km/h is less than 0.01 m/s by the last bit of its conversion.
TEST(ToldLimits, are_allowed_in_any_unit) {
  EXPECT_EQ(told_limits(0.01, 20, "m/s", "0.035 km/h"), "must be from 0.036 km/h to 72 km/h");
  EXPECT_EQ(told_limits(0.01, 20, "m/s", "0.036 km/h"), "");
  EXPECT_EQ(told_limits(0.01, 20, "m/s", "0.01 m/s"), "");
  EXPECT_EQ(told_limits(0.01, 20, "m/s", "0.03599999 km/h"), "must be from 0.036 km/h to 72 km/h");
}

TEST(ToldLimits, are_in_the_fields_unit_where_they_have_many_digits_in_the_other) {
  EXPECT_EQ(told_limits(0.1234567, 20, "m/s", "0.1 km/h"), "must be from 0.1234567 m/s to 20 m/s");
}

TEST(ToldLimits, are_allowed_where_they_are_rounded) {
  EXPECT_EQ(told_limits(1.0 / 3, 2.0 / 3, "1", "0.7"), "must be from 0.3333333334 to 0.6666666666");
  EXPECT_EQ(told_limits(1.0 / 3, 2.0 / 3, "1", "0.3333333334"), "");
  EXPECT_EQ(told_limits(1.0 / 3, 2.0 / 3, "1", "0.6666666666"), "");
}

}  // namespace
}  // namespace lsos
