#include "mission/estimate/event_ranges.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace lsos {

namespace {

// Times that differ by less are the same, s: an event begins at the exchange after another ends.
constexpr double same_moment_s = 1;

// What has come together of a rover's events.
struct Carried {
  Expected end_s = Expected::exactly(0);
  double less_j = 0, more_j = 0;
};

using Key = std::pair<std::string, std::int64_t>;

// Whether an event that does not begin too late ends at a time of day that the plan gives.
bool ends_by_clock(const DoubtedEvent& event, Instant mission_start) {
  return std::ranges::any_of(event.planned->params, [&](const auto& param) {
    const Instant* at = std::get_if<Instant>(&param.second);
    return at && std::abs(seconds(*at - mission_start) - *event.estimate->end_s) <= same_moment_s;
  });
}

// When it begins, by what it waits for.
Expected start_s(const DoubtedEvent& event, Instant mission_start, const Expected& before_s,
                 const std::map<Key, Expected>& ends_s) {
  const double at_s = *event.estimate->start_s;
  Expected start = before_s;
  const auto wait_for = [&](const Expected& other_s) {
    start.low = std::max(start.low, other_s.low);
    start.high = std::max(start.high, other_s.high);
  };
  for (const PlanEvent::Reference& other : event.planned->start_after) {
    const auto found = ends_s.find({other.rover_id, other.sequence});
    if (found != ends_s.end()) wait_for(found->second);
  }
  if (event.planned->start_time) {
    wait_for(Expected::exactly(seconds(*event.planned->start_time - mission_start)));
  }
  // Later than all of these it waits for something else.
  if (at_s > start.high + same_moment_s) return Expected::exactly(at_s);
  return {std::min(start.low, at_s), std::max(start.high, at_s)};
}

std::optional<Expected> told(double low, double high, double least) {
  if (high - low < least) return {};
  return Expected{low, high};
}

void add_energy(const DoubtedEvent& event, const Expected& duration_s, Carried& carried) {
  EventEstimate& estimate = *event.estimate;
  if (!estimate.energy_used_j) return;
  const double used_j = *estimate.energy_used_j, takes_s = *estimate.end_s - *estimate.start_s;
  // What else the rover uses it uses as long as the event takes.
  const double other_w = takes_s > 0 ? std::max(0.0, used_j - event.drives.driven_j) / takes_s : 0;
  const double less_j =
      event.drives.less_j + event.loads_less_j + other_w * (takes_s - duration_s.low);
  const double more_j =
      event.drives.more_j + event.loads_more_j + other_w * (duration_s.high - takes_s);
  estimate.energy_range_j =
      told(std::max(0.0, used_j - less_j), used_j + more_j, energy_told * used_j);
  carried.less_j += less_j - event.loads_less_j + event.sun_more_j;
  carried.more_j += more_j - event.loads_more_j + event.sun_less_j;
  if (!estimate.charge_end || !estimate.charge_min || event.capacity_j <= 0) return;
  // Where what it has used is a range, so is what is left, be it as narrow as it may.
  const double least = estimate.energy_range_j ? 0 : charge_told;
  const auto of_charge = [&](double charge) {
    return told(std::max(0.0, charge - carried.more_j / event.capacity_j),
                std::min(1.0, charge + carried.less_j / event.capacity_j), least);
  };
  estimate.charge_min_range = of_charge(*estimate.charge_min);
  if (*estimate.charge_end >= full_charge || event.charging_w > 0) {
    carried.less_j = carried.more_j = 0;
  } else {
    estimate.charge_end_range = of_charge(*estimate.charge_end);
  }
}

}  // namespace

void add_ranges(const std::vector<DoubtedEvent>& events, Instant mission_start) {
  std::vector<DoubtedEvent> in_order;
  for (const DoubtedEvent& event : events) {
    if (event.estimate->start_s && event.estimate->end_s) in_order.push_back(event);
  }
  std::ranges::stable_sort(in_order, [](const DoubtedEvent& a, const DoubtedEvent& b) {
    return std::pair(*a.estimate->start_s, *a.estimate->end_s) <
           std::pair(*b.estimate->start_s, *b.estimate->end_s);
  });
  std::map<std::string, Carried> rovers;
  std::map<Key, Expected> ends_s;
  for (const DoubtedEvent& event : in_order) {
    EventEstimate& estimate = *event.estimate;
    Carried& carried = rovers[estimate.rover_id];
    // An event that takes effect without a turn waits for a clock alone, and nothing waits for it.
    const bool is_timed = event.planned->at.has_value();
    const Expected start = is_timed ? Expected::exactly(*estimate.start_s)
                                    : start_s(event, mission_start, carried.end_s, ends_s);
    const double takes_s = *estimate.end_s - *estimate.start_s;
    Expected duration_s{takes_s - event.drives.early_s, takes_s + event.drives.late_s};
    if (event.was_full) carried.less_j = carried.more_j = 0;
    if (event.charging_w > 0) {
      const double less_j = carried.less_j + event.sun_more_j;
      const double more_j = carried.more_j + event.sun_less_j;
      duration_s.low = std::max(0.0, duration_s.low - less_j / event.charging_w);
      duration_s.high += more_j / event.charging_w;
    }
    Expected end{start.low + duration_s.low, start.high + duration_s.high};
    if (ends_by_clock(event, mission_start)) {
      // One that begins after that time is over at once.
      const double at_s = *estimate.end_s;
      end = {std::max(at_s, start.low), std::max(at_s, start.high)};
      duration_s = Expected::exactly(takes_s);
    }
    estimate.end_range_s = told(end.low, end.high, end_told_s);
    // No event is told to end before it begins.
    const bool may_end_before = estimate.end_range_s && end.low < *estimate.start_s;
    estimate.start_range_s = told(start.low, start.high, may_end_before ? 0 : end_told_s);
    ends_s[{estimate.rover_id, estimate.sequence}] = end;
    add_energy(event, duration_s, carried);
    if (!is_timed) carried.end_s = end;
  }
}

}  // namespace lsos
