#include "mission/rover/foreseen_drive.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace lsos {

ForeseenDrive::ForeseenDrive(DriveEstimate estimate, SimTime start)
    : estimate_(std::move(estimate)) {
  LSOS_ASSERT(!estimate_.marks.empty() && !estimate_.line_S_m.empty());
  for (const DriveMark& mark : estimate_.marks) {
    const SimTime time = round_up_to_exchange(start + from_seconds(mark.time_s));
    times_.push_back(times_.empty() ? time : std::max(time, times_.back() + exchange_period));
  }
  to_point_m_ = {0};
  for (std::size_t k = 1; k < estimate_.line_S_m.size(); ++k) {
    length_m_ += (estimate_.line_S_m[k] - estimate_.line_S_m[k - 1]).head<2>().norm();
    to_point_m_.push_back(length_m_);
  }
  find_place();
}

void ForeseenDrive::advance(SimTime now) {
  while (!has_ended() && times_[mark_ + 1] <= now) ++mark_;
  now_ = estimate_.marks[mark_];
  if (!has_ended() && now > times_[mark_]) {
    const DriveMark& next = estimate_.marks[mark_ + 1];
    const double share = seconds(now - times_[mark_]) / seconds(times_[mark_ + 1] - times_[mark_]);
    now_ = {std::lerp(now_.along_m, next.along_m, share),
            std::lerp(now_.driven_m, next.driven_m, share),
            std::lerp(now_.time_s, next.time_s, share),
            std::lerp(now_.energy_j, next.energy_j, share)};
  }
  find_place();
}

void ForeseenDrive::find_place() {
  const Path3& line_S_m = estimate_.line_S_m;
  p_S_m_ = line_S_m.back();
  if (line_S_m.size() < 2) return;
  const auto beyond = std::upper_bound(to_point_m_.begin(), to_point_m_.end(), now_.along_m);
  point_ = static_cast<std::size_t>(beyond - to_point_m_.begin()) - 1;
  // The end belongs to the last piece that has a length.
  std::size_t from = std::min(point_, line_S_m.size() - 2);
  while (from > 0 && to_point_m_[from + 1] <= to_point_m_[from]) --from;
  const Vec3 piece_m = line_S_m[from + 1] - line_S_m[from];
  const double length_m = to_point_m_[from + 1] - to_point_m_[from];
  if (length_m <= 0) return;
  const double share = std::clamp((now_.along_m - to_point_m_[from]) / length_m, 0.0, 1.0);
  p_S_m_ = line_S_m[from] + share * piece_m;
  const auto passed =
      std::ranges::count_if(estimate_.gear_changes, [&](std::size_t at) { return at <= from; });
  is_backward_ = passed % 2 == 1;
  if (now_.time_s <= 0) return;
  ahead_S_ = (is_backward_ ? -1 : 1) * piece_m.head<2>() / length_m;
}

double ForeseenDrive::power_w() const {
  if (has_ended()) return 0;
  const double used_j = estimate_.marks[mark_ + 1].energy_j - estimate_.marks[mark_].energy_j;
  return used_j / seconds(times_[mark_ + 1] - times_[mark_]);
}

DriveDoubt ForeseenDrive::doubt() const {
  const DriveSlack& slack = estimate_.slack;
  return {now_.time_s * (1 - slack.time_low), now_.time_s * (slack.time_high - 1),
          now_.energy_j * (1 - slack.energy_low), now_.energy_j * (slack.energy_high - 1),
          now_.energy_j};
}

double ForeseenDrive::speed_mps() const {
  if (has_ended()) return 0;
  const double driven_m = estimate_.marks[mark_ + 1].driven_m - estimate_.marks[mark_].driven_m;
  return driven_m / seconds(times_[mark_ + 1] - times_[mark_]);
}

std::size_t ForeseenDrive::next_point() const {
  const auto next = std::min(point_ + 1, estimate_.line_S_m.size() - 1);
  return static_cast<std::size_t>(
      std::max<std::ptrdiff_t>(0, static_cast<std::ptrdiff_t>(next) - estimate_.path_begins_at));
}

Path3 ForeseenDrive::line_ahead_S_m() const {
  Path3 line_S_m{p_S_m_};
  line_S_m.insert(line_S_m.end(),
                  estimate_.line_S_m.begin() +
                      static_cast<std::ptrdiff_t>(std::min(point_ + 1, estimate_.line_S_m.size())),
                  estimate_.line_S_m.end());
  return line_S_m;
}

}  // namespace lsos
