#include "product/report_moments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "product/rover_days.h"

namespace lsos {

namespace {

constexpr double stop_distance_max_m = 2;  // an event with less motion is a stop
constexpr SimTime stop{60'000'000};        // shortest stop that counts
constexpr SimTime picture_spacing{30'000'000};
constexpr std::size_t stops_most = 8;
constexpr std::size_t rovers_most = 3;  // whose start and end are shown
// A mission longer than a day has fewer pictures: each takes a second or two where the ground has
// much detail, and few show more than the plots.
constexpr std::size_t stops_most_of_days = 3, starts_most_of_days = 1;

SimTime middle(const EventRow& event) {
  return round_up_to_exchange((*event.start + *event.end) / 2);
}

// Whether each rover has a panel up in the middle of each of its events: all that is kept of the
// rows, of which a long run has millions.
class PanelsAtEvents {
 public:
  PanelsAtEvents(const LogReader& log, const std::vector<EventRow>& events) {
    for (const EventRow& event : events) {
      if (event.start && event.end) by_rover_[event.rover_id].moments.push_back({middle(event)});
    }
    for (auto& [id, rover] : by_rover_) std::ranges::sort(rover.moments, {}, &Moment::time);
    log.for_each_panel([&](const PanelRow& row) {
      const auto found = by_rover_.find(row.rover_id);
      if (found != by_rover_.end()) found->second.add(row);
    });
    for (auto& [id, rover] : by_rover_) rover.settle(SimTime::max());
  }
  bool is_up(const EventRow& event) const {
    const std::vector<Moment>& moments = by_rover_.at(event.rover_id).moments;
    return std::ranges::lower_bound(moments, middle(event), {}, &Moment::time)->is_up;
  }

 private:
  struct Moment {
    SimTime time;
    bool is_up = false;
  };
  struct Rover {
    std::vector<Moment> moments;  // in order of time
    std::size_t next = 0;         // first that is not settled yet
    std::optional<SimTime> last;  // of the rows so far
    bool is_up = false;           // then; one of several panels is enough

    void add(const PanelRow& row) {
      const bool is_up_now = !std::isnan(row.azimuth_rad);
      if (last != row.time) settle(row.time);
      is_up = is_up_now || (last == row.time && is_up);
      last = row.time;
    }
    // Those before a time are as the rover is.
    void settle(SimTime before) {
      for (; next < moments.size() && moments[next].time < before; ++next) {
        moments[next].is_up = is_up;
      }
    }
  };
  std::map<std::string, Rover> by_rover_;
};

// Stops with panels up. The longest of the events between two drives stands for the stop.
std::vector<ReportMoment> solar_stops(const ReportData& data, const PanelsAtEvents& panels) {
  std::vector<ReportMoment> stops;
  const EventRow* longest = nullptr;
  const auto end_stop = [&] {
    if (longest != nullptr) {
      stops.push_back({middle(*longest), longest->rover_id, longest->label, true});
    }
    longest = nullptr;
  };
  std::string rover_id;
  for (const EventRow& event : data.events) {
    if (event.rover_id != rover_id) end_stop();
    rover_id = event.rover_id;
    if (!event.start || !event.end) continue;
    if (event.distance_m > stop_distance_max_m) {
      end_stop();
      continue;
    }
    const SimTime took = *event.end - *event.start;
    if (took < stop || !panels.is_up(event)) continue;
    if (longest == nullptr || took > *longest->end - *longest->start) longest = &event;
  }
  end_stop();
  return stops;
}

// The moment at which the first event failed, unless a picture of that rover is taken about then.
std::optional<ReportMoment> first_failure(const ReportData& data,
                                          const std::vector<ReportMoment>& moments) {
  const EventRow* first = nullptr;
  for (const EventRow& event : data.events) {
    if (event.status != EventStatus::failed || !event.end) continue;
    if (first == nullptr || *event.end < *first->end) first = &event;
  }
  if (first == nullptr) return std::nullopt;
  const SimTime time = round_up_to_exchange(*first->end);
  const bool is_seen = std::ranges::any_of(moments, [&](const ReportMoment& moment) {
    return moment.rover_id == first->rover_id && moment.time + picture_spacing >= time &&
           time + picture_spacing >= moment.time;
  });
  if (is_seen) return std::nullopt;
  return ReportMoment{time, first->rover_id, first->label + " failed", false};
}

}  // namespace

std::vector<ReportMoment> report_moments(const LogReader& log, const ReportData& data,
                                         std::vector<std::string>& left_out) {
  const PanelsAtEvents panels(log, data.events);
  const bool has_days = from_seconds(data.end_s) > day_length;
  const std::size_t starts_most = has_days ? starts_most_of_days : rovers_most;
  std::vector<ReportMoment> moments;
  for (std::size_t k = 0; k < std::min(rovers_most, data.rovers.size()); ++k) {
    const ReportRover& rover = data.rovers[k];
    const SimTime end = from_seconds(rover.last_s);
    if (k < starts_most) moments.push_back({{}, rover.id, "Start", false});
    if (end > picture_spacing) moments.push_back({end, rover.id, "End", false});
  }
  const std::vector<ReportMoment> stops = solar_stops(data, panels);
  // If there are too many stops, some from all parts of the mission are kept.
  const std::size_t count = std::min(has_days ? stops_most_of_days : stops_most, stops.size());
  if (count < stops.size()) {
    left_out.push_back(fmt::format("pictures of {} of the {} stops with panels up",
                                   stops.size() - count, stops.size()));
  }
  if (data.rovers.size() > rovers_most) {
    left_out.push_back(fmt::format("pictures of start and end of {} of the {} rovers",
                                   data.rovers.size() - rovers_most, data.rovers.size()));
  }
  for (std::size_t k = 0; k < count; ++k) {
    moments.push_back(stops[k * stops.size() / count]);
  }
  if (const auto failure = first_failure(data, moments)) moments.push_back(*failure);
  std::ranges::stable_sort(moments, {}, [](const ReportMoment& moment) {
    return std::pair(moment.time, moment.rover_id);
  });
  return moments;
}

}  // namespace lsos
