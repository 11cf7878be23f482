// What names an event: its label, or ROVER/SEQUENCE.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "plan/plan.h"

namespace lsos {

// "SEV1/20".
std::string reference_text(const PlanEvent::Reference& reference);
inline PlanEvent::Reference reference_to(const PlanEvent& event) {
  return {event.rover_id, event.sequence};
}

// The events of a plan by name. The plan must outlive it.
class EventNames {
 public:
  explicit EventNames(const Plan& plan);

  const PlanEvent& at(const PlanEvent::Reference& reference) const {
    return *by_reference_.at(reference);
  }
  // The one with ROVER/SEQUENCE; nullptr where the text is none of an event.
  const PlanEvent* identified(std::string_view text) const;
  // All events that a text may mean, as a label or as ROVER/SEQUENCE, each once.
  std::vector<const PlanEvent*> meanings(const std::string& text) const;
  // The one event that an option means, of that rover alone unless `rover_id` is "". Throws
  // InputError where there is none, or several.
  const PlanEvent& named(const std::string& option, const std::string& text,
                         const std::string& rover_id) const;
  int count(const std::string& label) const { return static_cast<int>(by_label_.count(label)); }

 private:
  std::multimap<std::string, const PlanEvent*> by_label_;
  std::map<PlanEvent::Reference, const PlanEvent*> by_reference_;
};

}  // namespace lsos
