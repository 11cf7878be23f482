// The samples, track and driven line of one rover in the overlay, gathered in one pass over a log
// of any length.
#pragma once

#include <string>
#include <vector>

#include "planet/body.h"
#include "product/drive_marks.h"
#include "record/log.h"

namespace lsos {

// Interval of samples such that at most `count` (2 or more) fall into 0..end: a multiple of
// `log_interval`, and also of `parked_log_interval` if that costs no more than half of the samples,
// because a parked rover has rows at those times only.
SimTime sample_interval(SimTime end, int count, SimTime log_interval, SimTime parked_log_interval);

class RoverTrack {
 public:
  // `marks` chooses the samples. `track_marks` and one sample in each `track_interval` make up the
  // track; if the interval is 0 the track has every sample.
  RoverTrack(const Body& body, DriveMarks marks, DriveMarks track_marks, SimTime track_interval);

  // Rows come in order of time.
  void add(const SampleRow& row);

  // The driven line, with a point about every 0.5 m; fewer than two points if it never moved.
  std::vector<Geodetic> line() const;
  std::vector<SampleRow> samples() const { return samples_.rows(); }
  std::vector<SampleRow> track() const { return track_.rows(); }

 private:
  const Body* body_;
  DriveMarks marks_, track_marks_;
  SimTime track_interval_, next_{};  // when the next sample of the track is due
  KeptRows samples_, track_;
  std::vector<Geodetic> line_;
  Geodetic last_;
};

}  // namespace lsos
