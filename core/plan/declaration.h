// What scripts declare about themselves, as plain values: the fields that a plan may give them.
// The plan reader checks Placemarks against these; where they come from (Lua) it does not know.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "base/error.h"
#include "base/units.h"
#include "planet/utc.h"

namespace lsos {

// No duration may be longer, some 27 years: times stay far inside what SimTime can hold.
inline constexpr double longest_duration_s = 10000 * 86400.0;

enum class FieldKind { number, integer, boolean, text, choice, duration, utc };

// What a text names: checked before anything runs.
enum class NameOf {
  anything,
  panel,           // of the event's rover
  stowable_panel,  // likewise; absent: all that it has
  turning_panel,   // likewise; absent: all that it has
  resource,        // of the event's rover
  antenna,         // of the event's rover, that can be stowed; absent: all that it has
  power_source,    // an asset of the plan that has power to give
  other,           // another rover of the plan, or an asset
};

// A value of a field, in SI. Durations are numbers (seconds).
using FieldValue = std::variant<bool, std::int64_t, double, std::string, Instant>;

// One SimpleData field of an event type.
struct FieldDeclaration {
  std::string name;  // in the plan: "Speed"
  std::string key;   // in the script, with its SI suffix: "speed_mps"
  FieldKind kind = FieldKind::text;
  std::string doc;
  const Unit* unit = nullptr;        // of a bare number (number and duration only)
  std::optional<double> min_si;      // inclusive
  std::optional<double> max_si;      // inclusive
  std::vector<std::string> choices;  // choice only
  NameOf names = NameOf::anything;   // text only
  std::string amount_of;             // number only: key of the text that names the resource used up
  bool is_required = false;
  std::optional<FieldValue> default_value;  // absent: the script sees nil
  std::string example = {};  // what a form has for it, when that is more than the default
};

enum class GeometryKind { none, point, line, polygon };

// One event type: the script events/NAME.lua.
struct EventDeclaration {
  std::string name;
  std::string doc;
  Place place;                           // of the declaration in its script
  std::vector<FieldDeclaration> fields;  // without the common ones (common_event_fields)
  std::vector<GeometryKind> geometries;  // allowed; `none` among them: may have no geometry
  bool drives = false;                   // a Point means: drive there from where the rover is
  bool goes_on_without_power = false;    // also when the rover's battery is empty
  std::optional<bool> is_open_ended;     // no field says when it ends; absent: by its fields
  // Keys of texts that name a panel or an antenna, "" for none: which it deploys, which it stows,
  // and which must be deployed for it. A text that the plan leaves out names all that can be
  // stowed.
  std::string deploys, stows, needs_deployed;
  bool may_deploy_unsaid = false;  // its script commands panels or antennas in its phases
  std::string start_phase;
  struct Phase {
    std::string name;
    std::string sub_event;  // type of the event that this phase is; "" for a function
    std::string next;       // phase after the sub-event; "" when the event is then completed
    int line = 0;           // of the script
  };
  std::vector<Phase> phases;  // the start phase first, then by name
};

// What a plan can name.
struct Declarations {
  std::map<std::string, EventDeclaration> events;
  struct RoverType {
    std::string doc;
    bool is_asset = false;
    std::vector<std::string> configurations;  // what RoverConfig may name
  };
  std::map<std::string, RoverType> rover_types;
  std::vector<std::string> terrains;
  // Scripts that are there but cannot be used, with what is wrong in each. A plan that names one is
  // told that.
  std::map<std::string, std::vector<Fault>> broken_events, broken_rovers, broken_terrains;
};

// Enabled, StartTime, StartAfter, Timeout, OnFailure: what every event has beside its own.
const std::vector<FieldDeclaration>& common_event_fields();
// RoverId and Sequence: which event of which rover it is.
const std::vector<FieldDeclaration>& event_identity_fields();
// Fields of MissionInfo, Rover and Asset.
const std::vector<FieldDeclaration>& mission_fields();
const std::vector<FieldDeclaration>& rover_fields();
const std::vector<FieldDeclaration>& asset_fields();

// The fields that a Placemark of that NAME may have: MissionInfo, Rover, Asset or an event.
std::vector<std::span<const FieldDeclaration>> fields_of(const std::string& name,
                                                         const Declarations& declarations);

}  // namespace lsos
