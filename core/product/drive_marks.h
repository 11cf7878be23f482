// Chooses the samples of a rover that show its mission on a map: evenly spaced along its drive,
// some at each stop, and the first and last of each event.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "product/event_marks.h"
#include "record/log.h"

namespace lsos {

class DriveMarks {
 public:
  // `totals`: of that rover. At most `most` (10 or more) rows are wanted.
  DriveMarks(const SampleTotals& totals, const std::vector<EventRow>& events,
             const std::string& rover_id, std::size_t most);

  // To be called with each sample of the rover in order of time. The first row is wanted; adding
  // the last is up to the caller.
  WantedRows next(const SampleRow& row);

 private:
  WantedRows at_stops(const SampleRow& row);

  EventMarks events_;
  double spacing_m_ = 0;         // between marks along the drive
  std::int64_t spaces_ = -1;     // full spacings driven so far
  double stop_spacing_m_ = 0;    // between stops that are marked
  std::size_t stops_left_ = 0;   // that may still be marked
  double marked_stop_m_ = -1e9;  // distance driven up to the last marked stop
  bool is_at_marked_stop_ = false;
  bool was_moving_ = false;
};

// Keeps the rows that are wanted, and the last.
class KeptRows {
 public:
  void add(const SampleRow& row, WantedRows wanted);
  std::vector<SampleRow> rows() const;

 private:
  std::vector<SampleRow> rows_;
  std::optional<SampleRow> passed_;  // the last row, if it was not wanted
};

}  // namespace lsos
