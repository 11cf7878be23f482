// Which of a rover's samples belong to the moments of its events, so that no event, however short,
// is lost where a long log is thinned.
#pragma once

#include <string>
#include <vector>

#include "record/rows.h"

namespace lsos {

// Which of two rows that follow each other are to be kept.
struct WantedRows {
  bool previous = false, current = false;
};

class EventMarks {
 public:
  // Of the events of that rover that have started: the first sample of each, its last, and some
  // between where `most` allows for that. Where there are more than half of `most`, every second,
  // third, ... event is marked.
  EventMarks(const std::vector<EventRow>& events, const std::string& rover_id, std::size_t most);

  // Called with the time of each sample, ascending. A row at an event's start is the first at it or
  // after it; the row at its end is the last at it or before it.
  WantedRows next(SimTime time);
  // Rows that it wants at most.
  std::size_t size() const { return begins_.size() + ends_.size(); }

 private:
  std::vector<SimTime> begins_, ends_;  // ascending
  std::size_t begun_ = 0, ended_ = 0;   // of these, those that have gone by
};

}  // namespace lsos
