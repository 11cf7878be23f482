// What scripts declare about themselves, as plain values: the fields that a plan may give them.
// The plan reader checks Placemarks against these and does not depend on Lua, where they come from.
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

// Greatest duration that a field may have, some 27 years: times stay far inside SimTime's range.
inline constexpr double longest_duration_s = 10000 * 86400.0;

// A moment is a UTC time, or a duration from the mission's start.
enum class FieldKind { number, integer, boolean, text, choice, duration, utc, moment };

// What a text field names. Names are checked before anything runs.
enum class NameOf {
  anything,
  panel,           // a panel of the event's rover
  stowable_panel,  // a panel of the rover that can be stowed; absent: all of them
  turning_panel,   // a panel of the rover that can be turned; absent: all of them
  resource,        // a resource of the event's rover
  antenna,         // an antenna of the rover that can be stowed; absent: all of them
  stance,          // a stance of a rover on limbs
  power_source,    // an asset of the plan that supplies power
  other,           // another rover of the plan, or an asset
  leader,          // another rover of the plan, which the event's rover follows
};

// What the engine reads a number of an event for, before and beside its script.
enum class NumberRole {
  none,
  drive_speed,         // speed that a drive requests
  arrival_radius,      // distance from its target within which a drive has arrived
  outside_power,       // power requested from outside the rover or from a power source
  following_distance,  // that is kept to another rover which is followed
};

// A value of a field, in SI. Durations are numbers (seconds), also those from the mission's start.
using FieldValue = std::variant<bool, std::int64_t, double, std::string, Instant>;

// One SimpleData field of an event type.
struct FieldDeclaration {
  std::string name;  // in the plan: "Speed"
  std::string key;   // in the script, with its SI suffix: "speed_mps"
  FieldKind kind = FieldKind::text;
  std::string doc;
  const Unit* unit = nullptr;          // unit of a bare number (number and duration only)
  std::optional<double> min_si;        // inclusive
  std::optional<double> max_si;        // inclusive
  std::vector<std::string> choices;    // choice only
  NameOf names = NameOf::anything;     // text only
  NumberRole role = NumberRole::none;  // number only; no two of an event have the same
  std::string amount_of;  // number only: key of the text that names the resource used up
  bool is_required = false;
  std::optional<FieldValue> default_value;  // absent: the script sees nil
  std::string example = {};                 // value that a form shows; "": the default
};

enum class GeometryKind { none, point, line, polygon };

// What an event mostly is. Plots give each a colour.
enum class Activity { none, driving, waiting, energy, communication, crew, science };

// One event type: the script events/NAME.lua.
struct EventDeclaration {
  std::string name;
  std::string doc;
  Place place;                           // where its script declares it
  std::vector<FieldDeclaration> fields;  // without the common ones (common_event_fields)
  std::vector<GeometryKind> geometries;  // allowed; `none` among them: may have no geometry
  Activity activity = Activity::none;
  bool drives = false;                 // the rover drives to a Point from where it stands
  bool goes_on_without_power = false;  // it runs on when the rover's battery is empty
  std::optional<bool> is_open_ended;   // no field gives its end; absent: its fields decide
  // Keys of the text fields that name the panel or antenna that the event deploys, stows, or needs
  // deployed; "" for none. A field that the plan omits stands for all that can be stowed.
  std::string deploys, stows, needs_deployed;
  // Key of the moment at which the event takes effect whatever the rover does; "": it has none. An
  // event with a value needs no turn, and must end in the exchange in which it begins.
  std::string at = {};
  bool may_deploy_unsaid = false;  // its script commands panels or antennas in its phases
  std::string start_phase;
  struct Phase {
    std::string name;
    std::string sub_event;  // type of the event that this phase runs; "" for a function
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
  // Scripts that exist but cannot be used, with the faults of each. They are reported for a plan
  // that names such a script.
  std::map<std::string, std::vector<Fault>> broken_events, broken_rovers, broken_terrains;
};

// Fields that every event has beside its own: Enabled, StartTime, StartAfter, StartWhen, SkipWhen,
// StopWhen, WarnWhen, Timeout and OnFailure.
const std::vector<FieldDeclaration>& common_event_fields();
// RoverId and Sequence, which identify an event.
const std::vector<FieldDeclaration>& event_identity_fields();
// Fields of MissionInfo, Rover and Asset.
const std::vector<FieldDeclaration>& mission_fields();
const std::vector<FieldDeclaration>& rover_fields();
const std::vector<FieldDeclaration>& asset_fields();

// The fields that a Placemark of that name may have: MissionInfo, Rover, Asset or an event type.
std::vector<std::span<const FieldDeclaration>> fields_of(const std::string& name,
                                                         const Declarations& declarations);

}  // namespace lsos
