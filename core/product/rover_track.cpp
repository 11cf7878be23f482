#include "product/rover_track.h"

#include <algorithm>

#include "base/error.h"

namespace lsos {

namespace {

constexpr double vertex_spacing_m = 0.5;  // finer than a wheelbase, so no turn is lost
constexpr double moving_mps = 1e-3;

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

void RoverTrack::Thinned::add(const SampleRow& row) {
  if (row.time < next) return;
  rows.push_back(row);
  if (interval > SimTime{0}) next = row.time / interval * interval + interval;
}

void RoverTrack::add(const SampleRow& row) {
  samples_.add(row);
  add_to_track(row);
  last_ = row.place;
  if (line_.empty() || surface_distance_m(*body_, line_.back(), row.place) >= vertex_spacing_m) {
    line_.push_back(row.place);
  }
}

void RoverTrack::add_to_track(const SampleRow& row) {
  const bool is_moving = row.speed_mps > moving_mps;
  if (is_moving != was_moving_) {
    if (passed_) track_.rows.push_back(*passed_);
    track_.next = row.time;
  }
  was_moving_ = is_moving;
  const std::size_t before = track_.rows.size();
  track_.add(row);
  passed_.reset();
  if (track_.rows.size() == before) passed_ = row;
}

std::vector<SampleRow> RoverTrack::track() const {
  std::vector<SampleRow> rows = track_.rows;
  if (passed_) rows.push_back(*passed_);
  return rows;
}

std::vector<Geodetic> RoverTrack::line() const {
  std::vector<Geodetic> line = line_;
  const bool has_moved_on = !line.empty() && surface_distance_m(*body_, line.back(), last_) > 0;
  if (has_moved_on) line.push_back(last_);
  return line;
}

}  // namespace lsos
