// A condition that is looked at from time to time and holds in between. Of a rover that drives or
// turns its panels it has changed somewhere between two looks that differ: its share of the time
// then is a range.
#pragma once

namespace lsos {

// Time for which a condition surely holds, and for which it perhaps does.
struct HeldSums {
  double surely_s = 0, perhaps_s = 0;
};

class HeldShare {
 public:
  // Time passes in which what was found last holds; `sums`: of the event under way.
  void pass(double passed_s, bool is_moving, HeldSums& sums) {
    if (surely_) sums.surely_s += passed_s;
    if (perhaps_) sums.perhaps_s += passed_s;
    moved_s_ = is_moving ? moved_s_ + passed_s : 0;
  }
  // What is found now. `is_anew`: it has been looked at again, though it may be the same.
  void find(bool surely, bool perhaps, bool is_anew, HeldSums& sums) {
    if (!is_anew && surely == surely_ && perhaps == perhaps_) return;
    if (surely_ && !surely) sums.surely_s -= moved_s_;
    if (!perhaps_ && perhaps) sums.perhaps_s += moved_s_;
    surely_ = surely;
    perhaps_ = perhaps;
    moved_s_ = 0;
  }

 private:
  bool surely_ = false, perhaps_ = false;
  double moved_s_ = 0;  // since the last look
};

}  // namespace lsos
