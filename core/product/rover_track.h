// What the overlay shows of one rover's samples, gathered in one pass over a log of any length.
#pragma once

#include <string>
#include <vector>

#include "planet/body.h"
#include "product/drive_marks.h"
#include "record/log.h"

namespace lsos {

// Time between samples that are shown, such that at most `count` (2 or more) fall into 0..end: a
// multiple of `log_interval`, and of `parked_log_interval` too where that costs no more than half
// of the samples, because those are the times that a parked rover has rows at.
SimTime sample_interval(SimTime end, int count, SimTime log_interval, SimTime parked_log_interval);

class RoverTrack {
 public:
  // `marks`: the samples that are shown. `track_marks` and one sample in each `track_interval`
  // make the track; without an interval it has every sample.
  RoverTrack(const Body& body, DriveMarks marks, DriveMarks track_marks, SimTime track_interval);

  // In order of time.
  void add(const SampleRow& row);

  // Where it drove, every 0.5 m or so; fewer than two points when it never moved.
  std::vector<Geodetic> line() const;
  std::vector<SampleRow> samples() const { return samples_.rows(); }
  std::vector<SampleRow> track() const { return track_.rows(); }

 private:
  const Body* body_;
  DriveMarks marks_, track_marks_;
  SimTime track_interval_, next_{};  // when the interval's next sample is due
  KeptRows samples_, track_;
  std::vector<Geodetic> line_;
  Geodetic last_;
};

}  // namespace lsos
