// What breaks of a rover's battery and panels.
#include <algorithm>

#include "base/error.h"
#include "mission/rover/rover_power.h"

namespace lsos {

void RoverPower::set_panel_stuck(std::size_t panel, bool is_stuck, SimTime from) {
  panels_.set_stuck(panel, is_stuck, now_);
  has_panel_command_ = true;
  injected_at_ = from;
}

void RoverPower::set_panel_lost(std::size_t panel, double share, SimTime from) {
  panels_lost_[panel] = share;
  has_panel_command_ = true;
  injected_at_ = from;
}

void RoverPower::set_capacity_lost(double share) {
  LSOS_ASSERT(has_battery());
  begin_segment();
  capacity_lost_ = share;
  spec_.battery->capacity_j = capacity_at_first_j_ * (1 - share);
  at_start_ = with_energy(at_start_, std::min(at_start_.energy_j, spec_.battery->capacity_j));
}

}  // namespace lsos
