// The moments of a run that its film shows.
#include "picture/film_times.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"

namespace lsos {
namespace {

SimTime at(double time_s) { return from_seconds(time_s); }

TEST(FilmTimes, go_slowly_through_the_drive_and_fast_through_what_is_quiet) {
  const DriveTimes drives{{at(36000), at(36100)}, {at(72000), at(72300)}};
  const std::vector<FilmTime> times = film_times(drives, at(86400));
  std::size_t driving = 0;
  for (std::size_t k = 0; k < times.size(); ++k) {
    const bool is_driving = std::ranges::any_of(drives, [&](const auto& drive) {
      return drive.first <= times[k].time && times[k].time < drive.second;
    });
    driving += is_driving;
    EXPECT_EQ(times[k].is_quiet, !is_driving);
    EXPECT_EQ(times[k].rate, is_driving ? 2 * 25 : 1720 * 25)
        << "400 s in 200 pictures, a day in 50";
    if (k > 0) {
      EXPECT_GT(times[k].time, times[k - 1].time);
    }
  }
  EXPECT_EQ(driving, 200u);
  EXPECT_LE(times.size(), 254u);
  EXPECT_EQ(std::ranges::count(times, at(36000), &FilmTime::time), 1) << "as it sets off";
}

TEST(FilmTimes, are_even_where_a_rover_but_stands_or_but_drives) {
  for (const DriveTimes& drives : {DriveTimes{}, DriveTimes{{at(0), at(5000)}}}) {
    const std::vector<FilmTime> times = film_times(drives, at(2500));
    ASSERT_EQ(times.size(), 251u);
    for (std::size_t k = 0; k < times.size(); ++k) EXPECT_EQ(times[k].time, at(10.0 * double(k)));
  }
}

TEST(FilmTimes, show_the_end_of_the_run) {
  const DriveTimes drives{{at(0), at(100)}};
  EXPECT_EQ(film_times(drives, at(180'000)).back().time, at(180'000));
  EXPECT_EQ(film_times("7 min", at(600)).back().time, at(600));
}

TEST(FilmTimes, are_what_is_asked) {
  const std::vector<FilmTime> times = film_times("2 min", at(600));
  ASSERT_EQ(times.size(), 6u);
  EXPECT_EQ(times[1].time, at(120));
  EXPECT_EQ(times[1].rate, 3000);
  EXPECT_THROW(film_times("now and then", at(600)), InputError);
  EXPECT_THROW(film_times("0.01 s", at(600)), InputError);
}

}  // namespace
}  // namespace lsos
