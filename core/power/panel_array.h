// The panels of one rover over time: deployed or stowed, and their rotation.
#pragma once

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "power/panel.h"

namespace lsos {

// How a panel is commanded. Azimuth is clockwise, elevation upwards.
enum class SteerMode {
  fixed,  // keeps angles relative to the rover
  point,  // keeps angles relative to the ground: from true north, above the horizon
  track,  // follows the Sun
};
constexpr SteerMode last_value(SteerMode) { return SteerMode::track; }
// "fixed", "point", "track".
const char* to_string(SteerMode mode);
std::optional<SteerMode> steer_mode(std::string_view name);

struct Steering {
  SteerMode mode = SteerMode::fixed;
  PanelAngles angles;  // used by fixed and point

  void archive(Archive& a) { LSOS_ARCHIVE(a, mode, angles); }
};

// Directions of the Sun and of the compass, frame B.
struct PanelSurroundings {
  Vec3 sun_B = Vec3::UnitZ();
  bool is_sun_up = false;
  Vec3 north_B = Vec3::UnitX(), up_B = Vec3::UnitZ();

  void archive(Archive& a) { LSOS_ARCHIVE(a, sun_B, is_sun_up, north_B, up_B); }
};

// A panel that does not face the commanded direction: it has stopped at a limit, or is stuck.
struct PanelMiss {
  std::string panel;
  SteerMode mode = SteerMode::fixed;
  PanelAngles reached, wanted;  // angles in the frame of the mode; track: about the ground
  double off_rad = 0;           // angle between the two directions
  bool is_stuck = false;
};

class PanelArray {
 public:
  explicit PanelArray(const std::vector<PanelSpec>& panels);

  const std::vector<PanelSpec>& specs() const { return specs_; }
  // Whether the panel is deployed. Stowed and half-deployed panels make no power and are not drawn.
  bool is_up(std::size_t panel, SimTime now) const;
  PanelAngles angles(std::size_t panel, SimTime now) const;
  PanelPose pose_at(std::size_t panel, SimTime now) const;
  bool is_stowed(std::size_t panel) const { return !states_[panel].goes_up; }
  // Whether any is deployed or being deployed.
  bool is_any_up() const { return std::ranges::any_of(states_, &State::goes_up); }

  // Sets how the panel begins a mission, at rest.
  void begin(std::size_t panel, bool is_up, const PanelAngles& angles, const Steering& steering);
  const Steering& steering(std::size_t panel) const { return states_[panel].steering; }
  // Deploys or stows the panel; returns how long that takes, s, 0 if it is in that state already.
  double deploy(std::size_t panel, bool up, std::optional<double> duration_s, SimTime now);
  void steer(std::size_t panel, const Steering& steering);
  // Panels that face more than half a degree away from the commanded direction once they have
  // turned. A panel that tracks the Sun is listed only when it is stuck: limits that keep it from
  // facing the Sun are no fault.
  std::vector<PanelMiss> misses(SimTime now) const;
  // Turns the deployed panels towards their commanded directions.
  void aim(const PanelSurroundings& surroundings, SimTime now);

  // A stuck panel (its motor has failed) keeps its present orientation whatever is commanded; false
  // makes it work again.
  void set_stuck(std::size_t panel, bool is_stuck, SimTime now);
  bool is_stuck(std::size_t panel) const { return states_[panel].is_stuck; }

  bool is_turning(SimTime now) const;  // whether any panel turns
  // When the next motion ends, a multiple of the exchange period; absent when nothing moves.
  std::optional<SimTime> next_end(SimTime now) const;
  // When the last of the turning panels arrives; absent when none turns.
  std::optional<SimTime> turn_end(SimTime now) const;
  // When the last motion ended; absent when none has.
  std::optional<SimTime> last_end(SimTime now) const;
  double motors_w(SimTime now) const;

  void archive(Archive& a) {
    a.tag("panels");
    LSOS_ARCHIVE(a, states_, around_);
  }
  bool is_sound() const { return states_.size() == specs_.size(); }

 private:
  struct State {
    bool goes_up = true;  // is deployed or being deployed
    bool is_stuck = false;
    SimTime ready{};  // when deploying or stowing ends
    PanelAngles from, to;
    SimTime turn_start{}, turn_end{};
    Steering steering;

    void archive(Archive& a) {
      LSOS_ARCHIVE(a, goes_up, is_stuck, ready, from, to, turn_start, turn_end, steering);
    }
  };

  std::vector<PanelSpec> specs_;
  std::vector<State> states_;
  PanelSurroundings around_;  // as of the last call of aim
};

}  // namespace lsos
