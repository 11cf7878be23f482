// The end of a rover's events from outside.
#include <fmt/format.h>

#include "mission/events/awaited.h"
#include "mission/events/event_sequence.h"

namespace lsos {

std::string EventSequence::progress_until(const Turn& turn) {
  std::string text = fmt::format("in phase '{}' since {:.0f} s", running_->phase(),
                                 seconds(running_->phase_start()));
  const DriveState drive = turn.agent.drive_state();
  std::string state = abort(turn);
  if (state.empty() && drive.status == DriveState::Status::driving) {
    state = fmt::format("{:.0f} m are left to drive", drive.remaining_m);
  }
  return state.empty() ? text : text + "; " + state;
}

void EventSequence::stop(const Turn& turn, const std::string& why, bool is_failure) {
  stop_turns(turn, why, is_failure);
  records_.prevent_rest(turn.now, why, is_failure, true);
}

void EventSequence::stop_turns(const Turn& turn, const std::string& why, bool is_failure) {
  std::string reason = why, of_the_rest = why;
  if (has_turn_ && !is_failure) {
    of_the_rest += fmt::format("; its turn did not come, '{}' {}", event().label,
                               running_ ? "was under way" : "waited to start");
  }
  if (running_ && is_failure) {
    abort(turn);
  } else if (running_) {
    reason += ", " + progress_until(turn);
  } else if (has_turn_ && !is_failure) {
    const std::string awaited = awaited_text(event(), waits_for_charge_, turn);
    if (!awaited.empty()) reason += "; it waited for " + awaited;
  }
  if (has_turn_) {
    const bool has_started = current().start.has_value();
    current().is_prevented = is_failure && !has_started;
    end(has_started ? EventStatus::incomplete : EventStatus::not_started, reason, turn);
  }
  finish(turn.now, of_the_rest, is_failure);
}

}  // namespace lsos
