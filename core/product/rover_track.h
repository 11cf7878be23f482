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

// Lines of an overlay leave out points that they hardly bend at, Douglas and Peucker (1973): none
// of them is farther than this from the line. Viewers show a metre as a pixel at the closest.
inline constexpr double line_tolerance_m = 0.2;

// The line without such points; it keeps its ends.
std::vector<Geodetic> simplified_line(const Body& body, const std::vector<Geodetic>& line);

class RoverTrack {
 public:
  // A part of the driven line, from its first place at the earliest.
  struct Piece {
    SimTime from{};
    std::vector<Geodetic> line;
  };

  // `marks` chooses the samples. `track_marks` and one sample in each `track_interval` make up the
  // track; if the interval is 0 the track has every sample. The driven line is cut each
  // `piece_length`; 0: it is left whole.
  RoverTrack(const Body& body, DriveMarks marks, DriveMarks track_marks, SimTime track_interval,
             SimTime piece_length = {});

  // Rows come in order of time.
  void add(const SampleRow& row);

  // The pieces in which it moved. Each goes on where the last one ended, and no place that the
  // rover passed is farther than `line_tolerance_m` from it.
  std::vector<Piece> driven() const;
  std::vector<SampleRow> samples() const { return samples_.rows(); }
  std::vector<SampleRow> track() const { return track_.rows(); }

 private:
  const Body* body_;
  DriveMarks marks_, track_marks_;
  SimTime track_interval_, next_{};  // when the next sample of the track is due
  KeptRows samples_, track_;
  SimTime piece_length_;
  std::vector<Piece> pieces_;  // the last with a point about every 0.5 m, the others simplified
  Geodetic last_;
};

}  // namespace lsos
