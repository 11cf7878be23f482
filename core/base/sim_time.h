// Simulated time in whole microseconds since the mission's StartTime, which makes sums exact.
#pragma once

#include <chrono>
#include <cmath>
#include <cstdint>

namespace lsos {

using SimTime = std::chrono::duration<std::int64_t, std::micro>;

// Rovers exchange their states, scripts run and the log is written only at multiples of this
// period.
inline constexpr SimTime exchange_period{100'000};

// 24 hours.
inline constexpr SimTime day_length{86'400'000'000};
inline constexpr double day_length_s = 86400;

inline double seconds(SimTime time) { return static_cast<double>(time.count()) / 1e6; }

// Nearest microsecond. `time_s` must be within +-9e12 s.
inline SimTime from_seconds(double time_s) { return SimTime{std::llround(time_s * 1e6)}; }

// The time rounded to a whole microsecond, as times are stored, so that a duration given in hours
// ends at exactly that time. Times of 9e12 s and more are returned unchanged.
inline double rounded_s(double time_s) {
  return std::abs(time_s) < 9e12 ? seconds(from_seconds(time_s)) : time_s;
}

// The first multiple of the exchange period at or after `time`.
inline SimTime round_up_to_exchange(SimTime time) {
  const std::int64_t period = exchange_period.count();
  const std::int64_t below = time.count() / period * period;
  return SimTime{below >= time.count() ? below : below + period};
}

}  // namespace lsos
