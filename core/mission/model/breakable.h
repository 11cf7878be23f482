// What of a rover can break, and how: one table for events of a plan, scripts, scenarios and checks
// before the run.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "base/parsed.h"
#include "mission/model/antenna.h"
#include "mission/model/rover_model.h"
#include "mission/port/breakage.h"

namespace lsos {

enum class Equipment { wheel, steering, limb, antenna, battery, panel };
enum class BreakageMode { locked, free, stuck, dead, share_lost };

struct Breakable {
  struct Mode {
    const char* name;  // "": what breaks has no modes, and a share is lost
    BreakageMode mode;
  };
  Equipment what;
  const char* name;         // as plans have it
  const char* all;          // of a rover, as warnings say it
  std::vector<Mode> modes;  // the first when none is given
  bool has_share = false;   // of its last mode a share may be lost
};
std::span<const Breakable> breakables();

// A part that can break. A part of a limb is a joint of it, and has the limb's name besides.
struct BreakablePart {
  std::string name, group = {};
  int index = 0;  // wheels and steering joints in order of links, limb joints by link, others in
                  // order of the rover's script
};
using BreakableParts = std::map<Equipment, std::vector<BreakablePart>>;
// The parts of a rover. `config`: with its links. `antennas`: those that it really has.
BreakableParts breakable_parts(const VehicleConfig& config, const PowerSpec& power,
                               std::span<const AntennaSpec> antennas);
// The same of a rover that has not been made yet.
BreakableParts breakable_parts(const RoverModel& model, const std::string& configuration,
                               double gravity_mps2);

// The antennas of a rover: those of its script, or one on top of its shapes.
std::vector<AntennaSpec> antennas_of(const RoverModel& model, double top_m);

// What a breakage means for a rover with these parts.
struct BreakageOfParts {
  const Breakable* breakable = nullptr;
  std::vector<BreakageMode> modes;   // several: a repair of all
  std::vector<BreakablePart> parts;  // at least one
  double share = 1;                  // that is lost
  bool is_repair = false;
};
// `owner`: of the parts, as messages say it: "SEV", "the rover".
Parsed<BreakageOfParts> resolve(const Breakage& breakage, const BreakableParts& parts,
                                const std::string& owner);

// The breakage in words: "wheel 'front_left_wheel_1': locked", "battery: 30 % of its capacity
// lost".
std::string breakage_text(const Breakage& breakage, const BreakageOfParts& resolved);
// Fields of a note about it: a JSON object with sorted keys.
std::string breakage_json(const Breakage& breakage, const BreakageOfParts& resolved);

}  // namespace lsos
