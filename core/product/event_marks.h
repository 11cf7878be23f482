// Chooses the samples of a rover at the starts and ends of its events, so that no event, however
// short, is lost where a long log is thinned.
#pragma once

#include <string>
#include <vector>

#include "record/rows.h"

namespace lsos {

// Which of two successive rows to keep.
struct WantedRows {
  bool previous = false, current = false;
};

class EventMarks {
 public:
  // For each event of that rover that has started: its first sample, its last, and some between if
  // `most` allows. With more events than half of `most`, only every second, third, ... is marked.
  EventMarks(const std::vector<EventRow>& events, const std::string& rover_id, std::size_t most);

  // To be called with the time of each sample, ascending. The row for an event's start is the first
  // at or after it; the row for its end is the last at or before it.
  WantedRows next(SimTime time);
  // Greatest number of rows that are wanted.
  std::size_t size() const { return begins_.size() + ends_.size(); }

 private:
  std::vector<SimTime> begins_, ends_;  // ascending
  std::size_t begun_ = 0, ended_ = 0;   // how many of them have passed
};

}  // namespace lsos
