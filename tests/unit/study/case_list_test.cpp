#include "study/case_list.h"

#include <gtest/gtest.h>

#include <random>

#include "base/error.h"

namespace lsos {
namespace {

using Numbers = std::vector<std::int64_t>;

TEST(CaseList, joins_what_is_without_a_gap) {
  EXPECT_EQ(case_list({1, 2, 3, 5, 7, 8}), "1-3,5,7-8");
  EXPECT_EQ(case_list({4}), "4");
}

TEST(CaseList, is_read_back) {
  std::mt19937 random(1);
  for (int i = 0; i < 100; ++i) {
    Numbers numbers;
    for (std::int64_t number = 1; number <= 60; ++number) {
      if (random() % 3 > 0) numbers.push_back(number);
    }
    EXPECT_EQ(listed_cases(case_list(numbers), 60), numbers);
  }
}

TEST(CaseList, of_no_text_is_that_of_all_cases) {
  EXPECT_EQ(listed_cases("", 3), (Numbers{1, 2, 3}));
  EXPECT_EQ(listed_cases("3,1-2,2", 3), (Numbers{1, 2, 3}));
}

TEST(CaseList, refuses_what_is_beyond_the_study) {
  for (const char* text : {"0", "4", "2-1", "1-", "a", "1,,2", "-1", "1-2-3", ","}) {
    EXPECT_THROW(listed_cases(text, 3), InputError) << text;
  }
}

TEST(CaseChunks, have_so_many_cases_each) {
  EXPECT_EQ(case_chunks({1, 2, 3, 5, 6}, 2), (std::vector<std::string>{"1-2", "3,5", "6"}));
  EXPECT_EQ(case_chunks({1, 2}, 20), (std::vector<std::string>{"1-2"}));
}

}  // namespace
}  // namespace lsos
