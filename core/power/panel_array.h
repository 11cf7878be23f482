// The panels of one rover over time: up or down, and where they turn.
#pragma once

#include <optional>
#include <vector>

#include "power/panel.h"

namespace lsos {

// What a panel is told. Azimuth clockwise, elevation above.
enum class SteerMode {
  fixed,  // stays at angles about the rover
  point,  // stays at angles about the ground: from true north, above the horizon
  track,  // follows the Sun
};
struct Steering {
  SteerMode mode = SteerMode::fixed;
  PanelAngles angles;  // fixed and point

  void archive(Archive& a) { a(mode)(angles); }
};

// Which way the Sun and the compass lie, frame B.
struct PanelSurroundings {
  Vec3 sun_B = Vec3::UnitZ();
  bool is_sun_up = false;
  Vec3 north_B = Vec3::UnitX(), up_B = Vec3::UnitZ();

  void archive(Archive& a) { a(sun_B)(is_sun_up)(north_B)(up_B); }
};

// A panel that does not face where it was told: it has stopped at a limit, or is stuck.
struct PanelMiss {
  std::string panel;
  SteerMode mode = SteerMode::fixed;
  PanelAngles reached, wanted;  // as the mode counts them; track: about the ground
  double off_rad = 0;           // between the two directions
  bool is_stuck = false;
};

class PanelArray {
 public:
  explicit PanelArray(const std::vector<PanelSpec>& panels);

  const std::vector<PanelSpec>& specs() const { return specs_; }
  // Stowed and half-way ones make nothing and are not drawn.
  bool is_up(std::size_t panel, SimTime now) const;
  PanelAngles angles(std::size_t panel, SimTime now) const;
  PanelPose pose_at(std::size_t panel, SimTime now) const;
  bool is_stowed(std::size_t panel) const { return !states_[panel].goes_up; }

  // Puts it up or down; answers how long that takes, s, 0 when it is so already.
  double deploy(std::size_t panel, bool up, std::optional<double> duration_s, SimTime now);
  void steer(std::size_t panel, const Steering& steering);
  // Panels that face another way than asked by more than half a degree, once they have turned. One
  // that follows the Sun misses it only when it is stuck: its limits are no fault.
  std::vector<PanelMiss> misses(SimTime now) const;
  // Turns those that are up towards where they shall face.
  void aim(const PanelSurroundings& surroundings, SimTime now);

  // It stays as it is now, whatever it is told: a motor that has failed; or works again.
  void set_stuck(std::size_t panel, bool is_stuck, SimTime now);
  bool is_stuck(std::size_t panel) const { return states_[panel].is_stuck; }

  bool is_turning(SimTime now) const;  // any of them
  // When the next motion ends, at an exchange; absent when nothing moves.
  std::optional<SimTime> next_end(SimTime now) const;
  // When the last of those that turn arrives; absent when none turns.
  std::optional<SimTime> turn_end(SimTime now) const;
  // When the last motion ended.
  std::optional<SimTime> last_end(SimTime now) const;
  double motors_w(SimTime now) const;

  void archive(Archive& a) { a.tag("panels")(states_)(around_); }

 private:
  struct State {
    bool goes_up = true;  // or is
    bool is_stuck = false;
    SimTime ready{};  // when it is up or down
    PanelAngles from, to;
    SimTime turn_start{}, turn_end{};
    Steering steering;

    void archive(Archive& a) {
      a(goes_up)(is_stuck)(ready)(from)(to)(turn_start)(turn_end)(steering);
    }
  };

  std::vector<PanelSpec> specs_;
  std::vector<State> states_;
  PanelSurroundings around_;  // when they were last aimed
};

}  // namespace lsos
