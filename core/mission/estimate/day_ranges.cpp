#include "mission/estimate/day_ranges.h"

#include <algorithm>
#include <cmath>

#include "base/rounding.h"
#include "mission/estimate/event_ranges.h"

namespace lsos {

namespace {

constexpr double day_s = 86400;
// Charges that differ by less are the same.
constexpr double same_charge = 1e-9;

// How far a value may lie below and above what is expected; both are positive.
struct Doubt {
  double less = 0, more = 0;
};

Doubt doubt_of(const std::optional<double>& value, const std::optional<Expected>& range) {
  if (!value || !range) return {};
  return {std::max(0.0, *value - range->low), std::max(0.0, range->high - *value)};
}

// Absent where it is narrower than `least`.
std::optional<Expected> range_of(const std::optional<double>& value, const Doubt& doubt,
                                 double high_max, double least) {
  if (!value || (doubt.less <= 0 && doubt.more <= 0)) return {};
  const Expected range{std::max(0.0, *value - doubt.less), std::min(high_max, *value + doubt.more)};
  if (range.high - range.low < least) return {};
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

// How sure the charge is at a time: it goes from what it was as the last event before ended to what
// it is as the one that is under way ends.
Doubt charge_doubt_at(const DayEstimate& day, const std::vector<EventEstimate>& events,
                      double time_s) {
  Doubt doubt;
  double last_s = -1;
  const EventEstimate* under_way = nullptr;
  for (const EventEstimate& event : events) {
    if (event.rover_id != day.rover_id || !event.start_s || !event.end_s) continue;
    const double start_s = *event.start_s, end_s = *event.end_s;
    if (end_s <= time_s && end_s > last_s) {
      last_s = end_s;
      doubt = doubt_of(event.charge_end, event.charge_end_range);
    }
    // Where several are, as one takes effect without a turn beside another, the longest counts.
    const bool is_under_way = start_s < time_s && time_s < end_s;
    if (is_under_way && (!under_way || end_s > *under_way->end_s)) under_way = &event;
  }
  if (!under_way) return doubt;
  const double share = (time_s - *under_way->start_s) / (*under_way->end_s - *under_way->start_s);
  const Doubt then = doubt_of(under_way->charge_end, under_way->charge_end_range);
  return {std::lerp(doubt.less, then.less, share), std::lerp(doubt.more, then.more, share)};
}

// How sure the least charge of the day's events is.
Doubt least_charge_doubt(const DayEstimate& day, const std::vector<EventEstimate>& events,
                         double begin_s, double end_s) {
  Doubt doubt;
  std::optional<double> least;
  for (const EventEstimate& event : events) {
    if (event.rover_id != day.rover_id || !event.start_s || !event.end_s) continue;
    if (share_between(event, begin_s, end_s) <= 0 || !event.charge_min) continue;
    if (least && *event.charge_min >= *least) continue;
    least = event.charge_min;
    doubt = doubt_of(event.charge_min, event.charge_min_range);
  }
  return doubt;
}

// `charge_before`: as the day begins; absent: not known.
void add_ranges(DayEstimate& day, std::optional<double> charge_before,
                const std::vector<EventEstimate>& events) {
  const double begin_s = day_s * (day.day - 1), end_s = day_s * day.day;
  Doubt energy;
  for (const EventEstimate& event : events) {
    if (event.rover_id != day.rover_id || !event.start_s || !event.end_s) continue;
    add(energy, share_between(event, begin_s, end_s),
        doubt_of(event.energy_used_j, event.energy_range_j));
  }
  const auto at = [&](double time_s, double charge) {
    return charge >= full_charge ? Doubt{} : charge_doubt_at(day, events, time_s);
  };
  day.energy_range_j =
      range_of(day.energy_used_j, energy, infinite, energy_told * day.energy_used_j.value_or(0));
  if (!day.charge_end || !day.charge_min) return;
  const Doubt at_end = at(end_s, *day.charge_end);
  // The least charge is as sure as that at the moment at which it is the least.
  const auto is_least = [&](double charge) {
    return std::abs(charge - *day.charge_min) < same_charge;
  };
  const Doubt at_least = is_least(*day.charge_end) ? at_end
                         : charge_before && is_least(*charge_before)
                             ? at(begin_s, *charge_before)
                             : least_charge_doubt(day, events, begin_s, end_s);
  const double least = day.energy_range_j ? 0 : charge_told;
  day.charge_end_range = range_of(day.charge_end, at_end, 1, least);
  day.charge_min_range = range_of(day.charge_min, at_least, 1, least);
}

}  // namespace

void add_day_ranges(std::vector<DayEstimate>& days, const std::vector<EventEstimate>& events) {
  const DayEstimate* before = nullptr;
  for (DayEstimate& day : days) {
    const bool goes_on = before && before->rover_id == day.rover_id;
    add_ranges(day, goes_on ? before->charge_end : std::nullopt, events);
    before = &day;
  }
}

}  // namespace lsos
