// Simulated time: whole microseconds since the mission's StartTime, so that sums are exact.
#pragma once

#include <chrono>
#include <cmath>
#include <cstdint>

namespace lsos {

using SimTime = std::chrono::duration<std::int64_t, std::micro>;

// Rovers see each other, scripts run and the log is written only at multiples of this.
inline constexpr SimTime exchange_period{100'000};

inline double seconds(SimTime time) { return static_cast<double>(time.count()) / 1e6; }

// Nearest microsecond. `time_s` must be within +-9e12 s.
inline SimTime from_seconds(double time_s) { return SimTime{std::llround(time_s * 1e6)}; }

// The nearest whole microsecond, as times are kept: a duration given in hours then is over when it
// is. Longer ones than those stay as they are.
inline double rounded_s(double time_s) {
  return std::abs(time_s) < 9e12 ? seconds(from_seconds(time_s)) : time_s;
}

// The first exchange at or after `time`.
inline SimTime round_up_to_exchange(SimTime time) {
  const std::int64_t period = exchange_period.count();
  const std::int64_t below = time.count() / period * period;
  return SimTime{below >= time.count() ? below : below + period};
}

}  // namespace lsos
