#include "base/random.h"

#include <gtest/gtest.h>

#include <set>

namespace lsos {
namespace {

// The first outputs of SplitMix64 for seed 1234567, as published with Vigna's splitmix64.c and
// used by implementations in other languages (rosettacode.org, "Pseudo-random numbers/Splitmix64").
TEST(RandomStream, equals_the_published_sequence) {
  RandomStream stream(1234567);
  EXPECT_EQ(stream.next(), 6457827717110365317u);
  EXPECT_EQ(stream.next(), 3203168211198807973u);
  EXPECT_EQ(stream.next(), 9817491932198370423u);
  EXPECT_EQ(stream.next(), 4593380528125082431u);
  EXPECT_EQ(stream.next(), 16408922859458223821u);
}

TEST(RandomStream, is_uniform_between_its_limits) {
  RandomStream stream(7, "SEV", 3, "test");
  constexpr int count = 100'000;
  double sum = 0, sum_of_squares = 0;
  for (int i = 0; i < count; ++i) {
    const double x = stream.uniform(-2, 4);
    ASSERT_GE(x, -2);
    ASSERT_LT(x, 4);
    sum += x;
    sum_of_squares += x * x;
  }
  const double mean = sum / count;
  // Standard errors: sqrt(3 / 1e5) = 0.0055 of the mean; the variance of [-2, 4) is 36/12.
  EXPECT_NEAR(mean, 1, 4 * 0.0055);
  EXPECT_NEAR(sum_of_squares / count - mean * mean, 3, 0.05);
}

TEST(RandomStream, goes_on_after_a_restore_where_it_was) {
  RandomStream stream(7, "SEV", 3, "test");
  stream.next();
  Archive writer = Archive::writer();
  writer(stream);
  Archive reader = Archive::reader(writer.bytes());
  RandomStream restored;
  reader(restored);
  EXPECT_EQ(restored.next(), stream.next());
}

TEST(RandomStream, differs_in_each_part_of_its_key) {
  const std::set<std::uint64_t> first = {
      RandomStream(1, "SEV", 1, "detail").next(),  RandomStream(2, "SEV", 1, "detail").next(),
      RandomStream(1, "SEV2", 1, "detail").next(), RandomStream(1, "SEV", 2, "detail").next(),
      RandomStream(1, "SEV", -1, "detail").next(), RandomStream(1, "SEV", 1, "rocks").next(),
      RandomStream(1, "", 1, "detail").next(),     RandomStream(1, "SEV", 1, "").next(),
  };
  EXPECT_EQ(first.size(), 8u);
}

TEST(MixKey, tells_apart_where_one_word_ends_and_the_next_begins) {
  const auto key = [](std::string_view a, std::string_view b) { return mix_key(mix_key(0, a), b); };
  EXPECT_NE(key("ab", "c"), key("a", "bc"));
  EXPECT_NE(key("", "a"), key("a", ""));
  EXPECT_NE(mix_key(1, 2), mix_key(2, 1));
}

TEST(MixKey, changes_about_half_of_the_bits_for_one_bit) {
  for (int bit = 0; bit < 64; ++bit) {
    const int changed = __builtin_popcountll(mix_key(42, 0) ^ mix_key(42, 1ull << bit));
    EXPECT_GT(changed, 14) << "bit " << bit;  // 32 +- 4 expected; 14 is 4.5 sigma below
    EXPECT_LT(changed, 50) << "bit " << bit;
  }
}

}  // namespace
}  // namespace lsos
