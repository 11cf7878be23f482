#include "driving/driven_track.h"

#include <algorithm>
#include <limits>

#include "base/segment.h"

namespace lsos {

void DrivenTrack::add(const Vec2& p_S_m) {
  here_S_m_ = p_S_m;
  if (corners_.empty()) return add_corner(p_S_m);
  const Vec2& last_S_m = passed_.empty() ? corners_.back() : passed_.back();
  if ((p_S_m - last_S_m).norm() < step_m) return;
  passed_.push_back(p_S_m);
  thin();
}

// The place farthest from the straight piece to the last one becomes a corner when it is too far
// from it, as Douglas and Peucker divide a line; so corners lie where the rover has turned.
void DrivenTrack::thin() {
  const Vec2 &corner_S_m = corners_.back(), &last_S_m = passed_.back();
  const auto distance_m = [&](const Vec2& p_S_m) {
    return point_distance_m(corner_S_m, last_S_m, p_S_m);
  };
  auto farthest = std::ranges::max_element(passed_, {}, distance_m);
  if (distance_m(*farthest) <= deviation_m) {
    if ((last_S_m - corner_S_m).norm() < piece_max_m) return;
    farthest = passed_.end() - 1;
  }
  add_corner(Vec2(*farthest));
  passed_.erase(passed_.begin(), farthest + 1);
}

void DrivenTrack::add_corner(const Vec2& p_S_m) {
  const double before_m = corners_.empty() ? 0 : lengths_m_.back();
  const double length_m = corners_.empty() ? 0 : (p_S_m - corners_.back()).norm();
  corners_.push_back(p_S_m);
  lengths_m_.push_back(before_m + length_m);
  // They are forgotten many at a time, as that moves all others.
  if (lengths_m_.back() - lengths_m_.front() < 1.1 * kept_m) return;
  const auto kept = std::ranges::lower_bound(lengths_m_, lengths_m_.back() - kept_m);
  const auto count = kept - lengths_m_.begin();
  corners_.erase(corners_.begin(), corners_.begin() + count);
  lengths_m_.erase(lengths_m_.begin(), kept);
  forgotten_ += static_cast<std::size_t>(count);
}

std::vector<Vec2> DrivenTrack::corners_from(std::size_t first) const {
  const std::size_t skipped = first > forgotten_ ? first - forgotten_ : 0;
  if (skipped >= corners_.size()) return {};
  return {corners_.begin() + static_cast<std::ptrdiff_t>(skipped), corners_.end()};
}

DrivenTrack::Entry DrivenTrack::nearest(const Vec2& p_S_m) const {
  Entry nearest;
  const double length_m = lengths_m_.back() + (here_S_m_ - corners_.back()).norm();
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Vec2& end_S_m = i + 1 < corners_.size() ? corners_[i + 1] : here_S_m_;
    const Vec2 along_m = end_S_m - corners_[i];
    const double share = nearest_share(corners_[i], end_S_m, p_S_m);
    const Vec2 place_S_m = corners_[i] + share * along_m;
    const double distance_m = (p_S_m - place_S_m).norm();
    if (distance_m > least_m) continue;
    least_m = distance_m;
    nearest = {place_S_m, forgotten_ + i + 1, length_m - lengths_m_[i] - share * along_m.norm()};
  }
  return nearest;
}

bool DrivenTrack::is_sound() const {
  const auto is_place = [](const Vec2& p_S_m) { return p_S_m.allFinite(); };
  return lengths_m_.size() == corners_.size() && (!corners_.empty() || passed_.empty()) &&
         std::ranges::is_sorted(lengths_m_) && std::ranges::all_of(corners_, is_place) &&
         std::ranges::all_of(passed_, is_place) && is_place(here_S_m_) &&
         forgotten_ < (std::size_t{1} << 40);
}

}  // namespace lsos
