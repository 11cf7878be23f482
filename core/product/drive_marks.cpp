#include "product/drive_marks.h"

#include <cmath>

#include "base/error.h"

namespace lsos {

namespace {

// Shares of all rows that are reserved for events and for stops.
constexpr std::size_t share_of_events = 2, share_of_stops = 1, all_shares = 5;

}  // namespace

DriveMarks::DriveMarks(const SampleTotals& totals, const std::vector<EventRow>& events,
                       const std::string& rover_id, std::size_t most)
    : events_(events, rover_id, share_of_events * most / all_shares) {
  LSOS_ASSERT(most >= 10);
  const std::size_t stop_rows = share_of_stops * most / all_shares;
  stops_left_ = stop_rows / 2;  // two rows each
  stop_spacing_m_ = totals.distance_m / static_cast<double>(stops_left_);
  // Three rows less: the first, the last, and one that rounding may add.
  const std::size_t drive_rows = most - events_.size() - stop_rows - 3;
  spacing_m_ = totals.distance_m / static_cast<double>(drive_rows);
}

WantedRows DriveMarks::next(const SampleRow& row) {
  WantedRows wanted = events_.next(row.time);
  const WantedRows stop = at_stops(row);
  wanted.previous |= stop.previous;
  wanted.current |= stop.current;
  const double behind = spacing_m_ > 0 ? std::floor(row.distance_m / spacing_m_) : 0;
  const auto spaces = static_cast<std::int64_t>(behind);
  if (spaces > spaces_) {
    spaces_ = spaces;
    wanted.current = true;
  }
  return wanted;
}

// Wants the rows at which the rover stops and sets off; stops that lie close together count as one.
WantedRows DriveMarks::at_stops(const SampleRow& row) {
  WantedRows wanted;
  const bool is_moving = row.speed_mps > moving_mps;
  if (is_moving == was_moving_) return wanted;
  was_moving_ = is_moving;
  if (is_moving) {
    wanted.previous = is_at_marked_stop_;
    is_at_marked_stop_ = false;
  } else if (stops_left_ > 0 && row.distance_m - marked_stop_m_ >= stop_spacing_m_) {
    --stops_left_;
    marked_stop_m_ = row.distance_m;
    wanted.current = is_at_marked_stop_ = true;
  }
  return wanted;
}

void KeptRows::add(const SampleRow& row, WantedRows wanted) {
  if (wanted.previous && passed_) rows_.push_back(*passed_);
  passed_.reset();
  if (wanted.current) {
    rows_.push_back(row);
  } else {
    passed_ = row;
  }
}

std::vector<SampleRow> KeptRows::rows() const {
  std::vector<SampleRow> rows = rows_;
  if (passed_) rows.push_back(*passed_);
  return rows;
}

}  // namespace lsos
