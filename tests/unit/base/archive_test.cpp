#include "base/archive.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace lsos {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

enum class Gear { low, high };
constexpr Gear last_value(Gear) { return Gear::high; }

struct Wheel {
  double slip = 0;
  std::optional<Vec3> anchor_m;

  void archive(Archive& a) { LSOS_ARCHIVE(a, slip, anchor_m); }
  bool operator==(const Wheel&) const = default;
};

// One member of every type that Archive supports.
struct State {
  bool parked = false;
  Gear gear = Gear::low;
  std::int64_t fid = 0;
  SimTime wake{};
  std::string phase;
  Vec2 p_m = Vec2::Zero();
  Quat attitude = Quat::Identity();
  std::vector<Wheel> wheels;
  std::map<std::string, std::vector<double>> totals;

  void archive(Archive& a) {
    a.tag("state");
    LSOS_ARCHIVE(a, parked, gear, fid, wake, phase, p_m, attitude, wheels, totals);
  }
};

State example() {
  State state;
  state.parked = true;
  state.gear = Gear::high;
  state.fid = -5'000'000'000;
  state.wake = SimTime{123'456'789'012};
  state.phase = std::string("drive\0on", 8);
  state.p_m = {0.1, -1e300};
  state.attitude = {0.5, -0.5, 0.5, 0.5};
  state.wheels = {{0.25, Vec3{1, 2, 3}}, {-0.0, std::nullopt}};
  state.totals = {{"b", {1.5}}, {"a", {}}};
  return state;
}

std::string written(State state) {
  Archive writer = Archive::writer();
  writer(state);
  return writer.bytes();
}

template <class T>
T read(const std::string& bytes) {
  Archive reader = Archive::reader(bytes);
  T value{};
  reader(value);
  return value;
}

TEST(Archive, reads_back_what_it_wrote) {
  const State before = example();
  const State after = read<State>(written(before));
  EXPECT_EQ(after.parked, before.parked);
  EXPECT_EQ(after.gear, before.gear);
  EXPECT_EQ(after.fid, before.fid);
  EXPECT_EQ(after.wake, before.wake);
  EXPECT_EQ(after.phase, before.phase);
  EXPECT_EQ(after.p_m, before.p_m);
  EXPECT_EQ(after.attitude.coeffs(), before.attitude.coeffs());
  EXPECT_EQ(after.wheels, before.wheels);
  EXPECT_EQ(after.totals, before.totals);
}

TEST(Archive, overwrites_all_that_was_there) {
  State state = example();
  state.wheels.resize(9, {7, Vec3{7, 7, 7}});
  state.totals["old"] = {1};
  Archive reader = Archive::reader(written(State{}));
  reader(state);
  EXPECT_EQ(written(state), written(State{}));
}

TEST(Archive, keeps_every_bit_of_a_double) {
  Archive writer = Archive::writer();
  double nan = not_modelled, negative_zero = -0.0, least = 5e-324;
  writer(nan)(negative_zero)(least);
  Archive reader = Archive::reader(writer.bytes());
  double a = 0, b = 1, c = 0;
  reader(a)(b)(c);
  EXPECT_TRUE(std::isnan(a));
  EXPECT_TRUE(b == 0 && std::signbit(b));
  EXPECT_EQ(c, least);
}

TEST(Archive, knows_when_it_has_come_to_the_end) {
  Archive reader = Archive::reader(written(example()));
  State state;
  EXPECT_FALSE(reader.is_exhausted());
  reader(state);
  EXPECT_TRUE(reader.is_exhausted());
  EXPECT_TRUE(reader.is_reading());
  EXPECT_FALSE(Archive::writer().is_reading());
}

TEST(Archive, refuses_every_truncation) {
  const std::string bytes = written(example());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_THROW(read<State>(bytes.substr(0, size)), Archive::Mismatch) << size << " bytes";
  }
}

TEST(Archive, names_both_words_when_another_part_stands_there) {
  Archive writer = Archive::writer();
  writer.tag("battery");
  Archive reader = Archive::reader(writer.bytes());
  try {
    reader.tag("wheels");
    FAIL() << "nothing was thrown";
  } catch (const Archive::Mismatch& mismatch) {
    EXPECT_THAT(mismatch.what(), AllOf(HasSubstr("'battery'"), HasSubstr("'wheels'")));
  }
}

TEST(Archive, says_which_field_does_not_fit) {
  std::string bytes = written(example());
  bytes.resize(bytes.find("drive") + 3);
  try {
    read<State>(bytes);
    FAIL() << "nothing was thrown";
  } catch (const Archive::Mismatch& mismatch) {
    EXPECT_STREQ(mismatch.what(), "phase: saved state ends too early");
  }
  bytes = written(example());
  // The second wheel's optional anchor follows its slip, the last -0.0.
  bytes.replace(bytes.find(std::string("\0\0\0\0\0\0\0\x80", 8)) + 8, 1, "\2");
  try {
    read<State>(bytes);
    FAIL() << "nothing was thrown";
  } catch (const Archive::Mismatch& mismatch) {
    EXPECT_THAT(mismatch.what(), HasSubstr("wheels[1].anchor_m: "));
  }
}

TEST(Archive, names_the_field_in_which_two_states_differ) {
  State one = example(), other = example();
  other.wheels[0].anchor_m->y() = 2.5;
  const auto difference = [&] {
    return first_difference(written(one), written(other), [&](Archive& a) { a(one); });
  };
  EXPECT_EQ(difference(), "wheels[0].anchor_m");
  other.totals["a"] = {1};
  EXPECT_EQ(difference(), "wheels[0].anchor_m");
  one.wheels = other.wheels;
  EXPECT_EQ(difference(), "totals[0]");
  one.parked = false;
  EXPECT_EQ(difference(), "parked");
}

// A damaged count must be refused before memory is requested: these would take exabytes.
TEST(Archive, refuses_absurd_sizes_without_allocating) {
  for (const std::uint64_t absurd : {UINT64_MAX, UINT64_C(1) << 60}) {
    Archive writer = Archive::writer();
    std::uint64_t size = absurd;
    writer(size);
    EXPECT_THROW(read<std::string>(writer.bytes()), Archive::Mismatch);
    EXPECT_THROW(read<std::vector<double>>(writer.bytes()), Archive::Mismatch);
    EXPECT_THROW((read<std::map<std::string, double>>(writer.bytes())), Archive::Mismatch);
  }
}

std::string refusal(const std::string& bytes, auto value) {
  try {
    Archive reader = Archive::reader(bytes);
    reader(value);
    return "";
  } catch (const Archive::Mismatch& mismatch) {
    return mismatch.what();
  }
}

TEST(Archive, refuses_a_choice_that_an_enumeration_has_not) {
  Archive writer = Archive::writer();
  int gear = 2;
  writer(gear);
  EXPECT_THAT(refusal(writer.bytes(), Gear::low), HasSubstr("an unknown choice"));
  Archive negative = Archive::writer();
  gear = -1;
  negative(gear);
  EXPECT_THAT(refusal(negative.bytes(), Gear::low), HasSubstr("an unknown choice"));
}

TEST(Archive, refuses_a_time_with_which_no_sum_can_be_made) {
  Archive writer = Archive::writer();
  SimTime time = SimTime::max();
  writer(time);
  EXPECT_THAT(refusal(writer.bytes(), SimTime{}), HasSubstr("a time that no mission has"));
}

struct Choice {
  std::vector<double> values;
  std::size_t chosen = 0;

  void archive(Archive& a) { LSOS_ARCHIVE(a, values, chosen); }
  bool is_sound() const { return chosen < values.size(); }
};

TEST(Archive, asks_what_it_has_read_whether_it_is_sound) {
  Archive writer = Archive::writer();
  std::vector<Choice> choices{{{1, 2}, 1}, {{1, 2}, 2}};
  writer(choices);
  choices.clear();
  EXPECT_THAT(refusal(writer.bytes(), choices),
              AllOf(HasSubstr("[1]"), HasSubstr("values that no mission has")));
}

}  // namespace
}  // namespace lsos
