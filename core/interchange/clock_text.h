// Days, clock times and times after another, as planners write them in tables.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/parsed.h"
#include "planet/utc.h"

namespace lsos {

// What a time in a table is relative to.
struct TimeContext {
  std::string date;               // of the row's day: "2026-07-03"; "": not known
  std::optional<Instant> before;  // last start that the rover's rows above say
};

// The date "2026-07-03" of a day: "3" or "Day 3", where day 1 is the UTC date on which the mission
// starts; or a date "2026-07-03", "2026/07/03".
Parsed<std::string> date_of_day(std::string_view text, Instant mission_start);

// A time as sheets write it: "08:00" or "08:00:30.5" (UTC) on day 1, 2, ... as date_of_day()
// counts.
struct DayClock {
  int day = 1;
  std::string clock;
};
// The day and clock that read back as exactly this instant; absent before day 1, and where no clock
// says it, as in a leap second.
std::optional<DayClock> day_clock(Instant instant, Instant mission_start);

// Whether a text is a span of clocks, "08:00-10:00" or "8:00 to 10", which a zone, "08:00-05:00",
// cannot be told from.
bool is_range(std::string_view text);

// A UTC time in ISO 8601 of "2026-07-03 08:00", a clock time "08:00" or "8:00:30" (UTC) on the day
// of the row, or "+2 h" or "+0:30" after the last start above. Refuses ranges. Texts that are
// nothing of these are returned as they are: a reader of fields says what is wrong with them.
Parsed<std::string> utc_text(std::string_view text, const TimeContext& context);

// Seconds of a clock or span "1:30" or "01:30:15"; absent when the text is none. The hours may be
// more than 24.
std::optional<double> clock_s(std::string_view text);

}  // namespace lsos
