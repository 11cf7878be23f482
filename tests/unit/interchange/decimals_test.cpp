#include "interchange/decimals.h"

#include <gmock/gmock.h>

#include "interchange/sheets.h"
#include "unit/plan/plan_fixture.h"

namespace lsos::test {
namespace {

using ::testing::HasSubstr;

Decimals shown(const std::string& sheet) {
  const Table table = read_csv(sheet, "s.csv").at(0);
  Faults faults;
  return decimals_of(table, Columns(table, declarations(), faults), declarations());
}

TEST(Decimals, are_told_by_numbers_that_leave_no_doubt) {
  EXPECT_EQ(shown("Type,Speed\nRoute,1.200\n"), Decimals::points);
  EXPECT_EQ(shown("Type;Speed\nRoute;5,5\nRoute;1.200\n"), Decimals::commas);
  EXPECT_EQ(shown("Type;Speed\nRoute;0,125 m/s\n"), Decimals::commas);
  EXPECT_EQ(shown("Type;Speed\nRoute;5.5\nRoute;1,200\n"), Decimals::points);
  EXPECT_EQ(shown("Type;Speed\nRoute;1.200\nRoute;7\n"), Decimals::either);
  EXPECT_EQ(shown("Type;Speed\nRoute;5,5\nRoute;5.5\n"), Decimals::either);
}

TEST(Decimals, become_points_and_thousands_close_up) {
  const auto read = [](const char* text, Decimals decimals) {
    const Parsed<std::string> number = with_decimal_point(text, decimals);
    return number ? *number.value : number.why;
  };
  EXPECT_EQ(read("1.200 s", Decimals::commas), "1200 s");
  EXPECT_EQ(read("1.200 s", Decimals::points), "1.200 s");
  EXPECT_THAT(read("1.200 s", Decimals::either), HasSubstr("may be 1200 or 1.2, since"));
  EXPECT_EQ(read("1,200", Decimals::commas), "1.200");
  EXPECT_THAT(read("1,200", Decimals::either), HasSubstr("may be 1200 or 1.2, since"));
  EXPECT_THAT(read("1,200", Decimals::points), HasSubstr("may be 1200 or 1.2, since"));
  EXPECT_EQ(read("-1.200,5 km", Decimals::either), "-1200.5 km");
  EXPECT_EQ(read("1,200.5", Decimals::either), "1200.5");
  EXPECT_EQ(read("1.200.000", Decimals::either), "1200000");
  EXPECT_EQ(read("0.125", Decimals::either), "0.125");
  EXPECT_EQ(read("5,5", Decimals::points), "5.5");
  for (const char* text : {"1:30", "2 h", "", "1.2.3", "PT1.5H", "12,3,4", "soon"}) {
    EXPECT_EQ(read(text, Decimals::either), text);
  }
}

}  // namespace
}  // namespace lsos::test
