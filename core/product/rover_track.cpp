#include "product/rover_track.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "base/polyline.h"
#include "planet/site_frame.h"

namespace lsos {

namespace {

constexpr double vertex_spacing_m = 0.5;  // less than a wheelbase, so that no turn is lost

SimTime round_up(SimTime time, SimTime step) { return (time + step - SimTime{1}) / step * step; }

// A line ends where the rover stands, however near to its last point that is.
void end_at(const Geodetic& last, const Body& body, std::vector<Geodetic>& line) {
  if (surface_distance_m(body, line.back(), last) > 0) line.push_back(last);
}

}  // namespace

SimTime sample_interval(SimTime end, int count, SimTime log_interval, SimTime parked_log_interval) {
  LSOS_ASSERT(count >= 2 && log_interval > SimTime{0} && parked_log_interval > SimTime{0});
  const SimTime shortest = round_up(end, SimTime{count - 1}) / (count - 1);
  const SimTime interval = std::max(round_up(shortest, log_interval), log_interval);
  const SimTime parked_too = round_up(interval, parked_log_interval);
  const bool fits = parked_log_interval % log_interval == SimTime{0} && parked_too <= 2 * interval;
  return fits ? parked_too : interval;
}

std::vector<Geodetic> simplified_line(const Body& body, const std::vector<Geodetic>& line) {
  if (line.size() < 3) return line;
  const SiteFrame frame(body, {line.front().lon_rad, line.front().lat_rad, 0});
  std::vector<Vec2> points_m;
  for (const Geodetic& place : line) {
    points_m.emplace_back(frame.p_S_m({place.lon_rad, place.lat_rad, 0}).head<2>());
  }
  std::vector<Geodetic> simple;
  for (const std::size_t k : points_of_simplified(points_m, line_tolerance_m)) {
    simple.push_back(line[k]);
  }
  return simple;
}

RoverTrack::RoverTrack(const Body& body, DriveMarks marks, DriveMarks track_marks,
                       SimTime track_interval, SimTime piece_length)
    : body_(&body),
      marks_(std::move(marks)),
      track_marks_(std::move(track_marks)),
      track_interval_(track_interval),
      piece_length_(piece_length) {}

void RoverTrack::add(const SampleRow& row) {
  samples_.add(row, marks_.next(row));
  WantedRows wanted = track_marks_.next(row);
  if (row.time >= next_) {
    wanted.current = true;
    if (track_interval_ > SimTime{0}) next_ = (row.time / track_interval_ + 1) * track_interval_;
  }
  track_.add(row, wanted);
  if (pieces_.empty()) {
    pieces_.push_back({row.time, {row.place}});
  } else if (piece_length_ > SimTime{0} &&
             row.time / piece_length_ > pieces_.back().from / piece_length_) {
    end_at(last_, *body_, pieces_.back().line);
    pieces_.back().line = simplified_line(*body_, pieces_.back().line);
    pieces_.push_back({row.time / piece_length_ * piece_length_, {last_}});
  }
  std::vector<Geodetic>& line = pieces_.back().line;
  if (surface_distance_m(*body_, line.back(), row.place) >= vertex_spacing_m) {
    line.push_back(row.place);
  }
  last_ = row.place;
}

std::vector<RoverTrack::Piece> RoverTrack::driven() const {
  std::vector<Piece> driven = pieces_;
  if (!driven.empty()) {
    std::vector<Geodetic>& line = driven.back().line;
    end_at(last_, *body_, line);
    line = simplified_line(*body_, line);
  }
  std::erase_if(driven, [](const Piece& piece) { return piece.line.size() < 2; });
  return driven;
}

}  // namespace lsos
