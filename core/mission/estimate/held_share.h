// A condition that is looked at from time to time and holds in between. Of a rover that drives or
// turns its panels it has changed somewhere between two looks that differ: its share of the time
// then is a range.
#pragma once

#include <algorithm>

namespace lsos {

// Time for which a condition surely holds, and for which it perhaps does.
struct HeldSums {
  double surely_s = 0, perhaps_s = 0;
};

class HeldShare {
 public:
  // Time passes in which what was found last holds; `sums`: of the event under way.
  void pass(double passed_s, bool is_moving, HeldSums& sums) {
    // Until the moment that was looked at, it may be as it was before.
    const double before_s = std::min(passed_s, ahead_s_), after_s = passed_s - before_s;
    if (surely_) sums.surely_s += after_s + (was_surely_ ? before_s : 0);
    if (perhaps_) sums.perhaps_s += after_s;
    if (perhaps_ || was_perhaps_) sums.perhaps_s += before_s;
    ahead_s_ -= before_s;
    moved_s_ = is_moving ? moved_s_ + after_s : 0;
  }
  // What is found now. `is_anew`: it has been looked at again, though it may be the same;
  // `ahead_s`: it is what will be so long after now.
  void find(bool surely, bool perhaps, bool is_anew, double ahead_s, HeldSums& sums) {
    if (!is_anew && surely == surely_ && perhaps == perhaps_) return;
    if (surely_ && !surely) sums.surely_s -= moved_s_;
    if (!perhaps_ && perhaps) sums.perhaps_s += moved_s_;
    was_surely_ = has_looked_ ? surely_ : surely;
    was_perhaps_ = has_looked_ ? perhaps_ : perhaps;
    has_looked_ = true;
    surely_ = surely;
    perhaps_ = perhaps;
    moved_s_ = 0;
    ahead_s_ = ahead_s;
  }
  // An event ends; `sums`: its own. What the next look finds does not count for it any more: it may
  // have changed since the last one.
  void end_event(HeldSums& sums) {
    if (surely_) sums.surely_s -= moved_s_;
    if (!perhaps_) sums.perhaps_s += moved_s_;
    moved_s_ = 0;
  }

 private:
  bool has_looked_ = false;
  bool surely_ = false, perhaps_ = false;
  bool was_surely_ = false, was_perhaps_ = false;  // by the look before the last
  double moved_s_ = 0;                             // since the moment that was looked at last
  double ahead_s_ = 0;                             // until that moment
};

}  // namespace lsos
