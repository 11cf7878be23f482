#include "edit/renumber.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "edit/event_names.h"
#include "edit/references_edit.h"

namespace lsos {

namespace {

using Numbers = std::map<PlanEvent::Reference, std::int64_t>;

Numbers new_numbers(const Plan& plan, std::int64_t step, const std::string& rover_id) {
  Numbers numbers;
  std::map<std::string, std::int64_t> last;  // of each rover
  for (const PlanEvent& event : plan.events) {
    if (!rover_id.empty() && event.rover_id != rover_id) continue;
    const std::int64_t number = last[event.rover_id] += step;
    if (number != event.sequence) numbers[reference_to(event)] = number;
  }
  return numbers;
}

}  // namespace

int renumber(PlanDocument& document, std::int64_t step, const std::string& rover_id) {
  const Plan& plan = document.plan();
  const EventNames names(plan);
  const Numbers numbers = new_numbers(plan, step, rover_id);
  // OnFailure of a Rover or the mission names events by label alone, perhaps several: they keep it.
  for (const PlanEvent* event : default_targets(plan, names)) {
    const PlanMark& mark = document.mark(*event);
    if (!numbers.contains(reference_to(*event)) || !document.name(mark).empty()) continue;
    document.set_name(mark, event->label);
  }
  const Rewording follow = [&](const EventReference& reference) {
    const PlanEvent& target = reference.target;
    const auto number = numbers.find(reference_to(target));
    const bool is_by_name =
        reference.text == target.label && !document.name(document.mark(target)).empty();
    if (number == numbers.end() || is_by_name) return std::optional(reference.text);
    return std::optional(reference_text({target.rover_id, number->second}));
  };
  reword_defaults(document, names, follow);
  for (const PlanEvent& event : plan.events) {
    reword_references(document, document.mark(event), event, names, follow);
  }
  for (const auto& [reference, number] : numbers) {
    document.set_field(document.mark(names.at(reference)), "Sequence", std::to_string(number));
  }
  return static_cast<int>(numbers.size());
}

}  // namespace lsos
