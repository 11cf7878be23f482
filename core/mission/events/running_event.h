// One event of the plan while its scripts run: its phases, the inner events that phases run, and
// when it must be called again.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mission/events/turn.h"

namespace lsos {

class RunningEvent {
 public:
  enum class Progress { waits, goes_on, completed, failed };

  // At one exchange; more means an endless loop.
  static constexpr int phase_changes_max = 100;

  explicit RunningEvent(const PlanEvent& event);  // to be read from an archive
  // `is_beside`: it runs beside the event whose turn it is, and leaves alone what that commanded.
  RunningEvent(const PlanEvent& event, const EventArguments& arguments, const Turn& turn,
               bool is_beside = false);

  // Whether the script is due now.
  bool is_due(const Turn& turn) const;
  // Calls the present phase once. `goes_on`: another call is due at this exchange. After
  // `completed` and `failed` (with the reason) no script runs any more.
  Progress call(const Turn& turn);
  // Ends the event from outside, innermost first: each script may clean up and report its progress.
  struct Ending {
    std::vector<std::string> faults;  // errors of scripts while cleaning up
    std::string state;                // "charge was 0.42, UntilCharge is 0.8"; "": not reported
  };
  Ending abort(const Turn& turn);

  // When it is due even if nothing else happens; nullopt: only at an arrival.
  std::optional<SimTime> wake(SimTime now) const;
  const std::string& reason() const { return reason_; }
  // Phase of the plan's event, not of inner events.
  const std::string& phase() const { return frames_.front().phase; }
  SimTime phase_start() const { return frames_.front().phase_start; }
  // What is wrong after too many changes of phase at one exchange, with its place in the script.
  std::string endless_text(const ScriptHost& host) const;
  // Warning since the last call about a likely omission in the script; else "".
  std::string take_advice() { return std::exchange(advice_, ""); }
  // The phases that have ended since the last call.
  std::vector<PhaseRow> take_phases();

  // Scripts are saved through `host`; when reading, they are begun again in it.
  void archive(Archive& a, ScriptHost& host);

 private:
  struct Frame {
    std::string type;
    EventArguments arguments;
    std::string phase;
    std::string next;  // phase of the frame below, entered when this one is done
    SimTime start{}, phase_start{};
    std::int64_t number = 0;  // index of the script in the plan event, in order of beginning
    PowerClaims outer;        // claims of the frame below, kept while this one runs

    ScriptInstance instance = 0;  // not saved: begun again
  };
  enum class Wake { next_exchange, at_time, arrival };
  friend constexpr Wake last_value(Wake) { return Wake::arrival; }

  PhaseContext context(const Turn& turn) const;
  Progress fail(const std::string& reason, const Turn& turn);
  Progress wait(const PhaseAnswer& answer, const Turn& turn);
  Progress go_on(const PhaseAnswer& answer, const Turn& turn);
  void enter_phase(const std::string& phase, SimTime now);
  void push(const std::string& type, const EventArguments& arguments, const std::string& next,
            const Turn& turn);
  void pop(const Turn& turn);
  void end_phase(SimTime now);

  std::string rover_id_, label_;
  std::int64_t sequence_ = 0;
  Place place_;                // in the plan
  bool is_beside_ = false;     // not saved: such an event ends in the exchange in which it begins
  std::int64_t begun_ = 0;     // number of scripts begun so far
  std::vector<Frame> frames_;  // the plan's event first
  Wake wake_ = Wake::next_exchange;
  SimTime wake_at_{};
  std::optional<SimTime> latest_;  // when it is due although the drive goes on
  std::string reason_, advice_;
  std::vector<PhaseRow> phases_;
};

}  // namespace lsos
