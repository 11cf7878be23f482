#include "mission/events/condition_watch.h"

#include <fmt/format.h>

#include <utility>

#include "base/moment_text.h"
#include "mission/events/awaited.h"
#include "mission/port/note_json.h"
#include "mission/rover/rover_rows.h"

namespace lsos {

void ConditionWatch::observe(const PlanEvent& event, const std::string& phase, bool is_first,
                             const Turn& turn) {
  const PlanEvent::Condition& condition = event.warn_when;
  if (condition.text.empty() || is_faulty_ || !is_condition_due(is_first, turn.now)) return;
  std::string fault;
  const bool does_hold = lsos::holds("WarnWhen", condition, event, phase, turn, fault);
  const bool did_hold = std::exchange(holds_, does_hold);
  is_faulty_ = !fault.empty();
  RoverJournal& journal = turn.agent.journal();
  if (is_faulty_) journal.warn(fault);
  if (did_hold || !does_hold) return;
  journal.set_sequence(event.sequence);
  turn.agent.note("warn_when", fmt::format(R"({{"condition":{},"event":{}}})",
                                           note_json(condition.text), note_json(event.label)));
  const std::string values = turn.host.values_in(
      condition.text, condition_row(turn.agent, turn.now, event.label, phase), turn.agent);
  journal.warn(fmt::format("{}: at {} WarnWhen of {} '{}' begins to hold: {}{}{}",
                           journal.rover_id(), moment_text(turn.now), event.type, event.label,
                           condition.text, values.empty() ? "" : "; ", values));
}

}  // namespace lsos
