#include "power/panel_array.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"

namespace lsos {

namespace {

// Turns smaller than this do not justify running the motor.
constexpr double turn_least_rad = 1e-4;
// Greatest angle from the wanted direction at which a panel counts as facing it.
constexpr double miss_least_rad = 0.5 * std::numbers::pi / 180;

constexpr std::pair<SteerMode, const char*> steer_modes[] = {
    {SteerMode::fixed, "fixed"}, {SteerMode::point, "point"}, {SteerMode::track, "track"}};

// Direction in frame B of angles about the ground.
Vec3 direction_B(const PanelAngles& angles, const PanelSurroundings& around) {
  const Vec3 east_B = around.north_B.cross(around.up_B);
  return std::cos(angles.elevation_rad) * (std::cos(angles.azimuth_rad) * around.north_B +
                                           std::sin(angles.azimuth_rad) * east_B) +
         std::sin(angles.elevation_rad) * around.up_B;
}

// Inverse of direction_B.
PanelAngles angles_of(const Vec3& direction_B, const PanelSurroundings& around) {
  const Vec3 east_B = around.north_B.cross(around.up_B);
  return {std::atan2(direction_B.dot(east_B), direction_B.dot(around.north_B)),
          std::asin(std::clamp(direction_B.dot(around.up_B), -1.0, 1.0))};
}

}  // namespace

const char* to_string(SteerMode mode) {
  const auto* const found =
      std::ranges::find(steer_modes, mode, &std::pair<SteerMode, const char*>::first);
  LSOS_ASSERT(found != std::end(steer_modes));
  return found->second;
}

std::optional<SteerMode> steer_mode(std::string_view name) {
  for (const auto& [mode, known] : steer_modes) {
    if (known == name) return mode;
  }
  return {};
}

PanelArray::PanelArray(const std::vector<PanelSpec>& panels) : specs_(panels) {
  for (const PanelSpec& panel : specs_) {
    State state;
    state.goes_up = !panel.is_stowed;
    state.from = state.to = state.steering.angles = panel.rest;
    states_.push_back(state);
  }
}

bool PanelArray::is_up(std::size_t panel, SimTime now) const {
  return states_[panel].goes_up && now >= states_[panel].ready;
}

PanelAngles PanelArray::angles(std::size_t panel, SimTime now) const {
  const State& state = states_[panel];
  if (now >= state.turn_end) return state.to;
  return turned(specs_[panel], state.from, state.to, seconds(now - state.turn_start));
}

PanelPose PanelArray::pose_at(std::size_t panel, SimTime now) const {
  return pose(specs_[panel], angles(panel, now));
}

void PanelArray::begin(std::size_t panel, bool is_up, const PanelAngles& angles,
                       const Steering& steering) {
  State& state = states_[panel];
  state.goes_up = is_up;
  state.from = state.to = angles;
  state.steering = steering;
}

double PanelArray::deploy(std::size_t panel, bool up, std::optional<double> duration_s,
                          SimTime now) {
  State& state = states_[panel];
  state.steering = {SteerMode::fixed, specs_[panel].rest};  // ends what it followed before
  if (state.goes_up == up) return now >= state.ready ? 0 : seconds(state.ready - now);
  const SimTime takes =
      round_up_to_exchange(from_seconds(duration_s.value_or(specs_[panel].deploy_s)));
  state.goes_up = up;
  state.ready = now + takes;
  // A panel is stowed in its rest orientation and comes out in it.
  state.from = state.to = specs_[panel].rest;
  state.turn_start = state.turn_end = now;
  return seconds(takes);
}

void PanelArray::set_stuck(std::size_t panel, bool is_stuck, SimTime now) {
  State& state = states_[panel];
  state.is_stuck = is_stuck;
  if (!is_stuck) return;
  // A panel that is stuck while deploying never becomes usable.
  if (state.goes_up && now < state.ready) state.goes_up = false;
  state.from = state.to = angles(panel, now);
  state.turn_start = state.turn_end = state.ready = now;
}

void PanelArray::steer(std::size_t panel, const Steering& steering) {
  states_[panel].steering = steering;
}

std::vector<PanelMiss> PanelArray::misses(SimTime now) const {
  std::vector<PanelMiss> misses;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const State& state = states_[i];
    if (!is_up(i, now) || !specs_[i].can_turn() || now < state.turn_end) continue;
    const bool tracks = state.steering.mode == SteerMode::track;
    if (tracks && !(state.is_stuck && around_.is_sun_up)) continue;
    const PanelAngles wanted = tracks ? angles_of(around_.sun_B, around_) : state.steering.angles;
    const bool is_of_ground = state.steering.mode != SteerMode::fixed;
    const Vec3 wanted_B =
        is_of_ground ? direction_B(wanted, around_) : pose(specs_[i], wanted).normal_B();
    const Vec3 faced_B = pose_at(i, now).normal_B();
    const double off_rad = std::atan2(faced_B.cross(wanted_B).norm(), faced_B.dot(wanted_B));
    if (off_rad <= miss_least_rad) continue;
    misses.push_back({specs_[i].name, state.steering.mode,
                      is_of_ground ? angles_of(faced_B, around_) : angles(i, now), wanted, off_rad,
                      state.is_stuck});
  }
  return misses;
}

void PanelArray::aim(const PanelSurroundings& around, SimTime now) {
  around_ = around;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    State& state = states_[i];
    const PanelSpec& spec = specs_[i];
    if (!is_up(i, now) || !spec.can_turn() || state.is_stuck) continue;
    const PanelAngles at = angles(i, now);
    PanelAngles to = state.to;
    switch (state.steering.mode) {
      case SteerMode::fixed:
        to = limited(spec, state.steering.angles);
        break;
      case SteerMode::point:
        to = facing(spec, at, direction_B(state.steering.angles, around));
        break;
      case SteerMode::track:
        if (around.is_sun_up) to = facing(spec, at, around.sun_B);
        break;
    }
    const double takes_s = turn_s(spec, at, to);
    if (takes_s * spec.rate_radps < turn_least_rad) continue;
    state.from = at;
    state.to = to;
    state.turn_start = now;
    state.turn_end = now + round_up_to_exchange(from_seconds(takes_s));
  }
}

bool PanelArray::is_turning(SimTime now) const {
  return std::ranges::any_of(states_, [&](const State& state) { return now < state.turn_end; });
}

std::optional<SimTime> PanelArray::next_end(SimTime now) const {
  std::optional<SimTime> next;
  for (const State& state : states_) {
    for (const SimTime end : {state.turn_end, state.ready}) {
      if (end > now) next = std::min(next.value_or(end), end);
    }
  }
  return next;
}

std::optional<SimTime> PanelArray::turn_end(SimTime now) const {
  std::optional<SimTime> last;
  for (const State& state : states_) {
    if (state.turn_end > now) last = std::max(last.value_or(now), state.turn_end);
  }
  return last;
}

std::optional<SimTime> PanelArray::last_end(SimTime now) const {
  std::optional<SimTime> last;
  for (const State& state : states_) {
    for (const SimTime end : {state.turn_end, state.ready}) {
      if (end <= now) last = std::max(last.value_or(end), end);
    }
  }
  return last;
}

double PanelArray::motors_w(SimTime now) const {
  double sum_w = 0;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (now < states_[i].turn_end) sum_w += specs_[i].motor_w;
    if (now < states_[i].ready) sum_w += specs_[i].deploy_w;
  }
  return sum_w;
}

}  // namespace lsos
