// What breaks of a rover while it runs, and what is repaired.
#include <fmt/format.h>

#include "mission/port/equipment_fault.h"
#include "mission/rover/rover_agent.h"

namespace lsos {

namespace {

WheelMode wheel_mode(BreakageMode mode) {
  return mode == BreakageMode::locked ? WheelMode::locked : WheelMode::free;
}

}  // namespace

BreakageOfParts RoverAgent::resolved(const Breakage& breakage) const {
  Parsed<BreakageOfParts> result = resolve(breakage, breakable_parts_, "the rover");
  if (!result) throw EquipmentFault(result.why);
  return std::move(*result.value);
}

void RoverAgent::apply(const BreakageOfParts& breakage, SimTime from) {
  const bool breaks = !breakage.is_repair;
  Vehicle& vehicle = motion_.vehicle();
  for (const BreakablePart& part : breakage.parts) {
    const auto index = static_cast<std::size_t>(part.index);
    switch (breakage.breakable->what) {
      case Equipment::wheel:
        vehicle.set_wheel_mode(
            index, breaks ? wheel_mode(breakage.modes.front()) : vehicle.wheel_mode_at_rest(index));
        drive_.wake();  // what stood on that wheel's brake may roll
        break;
      case Equipment::steering:
        vehicle.set_steering_stuck(index, breaks);
        break;
      case Equipment::limb:
        vehicle.set_limb_locked(part.index, breaks);
        if (!breaks) drive_.wake();  // it goes on to what it could not reach
        break;
      case Equipment::antenna:
        antennas_.set_dead(index, breaks, from);
        break;
      case Equipment::battery:
        power_.set_capacity_lost(breaks ? breakage.share : 0);
        break;
      case Equipment::panel:
        for (const BreakageMode mode : breakage.modes) {
          if (mode == BreakageMode::stuck) power_.set_panel_stuck(index, breaks, from);
          if (mode == BreakageMode::dead) {
            power_.set_panel_lost(index, breaks ? breakage.share : 0, from);
          }
        }
        break;
    }
  }
}

void RoverAgent::break_part(const Breakage& breakage) {
  const BreakageOfParts of_parts = resolved(breakage);
  apply(of_parts, now_);
  journal_.note("fault", breakage_json(breakage, of_parts));
  if (breakage.is_repair) return;
  journal_.warn(fmt::format("{}: {}, from {:.6g} s on", rover_.id,
                            breakage_text(breakage, of_parts), seconds(now_)));
}

std::string RoverAgent::inject(const Breakage& breakage) {
  const BreakageOfParts of_parts = resolved(breakage);
  const bool was_parked = is_parked();
  apply(of_parts, now_ + exchange_period);
  if (was_parked && !is_parked()) power_.begin_motion();
  return breakage_json(breakage, of_parts);
}

void RoverAgent::inject_driven_wheel(const std::string& wheel) {
  const Breakage repair{.what = "wheel", .part = wheel, .share = {}, .is_repair = true};
  inject(repair);
  for (const BreakablePart& part : resolved(repair).parts) {
    motion_.vehicle().set_wheel_mode(static_cast<std::size_t>(part.index), WheelMode::driven);
  }
}

}  // namespace lsos
