// A rover's antennas: their specifications in a script, and which are up.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/archive.h"
#include "base/shape.h"
#include "base/vector.h"
#include "mission/port/power_port.h"

namespace lsos {

struct AntennaSpec {
  std::string name;
  Vec3 p_B_m = Vec3::Zero();         // chassis axes, when up
  std::optional<Vec3> stowed_p_B_m;  // absent: it is always up
  double deploy_s = 0;               // time and power of raising or lowering it
  double deploy_w = 0;
  double power_w = 0;  // while it is up
  double range_max_m = std::numeric_limits<double>::infinity();
  bool reaches_earth = true;

  bool is_stowable() const { return stowed_p_B_m.has_value(); }
};

// Name of a stowable antenna's mast in the log's layer `joints`.
std::string mast_joint(const AntennaSpec& antenna);
// Shapes of a stowable antenna that is raised by `extension_m`, frame B: a mast and a head.
std::vector<Shape> mast_shapes(const AntennaSpec& antenna, double extension_m);

// Stowable antennas are stowed at the start. An antenna on its way up is not up yet; one that is
// being stowed is down at once.
class AntennaArray {
 public:
  AntennaArray() = default;
  explicit AntennaArray(std::vector<AntennaSpec> specs)
      : specs_(std::move(specs)), states_(specs_.size()) {}

  const std::vector<AntennaSpec>& specs() const { return specs_; }
  bool is_up(std::size_t i, SimTime now) const;
  // Sets whether a stowable antenna begins a mission raised.
  void begin(std::size_t i, bool is_up);
  // Whether it is up and its radio works.
  bool has_link(std::size_t i, SimTime now) const { return !states_[i].is_dead && is_up(i, now); }
  // Makes the radio of an antenna fail, or work again, from the exchange `from` on; its mast stays
  // where it is.
  void set_dead(std::size_t i, bool is_dead, SimTime from);
  // Index of the first antenna that is up and works; while none is, of the first that is up, else
  // of the first. There is at least one.
  std::size_t in_use(SimTime now) const;
  // Position of the antenna in use, chassis axes.
  Vec3 p_B_m(SimTime now) const;
  // How far an antenna is raised from its stowed position, m; 0 for a fixed one.
  double extension_m(std::size_t i, SimTime now) const;
  // Shapes of all stowable antennas.
  std::vector<Shape> masts(SimTime now) const;
  // Radius about the reference point that holds all stowable antennas, stowed and up.
  double mast_reach_m() const;
  // Power that all use, W.
  double power_w(SimTime now) const;

  // Raises or stows the antenna with that name, "" for all stowable ones. Throws std::runtime_error
  // when there is no such antenna, EquipmentFault when it cannot be stowed.
  Deployment deploy(const std::string& name, bool up, std::optional<double> duration_s,
                    SimTime now);
  // Next time after `now` at which a moving antenna arrives or the radio fails or recovers.
  std::optional<SimTime> next_end(SimTime now) const;
  // Whether the choice of the antenna in use, or its being up, may differ from before this
  // exchange.
  bool has_changed(SimTime now) const;

  void archive(Archive& a);
  bool is_sound() const { return states_.size() == specs_.size(); }

 private:
  struct State {
    bool goes_up = false;
    double from = 0;                    // share raised when its last motion began, 1: up
    std::optional<SimTime> start, end;  // start and end of its last motion
    bool is_dead = false;               // its radio has failed

    double share_up(SimTime now) const;
    void archive(Archive& a) { LSOS_ARCHIVE(a, goes_up, from, start, end, is_dead); }
  };
  std::vector<AntennaSpec> specs_;
  std::vector<State> states_;
  std::optional<SimTime> failed_;  // when a radio last failed or recovered
};

}  // namespace lsos
