// Calendar time of plans and logs. Leap seconds are counted: differences are SI seconds.
#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/parsed.h"
#include "base/sim_time.h"

namespace lsos {

// A moment: whole microseconds of TAI since 2000-01-01T00:00:00 TAI.
struct Instant {
  std::int64_t tai_us = 0;

  auto operator<=>(const Instant&) const = default;
};

inline Instant operator+(Instant start, SimTime time) { return {start.tai_us + time.count()}; }
inline SimTime operator-(Instant later, Instant earlier) {
  return SimTime{later.tai_us - earlier.tai_us};
}

// Reads ISO 8601 ("2026-07-01T12:00:00Z", "2026-07-01 12:00", "2026-07-01T14:00:00.5+02:00"). A
// time without a zone is UTC. Second 60 is accepted in a leap second only. Years 1960..2100.
Parsed<Instant> parse_utc(std::string_view text);

// Days of UTC since 2000-01-01T00:00, of 86400 s each. Like a clock, the count stops at midnight
// during a leap second.
double utc_days(Instant instant);

// "2026-07-01T12:00:00.000Z": rounded to the nearest millisecond.
std::string format_utc(Instant instant);

}  // namespace lsos
