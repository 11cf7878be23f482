#include "lua/host/phase_failure.h"

#include <fmt/format.h>

#include "base/units.h"

namespace lsos {

namespace {

const char* status_name(DriveState::Status status) {
  switch (status) {
    case DriveState::Status::none:
      return "no drive yet";
    case DriveState::Status::driving:
      return "driving";
    case DriveState::Status::arrived:
      return "arrived";
    case DriveState::Status::failed:
      return "drive failed";
  }
  return "";
}

}  // namespace

std::string state_text(RoverPort& rover) {
  const RoverView& view = rover.view();
  const PowerView power = rover.power().view();
  std::string text = fmt::format(
      "{:.1f} m east, {:.1f} m north of the site, heading {:.1f} deg, {:.2f} m/s, slope {:.1f} "
      "deg, "
      "{:.1f} m driven, {}",
      view.p_S_m.x(), view.p_S_m.y(), degrees(view.heading_rad), view.speed_mps,
      degrees(view.slope_rad), view.distance_m, status_name(rover.drive_state().status));
  if (power.has_battery) text += fmt::format(", charge {:.1f} %", power.charge * 100);
  return text;
}

std::string phase_failure(const LuaFailure& failure, const EventScript& script,
                          const std::string& where, const PhaseContext& context) {
  const auto [place, what] = split_place(failure.message, script.file);
  const std::string cause =
      to_string({Severity::error, place,
                 fmt::format("{} '{}' in {} at {} s: {}", script.declaration.name, context.label,
                             where, seconds(context.now), what)});
  const std::string state =
      to_string({Severity::error, context.place,
                 fmt::format("rover {}: {}", context.rover_id, state_text(context.rover))});
  return fmt::format("{}\n  {}{}{}", cause, state, failure.traceback.empty() ? "" : "\n",
                     failure.traceback);
}

}  // namespace lsos
