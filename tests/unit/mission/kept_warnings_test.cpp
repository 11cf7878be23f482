#include "mission/kept_warnings.h"

#include <gmock/gmock.h>

namespace lsos {
namespace {

using ::testing::StartsWith;

TEST(KeptWarnings, are_all_where_there_are_few) {
  KeptWarnings warnings;
  warnings.add("one");
  warnings.add_last("two");
  EXPECT_THAT(warnings.texts(), ::testing::ElementsAre("one", "two"));
  EXPECT_EQ(warnings.rest(), "");
}

TEST(KeptWarnings, are_the_first_and_those_of_the_end) {
  KeptWarnings warnings;
  for (int k = 0; k < 5000; ++k) warnings.add(std::to_string(k));
  warnings.add_last("the end");
  ASSERT_EQ(warnings.texts().size(), kept_warnings_max + 1);
  EXPECT_EQ(warnings.texts()[kept_warnings_max - 1], "999");
  EXPECT_EQ(warnings.texts().back(), "the end");
  EXPECT_THAT(warnings.rest(),
              StartsWith("4000 more warnings are not listed, after the first 1000"));

  Archive writer = Archive::writer();
  warnings.archive(writer);
  KeptWarnings restored;
  Archive reader = Archive::reader(writer.bytes());
  restored.archive(reader);
  EXPECT_EQ(restored.texts(), warnings.texts());
  EXPECT_EQ(restored.rest(), warnings.rest());
}

}  // namespace
}  // namespace lsos
