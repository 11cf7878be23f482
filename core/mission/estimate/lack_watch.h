// Watches one rover of an estimate for stretches in which it lacks sunlight or contact, or in which
// WarnWhen holds. What is found at an exchange holds until the next.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mission/estimate/lack.h"
#include "mission/fleet/fleet.h"

namespace lsos {

// What a rover sees, as far as it is known.
struct RoverSees {
  bool is_dark = false;  // it has panels, and no Sun reaches one that is up
  bool is_earth = false;
};

class LackWatch {
 public:
  // `index`: of the rover in the fleet; `running`: of its event under way.
  void look(const Fleet& fleet, std::size_t index, std::optional<std::size_t> running,
            const RoverSees& sees, double now_s);
  // Those that matter, in the order of their ends; what lasts is taken to end now.
  std::vector<Lack> lacks(double now_s) const;

 private:
  struct Contact {
    Lack lack;
    bool is_made = false;
    double asked_s = 0;  // when it was looked for last
  };

  Lack begun(LackKind kind, const FleetRover& rover, double now_s) const;
  void look_for_sun(const FleetRover& rover, bool is_dark, double now_s);
  void look_for_energy(const FleetRover& rover, bool is_idle, double now_s);
  void look_for_contact(const Fleet& fleet, const FleetRover& rover, bool sees_earth, double now_s);
  void look_for_warnings(const FleetRover& rover, double now_s);
  static bool matters(const Lack& dark);
  static bool is_missed(const Contact& contact, double now_s);
  static void add(std::vector<Lack>& lacks, Lack lack, double end_s);

  std::size_t event_ = 0;  // the last that has begun
  std::optional<Lack> dark_, empty_, warned_;
  std::optional<Contact> contact_;
  std::vector<Lack> ended_;
};

}  // namespace lsos
