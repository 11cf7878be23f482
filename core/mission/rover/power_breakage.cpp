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

bool RoverPower::is_sound() const {
  const auto is_share = [](double share) { return share >= 0 && share <= 1; };
  const bool has_source =
      claims_.plugged_into.empty() ||
      std::ranges::find(sources_, claims_.plugged_into, &PowerSource::asset_id) != sources_.end();
  const std::size_t panels = spec_.panels.size();
  return has_source && panels_lost_.size() == panels && (!sun_ || sun_->panels.size() == panels) &&
         is_share(capacity_lost_) && is_share(sun_share_) &&
         std::ranges::all_of(panels_lost_, is_share);
}

}  // namespace lsos
