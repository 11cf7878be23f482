// What the overlay shows of one rover's samples, gathered in one pass over a log of any length.
#pragma once

#include <optional>
#include <vector>

#include "planet/body.h"
#include "record/rows.h"

namespace lsos {

// Time between samples that are shown, such that at most `count` (2 or more) fall into 0..end: a
// multiple of `log_interval`, and of `parked_log_interval` too where that costs no more than half
// of the samples, because those are the times that a parked rover has rows at.
SimTime sample_interval(SimTime end, int count, SimTime log_interval, SimTime parked_log_interval);

class RoverTrack {
 public:
  // Intervals of samples() and of track(); without one track() has every sample.
  RoverTrack(const Body& body, SimTime interval, SimTime track_interval)
      : body_(&body), samples_(interval), track_(track_interval) {}

  // In order of time.
  void add(const SampleRow& row);

  // Where it drove, every 0.5 m or so; fewer than two points when it never moved.
  std::vector<Geodetic> line() const;
  // The first sample of each interval.
  const std::vector<SampleRow>& samples() const { return samples_.rows; }
  // The same, with the samples between which the rover sets off or comes to rest, and the last: who
  // stands is not seen creeping.
  std::vector<SampleRow> track() const;

 private:
  // The first row of each interval.
  struct Thinned {
    explicit Thinned(SimTime every) : interval(every) {}
    void add(const SampleRow& row);

    SimTime interval, next{};
    std::vector<SampleRow> rows;
  };
  void add_to_track(const SampleRow& row);

  const Body* body_;
  Thinned samples_, track_;
  std::optional<SampleRow> passed_;  // the last sample, where the track left it out
  bool was_moving_ = false;
  std::vector<Geodetic> line_;
  Geodetic last_;
};

}  // namespace lsos
