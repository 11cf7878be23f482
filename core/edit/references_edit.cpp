#include "edit/references_edit.h"

#include <fmt/format.h>

#include "base/replaced.h"
#include "base/text.h"
#include "plan/references.h"

namespace lsos {

namespace {

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) {
    text += (text.empty() ? "" : ", ") + replaced(part, ",", "\\,");
  }
  return text;
}

void write(PlanDocument& document, const PlanMark& mark, const char* name,
           const std::string& text) {
  if (text.empty()) {
    document.erase_field(mark, name);
  } else {
    document.set_field(mark, name, text);
  }
}

}  // namespace

std::string goto_label(const std::string& on_failure) {
  if (!on_failure.starts_with("goto ") && !on_failure.starts_with("goto\t")) return "";
  return replaced(std::string(trimmed(on_failure.substr(5))), "\\,", ",");
}

std::vector<std::string> reword_references(PlanDocument& document, const PlanMark& mark,
                                           const PlanEvent& event, const EventNames& names,
                                           const Rewording& reword) {
  std::vector<std::string> left_out;
  const std::string start_after = document.field(mark, "StartAfter");
  const std::vector<std::string> parts = split_references(start_after);
  std::vector<std::string> kept;
  for (const std::string& part : parts) {
    const std::vector<const PlanEvent*> targets = names.meanings(part);
    if (targets.size() != 1) continue;  // an empty field
    const std::optional<std::string> text = reword({*targets.front(), part});
    if (text) kept.push_back(*text);
    if (!text) left_out.push_back("StartAfter = " + part);
  }
  if (!start_after.empty() && kept != parts) write(document, mark, "StartAfter", joined(kept));

  const std::string label = goto_label(document.field(mark, "OnFailure"));
  if (label.empty()) return left_out;
  const PlanEvent& target = names.at({event.rover_id, event.go_to_sequence});
  const std::optional<std::string> text = reword({target, label, true});
  if (!text) left_out.push_back("OnFailure = goto " + label);
  if (text != label) write(document, mark, "OnFailure", text ? "goto " + *text : "");
  return left_out;
}

std::vector<const PlanEvent*> default_targets(const Plan& plan, const EventNames& names) {
  std::vector<const PlanEvent*> targets;
  const auto add = [&](const FailureDefault& on_failure) {
    const std::string label = goto_label(on_failure.text);
    if (label.empty()) return;
    for (const PlanEvent* event : names.meanings(label)) {
      if (event->label == label) targets.push_back(event);
    }
  };
  add(plan.mission.on_failure);
  for (const PlanRover& rover : plan.rovers) add(rover.on_failure);
  return targets;
}

void reword_defaults(PlanDocument& document, const EventNames& names, const Rewording& reword) {
  const auto follow = [&](const PlanMark& mark) {
    const std::string label = goto_label(document.field(mark, "OnFailure"));
    const PlanEvent* event = names.identified(label);
    if (event == nullptr || event->label == label) return;
    const std::optional<std::string> text = reword({*event, label, true});
    if (text && *text != label) document.set_field(mark, "OnFailure", "goto " + *text);
  };
  follow(document.mission());
  for (const PlanRover& rover : document.plan().rovers) follow(document.rover(rover.id));
}

}  // namespace lsos
