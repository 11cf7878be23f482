// The track that a rover has driven: where it has been, thinned to corners.
#pragma once

#include <cstddef>
#include <vector>

#include "base/archive.h"
#include "base/vector.h"

namespace lsos {

// A polyline in the horizontal plane of S. It ends where the rover is now; what lies farther back
// than `kept_m` is forgotten. Each place that the rover passed lies within `deviation_m` of it.
class DrivenTrack {
 public:
  static constexpr double step_m = 0.2;  // places are recorded after so much motion
  static constexpr double deviation_m = 0.2;
  static constexpr double piece_max_m = 10;
  static constexpr double kept_m = 5000;

  // Records where the rover is; called at each exchange.
  void add(const Vec2& p_S_m);

  bool is_empty() const { return corners_.empty(); }
  // Its end, where the rover was last recorded to be.
  const Vec2& here_S_m() const { return here_S_m_; }
  // Number of corners since the beginning, forgotten ones too.
  std::size_t corner_count() const { return forgotten_ + corners_.size(); }
  // The corners from number `first` on, counted from 0; forgotten ones are left out.
  std::vector<Vec2> corners_from(std::size_t first) const;

  // A place on the track.
  struct Entry {
    Vec2 p_S_m = Vec2::Zero();
    std::size_t next_corner = 0;  // number of the first corner behind it, or corner_count()
    double to_here_m = 0;         // along the track, from the place to its end
  };
  // The place nearest to a point; of several the latest. The track must not be empty.
  Entry nearest(const Vec2& p_S_m) const;

  void archive(Archive& a) {
    LSOS_ARCHIVE(a, corners_, lengths_m_, passed_, here_S_m_, forgotten_);
  }
  bool is_sound() const;

 private:
  void thin();
  void add_corner(const Vec2& p_S_m);

  std::vector<Vec2> corners_;
  std::vector<double> lengths_m_;  // of each corner along the track, from its beginning
  std::vector<Vec2> passed_;       // places recorded since the last corner
  Vec2 here_S_m_ = Vec2::Zero();
  std::size_t forgotten_ = 0;  // corners
};

}  // namespace lsos
