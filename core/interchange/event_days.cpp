#include "interchange/event_days.h"

#include <algorithm>
#include <map>
#include <optional>

#include "interchange/clock_text.h"
#include "interchange/thing_fields.h"

namespace lsos {

namespace {

std::optional<Instant> start_of_mission(const KmlSource& things) {
  for (const SourcePlacemark& thing : things.placemarks) {
    const std::string* text = thing_field(thing, "StartTime");
    if (thing_type(thing) != "MissionInfo" || text == nullptr) continue;
    if (const Parsed<Instant> start = parse_utc(*text)) return start.value;
  }
  return {};
}

std::optional<DayClock> day_clock_of(const std::string& text, Instant mission) {
  const Parsed<Instant> instant = parse_utc(text);
  return instant ? day_clock(*instant.value, mission) : std::nullopt;
}

}  // namespace

std::vector<EventDay> event_days(const KmlSource& things, const Declarations& declarations) {
  const std::optional<Instant> mission = start_of_mission(things);
  if (!mission) return {};
  std::vector<EventDay> days(things.placemarks.size());
  std::map<std::string, int> today;  // by rover id
  for (std::size_t i = 0; i < days.size(); ++i) {
    const SourcePlacemark& thing = things.placemarks[i];
    if (!declarations.events.contains(thing_type(thing))) continue;
    const std::string* rover = thing_field(thing, "RoverId");
    int& day = today.emplace(rover == nullptr ? "" : *rover, 1).first->second;
    if (const std::string* start = thing_field(thing, "StartTime")) {
      const auto found = day_clock_of(*start, *mission);
      days[i].start = found ? found->clock : *start;
      // A start without a clock, or on a day that is over, stands whole, and its row says no day.
      if (!found || found->day < day) {
        days[i].start = *start;
        continue;
      }
      day = found->day;
    }
    days[i].day = day;
  }
  return days;
}

std::string time_on_day(const std::string& text, int day, const KmlSource& things) {
  const std::optional<Instant> mission = start_of_mission(things);
  if (!mission || day == 0) return text;
  const auto found = day_clock_of(text, *mission);
  return found && found->day == day ? found->clock : text;
}

}  // namespace lsos
