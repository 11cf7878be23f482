#include "mission/estimate/day_ranges.h"

#include <algorithm>

#include "mission/estimate/event_ranges.h"

namespace lsos {

namespace {

constexpr double day_s = 86400;

// How far a value may lie below and above what is expected; both are positive.
struct Doubt {
  double less = 0, more = 0;
};

Doubt doubt_of(const std::optional<double>& value, const std::optional<Expected>& range) {
  if (!value || !range) return {};
  return {std::max(0.0, *value - range->low), std::max(0.0, range->high - *value)};
}

std::optional<Expected> range_of(const std::optional<double>& value, const Doubt& doubt) {
  if (!value || (doubt.less <= 0 && doubt.more <= 0)) return {};
  return Expected{std::max(0.0, *value - doubt.less), *value + doubt.more};
}

std::optional<Expected> charge_range(const std::optional<double>& value, const Doubt& doubt) {
  std::optional<Expected> range = range_of(value, doubt);
  if (range) range->high = std::min(1.0, range->high);
  return range;
}

// Share of an event's time that lies between two times; all of an event that takes none.
double share_between(const EventEstimate& event, double begin_s, double end_s) {
  const double takes_s = *event.end_s - *event.start_s;
  if (takes_s <= 0) return *event.start_s >= begin_s && *event.start_s < end_s ? 1 : 0;
  return std::max(0.0, std::min(end_s, *event.end_s) - std::max(begin_s, *event.start_s)) / takes_s;
}

void add(Doubt& sum, double share, const Doubt& doubt) {
  sum.less += share * doubt.less;
  sum.more += share * doubt.more;
}

void add_ranges(DayEstimate& day, const std::vector<EventEstimate>& events) {
  const double begin_s = day_s * (day.day - 1), end_s = day_s * day.day;
  Doubt energy, charge_end, charge_min;
  double last_s = -1;
  std::optional<double> least;
  for (const EventEstimate& event : events) {
    if (event.rover_id != day.rover_id || !event.start_s || !event.end_s) continue;
    const double share = share_between(event, begin_s, end_s);
    add(energy, share, doubt_of(event.energy_used_j, event.energy_range_j));
    const Doubt doubt = doubt_of(event.charge_end, event.charge_end_range);
    if (*event.end_s <= end_s && *event.end_s > last_s) {
      last_s = *event.end_s;
      charge_end = doubt;
    }
    if (share > 0 && event.charge_min && (!least || *event.charge_min < *least)) {
      least = event.charge_min;
      charge_min = doubt_of(event.charge_min, event.charge_min_range);
    }
  }
  if (day.charge_end >= full_charge) charge_end = {};
  day.energy_range_j = range_of(day.energy_used_j, energy);
  day.charge_end_range = charge_range(day.charge_end, charge_end);
  day.charge_min_range = charge_range(day.charge_min, charge_min);
}

}  // namespace

void add_day_ranges(std::vector<DayEstimate>& days, const std::vector<EventEstimate>& events) {
  for (DayEstimate& day : days) add_ranges(day, events);
}

}  // namespace lsos
