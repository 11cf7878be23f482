#include "product/event_marks.h"

#include <algorithm>

namespace lsos {

namespace {

constexpr int parts = 4;  // into which marks within an event divide it

}  // namespace

EventMarks::EventMarks(const std::vector<EventRow>& events, const std::string& rover_id,
                       std::size_t most) {
  std::vector<const EventRow*> started;
  for (const EventRow& event : events) {
    if (event.rover_id == rover_id && event.start) started.push_back(&event);
  }
  std::ranges::sort(started, {}, [](const EventRow* event) { return event->start; });
  const std::size_t each = std::max<std::size_t>(1, most / 2);
  const std::size_t step = std::max<std::size_t>(1, (started.size() + each - 1) / each);
  const bool has_room = (parts + 1) * started.size() <= most;
  for (std::size_t k = 0; k < started.size(); k += step) {
    const SimTime start = *started[k]->start;
    begins_.push_back(start);
    if (!started[k]->end) continue;
    ends_.push_back(*started[k]->end);
    for (int part = 1; part < parts && has_room; ++part) {
      begins_.push_back(start + (*started[k]->end - start) * part / parts);
    }
  }
  std::ranges::sort(begins_);
  std::ranges::sort(ends_);
}

WantedRows EventMarks::next(SimTime time) {
  WantedRows wanted;
  for (; begun_ < begins_.size() && begins_[begun_] <= time; ++begun_) wanted.current = true;
  for (; ended_ < ends_.size() && ends_[ended_] < time; ++ended_) wanted.previous = true;
  return wanted;
}

}  // namespace lsos
