// A rover's antennas: what a script says of them, and which are up.
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
  double deploy_s = 0;               // how long raising or lowering takes, and what it uses
  double deploy_w = 0;
  double power_w = 0;  // while it is up
  double range_max_m = std::numeric_limits<double>::infinity();
  bool reaches_earth = true;

  bool is_stowable() const { return stowed_p_B_m.has_value(); }
};

// The name of its mast in the log's layer `joints`, where it can be stowed.
std::string mast_joint(const AntennaSpec& antenna);
// What one that can be stowed looks like when it has come so far on its way up, frame B: a mast and
// a head.
std::vector<Shape> mast_shapes(const AntennaSpec& antenna, double extension_m);

// Those that can be stowed are so at the start. One on its way up is not up yet; one that is stowed
// is down at once.
class AntennaArray {
 public:
  AntennaArray() = default;
  explicit AntennaArray(std::vector<AntennaSpec> specs)
      : specs_(std::move(specs)), states_(specs_.size()) {}

  const std::vector<AntennaSpec>& specs() const { return specs_; }
  bool is_up(std::size_t i, SimTime now) const;
  // It is up, and so is its radio.
  bool has_link(std::size_t i, SimTime now) const { return !is_silent_ && is_up(i, now); }
  // The radio of all has failed, or works again; masts stay where they are.
  void set_silent(bool is_silent, SimTime now);
  // The first that is up; while none is, the first. There is at least one.
  std::size_t in_use(SimTime now) const;
  // Of the one in use, chassis axes.
  Vec3 p_B_m(SimTime now) const;
  // How far an antenna has come from where it is stowed to where it is up, m; 0 where it is fixed.
  double extension_m(std::size_t i, SimTime now) const;
  // Of all that can be stowed.
  std::vector<Shape> masts(SimTime now) const;
  // What all use, W.
  double power_w(SimTime now) const;

  // The antenna with that name, "" for all that can be stowed. Throws std::runtime_error: no such
  // antenna; EquipmentFault: it cannot be stowed.
  Deployment deploy(const std::string& name, bool up, std::optional<double> duration_s,
                    SimTime now);
  // When the next that moves arrives, after now.
  std::optional<SimTime> next_end(SimTime now) const;
  // Which one is in use, or whether it is up, may differ from before this exchange.
  bool has_changed(SimTime now) const;

  void archive(Archive& a);

 private:
  struct State {
    bool goes_up = false;
    double from = 0;                   // where it was when it was told, 1: up
    std::optional<SimTime> told, end;  // of its last motion

    double share_up(SimTime now) const;
    void archive(Archive& a) { a(goes_up)(from)(told)(end); }
  };
  std::vector<AntennaSpec> specs_;
  std::vector<State> states_;
  bool is_silent_ = false;
  std::optional<SimTime> silenced_;
};

}  // namespace lsos
