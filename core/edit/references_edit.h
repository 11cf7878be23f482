// Changes what StartAfter and OnFailure = goto of an edited plan name.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "edit/event_names.h"
#include "edit/plan_document.h"

namespace lsos {

// A reference to `target`, written as `text`.
struct EventReference {
  const PlanEvent& target;
  const std::string& text;
  bool is_goto = false;  // of OnFailure; else of StartAfter
};
// What a reference becomes; absent: it is left out.
using Rewording = std::function<std::optional<std::string>(const EventReference& reference)>;

// Rewords the references in the Placemark `mark`, which says what `event` does. A field without any
// reference left is erased. Returns what was left out: "StartAfter = SEV1/20".
std::vector<std::string> reword_references(PlanDocument& document, const PlanMark& mark,
                                           const PlanEvent& event, const EventNames& names,
                                           const Rewording& reword);

// What OnFailure of MissionInfo or a Rover goes to, as a label or ROVER/SEQUENCE; "" for nothing.
std::string goto_label(const std::string& on_failure);

// The same of the references by ROVER/SEQUENCE in OnFailure of MissionInfo and Rovers.
void reword_defaults(PlanDocument& document, const EventNames& names, const Rewording& reword);

// The events that OnFailure of MissionInfo or a Rover may go to by their label.
std::vector<const PlanEvent*> default_targets(const Plan& plan, const EventNames& names);

}  // namespace lsos
