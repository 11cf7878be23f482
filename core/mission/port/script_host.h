// The interface between the engine and the scripts. The engine knows events by type and phase name
// only; it never sees Lua, and tests put a scripted mock here.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "base/archive.h"
#include "base/vector.h"
#include "mission/port/rover_port.h"
#include "plan/declaration.h"
#include "record/rows.h"

namespace lsos {

// Arguments of an event: parameters in SI by script key, and its waypoints on the ground (site
// frame). An optional parameter that the plan leaves out is absent.
struct EventArguments {
  std::map<std::string, FieldValue> params;
  Path3 geometry_S_m;
  std::vector<Path3> holes_S_m = {};  // holes of a polygon

  void archive(Archive& a);
};

// Results that a phase returns.
struct Stay {};  // the phase is called again at the next exchange
struct GoTo {
  std::string phase;
};               // the event goes on in that phase, at this exchange
struct Done {};  // the event is completed
struct Fail {
  std::string reason;
};  // the event has failed
struct SleepUntil {
  SimTime time;
};                // the phase is not called before then
struct Arrival {  // the phase is called when the drive has ended, or then
  std::optional<SimTime> latest = {};
};
struct RunEvent {  // this phase is another event; then `next` ("": done)
  std::string type;
  EventArguments arguments;
  std::string next;
};
using PhaseAnswer = std::variant<Stay, GoTo, Done, Fail, SleepUntil, Arrival, RunEvent>;

// Error in a script, as opposed to an event that fails: a line with script and cause, one with the
// plan's line and the rover's state, then the traceback. It fails the event.
class ScriptError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// What a phase call may read and command beside its own state.
struct PhaseContext {
  RoverPort& rover;
  SimTime now{};
  SimTime phase_start{};  // when this phase was entered
  SimTime event_start{};
  Instant mission_start{};
  std::uint64_t seed = 0;
  std::string rover_id;
  std::int64_t sequence = 0;
  std::string label;
  std::int64_t script_number = 0;  // which of the plan event's scripts; keys its random numbers
  Place place = {};                // place of the event in the plan
};

using ScriptInstance = std::int64_t;  // an event that runs; ids are never used twice

class ScriptHost {
 public:
  virtual ~ScriptHost() = default;

  virtual const Declarations& declarations() const = 0;

  // Settings of the routes of an event with these arguments, when it plans them ahead; absent: it
  // plans none. Throws ScriptError.
  virtual std::optional<RouteSettings> route_settings(const std::string& type,
                                                      const EventArguments& arguments,
                                                      Instant mission_start) {
    (void)type, (void)arguments, (void)mission_start;
    return std::nullopt;
  }
  // Whether an event with these arguments ends only by something that none of its fields says, and
  // whether it waits for sunlight on its rover's panels. Throws ScriptError.
  virtual bool is_open_ended(const std::string& type, const EventArguments& arguments,
                             Instant mission_start) {
    (void)type, (void)arguments, (void)mission_start;
    return false;
  }
  virtual bool awaits_sunlight(const std::string& type, const EventArguments& arguments,
                               Instant mission_start) {
    (void)type, (void)arguments, (void)mission_start;
    return false;
  }
  // Whether a condition of the plan holds for a rover. Its quantities are those of the row, NaN for
  // one that is not modelled. Throws ScriptError.
  virtual bool holds(const std::string& condition, const SampleRow& row, const RoverPort& rover) {
    (void)condition, (void)row, (void)rover;
    return false;
  }
  // Values of the quantities that a condition names: "charge was 0.93, distance_to('B') was 210";
  // "" when it names none.
  virtual std::string values_in(const std::string& condition, const SampleRow& row,
                                const RoverPort& rover) {
    (void)condition, (void)row, (void)rover;
    return "";
  }
  // Begins an event: ev.state is empty, ev.params and ev.geometry are the arguments.
  virtual ScriptInstance begin(const std::string& type, const EventArguments& arguments) = 0;
  // Throws ScriptError.
  virtual PhaseAnswer run_phase(ScriptInstance instance, const std::string& phase,
                                PhaseContext& context) = 0;
  // Calls on_abort, if the script has one: the event ends from outside. Returns the progress that
  // the script reports, "" when it reports none.
  virtual std::string run_abort(ScriptInstance instance, PhaseContext& context) = 0;
  virtual void end(ScriptInstance instance) = 0;

  // Serialises ev.state, and restores it into an event that has just begun. Throws ScriptError,
  // naming the key, for what cannot be saved.
  virtual std::string save(ScriptInstance instance) = 0;
  virtual void restore(ScriptInstance instance, const std::string& bytes) = 0;
};

}  // namespace lsos
