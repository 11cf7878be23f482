#include "edit/event_names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/quantity.h"
#include "base/text.h"
#include "plan/suggestions.h"

namespace lsos {

std::string reference_text(const PlanEvent::Reference& reference) {
  return fmt::format("{}/{}", reference.rover_id, reference.sequence);
}

EventNames::EventNames(const Plan& plan) {
  for (const PlanEvent& event : plan.events) {
    by_label_.emplace(event.label, &event);
    by_reference_[reference_to(event)] = &event;
  }
}

const PlanEvent* EventNames::identified(std::string_view text) const {
  const std::size_t slash = text.rfind('/');
  if (slash == std::string_view::npos) return nullptr;
  const Parsed<std::int64_t> sequence = parse_integer(trimmed(text.substr(slash + 1)));
  if (!sequence) return nullptr;
  const auto found =
      by_reference_.find({std::string(trimmed(text.substr(0, slash))), *sequence.value});
  return found == by_reference_.end() ? nullptr : found->second;
}

std::vector<const PlanEvent*> EventNames::meanings(const std::string& text) const {
  std::vector<const PlanEvent*> found;
  const auto [first, last] = by_label_.equal_range(text);
  for (auto each = first; each != last; ++each) found.push_back(each->second);
  const PlanEvent* event = identified(text);
  if (event != nullptr && std::ranges::find(found, event) == found.end()) found.push_back(event);
  return found;
}

const PlanEvent& EventNames::named(const std::string& option, const std::string& text,
                                   const std::string& rover_id) const {
  std::vector<const PlanEvent*> found = meanings(text);
  std::erase_if(found, [&](const PlanEvent* event) {
    return !rover_id.empty() && event->rover_id != rover_id;
  });
  if (found.size() == 1) return *found.front();
  const std::string of = rover_id.empty() ? "" : fmt::format(" of rover {}", quoted(rover_id));
  if (found.empty()) {
    std::vector<std::string> known;
    for (const auto& [label, event] : by_label_) {
      if (rover_id.empty() || event->rover_id == rover_id) known.push_back(label);
    }
    throw InputError({}, fmt::format("{} {}: there is no event {}{}{}", option, text, quoted(text),
                                     of, Suggestions(std::move(known))(text)));
  }
  std::vector<std::string> choices;
  for (const PlanEvent* event : found) choices.push_back(reference_text(reference_to(*event)));
  throw InputError({}, fmt::format("{} {}: can be {}{}; ROVER/SEQUENCE says which", option, text,
                                   fmt::join(choices, ", "), of));
}

}  // namespace lsos
