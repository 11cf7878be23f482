#include "product/rover_track.h"

#include <algorithm>
#include <utility>

#include "base/error.h"

namespace lsos {

namespace {

constexpr double vertex_spacing_m = 0.5;  // less than a wheelbase, so that no turn is lost

SimTime round_up(SimTime time, SimTime step) { return (time + step - SimTime{1}) / step * step; }

}  // namespace

SimTime sample_interval(SimTime end, int count, SimTime log_interval, SimTime parked_log_interval) {
  LSOS_ASSERT(count >= 2 && log_interval > SimTime{0} && parked_log_interval > SimTime{0});
  const SimTime shortest = round_up(end, SimTime{count - 1}) / (count - 1);
  const SimTime interval = std::max(round_up(shortest, log_interval), log_interval);
  const SimTime parked_too = round_up(interval, parked_log_interval);
  const bool fits = parked_log_interval % log_interval == SimTime{0} && parked_too <= 2 * interval;
  return fits ? parked_too : interval;
}

RoverTrack::RoverTrack(const Body& body, DriveMarks marks, DriveMarks track_marks,
                       SimTime track_interval)
    : body_(&body),
      marks_(std::move(marks)),
      track_marks_(std::move(track_marks)),
      track_interval_(track_interval) {}

void RoverTrack::add(const SampleRow& row) {
  samples_.add(row, marks_.next(row));
  WantedRows wanted = track_marks_.next(row);
  if (row.time >= next_) {
    wanted.current = true;
    if (track_interval_ > SimTime{0}) next_ = (row.time / track_interval_ + 1) * track_interval_;
  }
  track_.add(row, wanted);
  last_ = row.place;
  if (line_.empty() || surface_distance_m(*body_, line_.back(), row.place) >= vertex_spacing_m) {
    line_.push_back(row.place);
  }
}

std::vector<Geodetic> RoverTrack::line() const {
  std::vector<Geodetic> line = line_;
  const bool has_moved_on = !line.empty() && surface_distance_m(*body_, line.back(), last_) > 0;
  if (has_moved_on) line.push_back(last_);
  return line;
}

}  // namespace lsos
