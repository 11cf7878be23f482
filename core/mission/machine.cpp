#include "mission/machine.h"

#include <fmt/format.h>

#include <algorithm>

namespace lsos {

MissionMachine synthesise(const Plan& plan, const Declarations& declarations) {
  MissionMachine machine;
  machine.mission = plan.mission;
  for (const PlanRover& rover : plan.rovers) machine.rovers.push_back({rover, {}});
  for (const PlanEvent& event : plan.events) {
    const auto owner = std::ranges::find_if(
        machine.rovers, [&](const RoverMachine& r) { return r.rover.id == event.rover_id; });
    LSOS_ASSERT(owner != machine.rovers.end());
    owner->events.push_back({event, declarations.events.at(event.type)});
  }
  return machine;
}

namespace {

// Inside a quoted DOT string; record labels also give meaning to braces, bars and angles.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (std::string_view("\"\\{}|<>").find(c) != std::string_view::npos) result += '\\';
    result += c == '\n' ? ' ' : c;
  }
  return result;
}

std::string node(const std::string& rover_id, std::int64_t sequence) {
  return fmt::format("\"{}/{}\"", escaped(rover_id), sequence);
}

std::string phases_text(const EventDeclaration& declaration) {
  std::string text;
  for (const EventDeclaration::Phase& phase : declaration.phases) {
    if (!text.empty()) text += " | ";
    text += escaped(phase.name);
    if (!phase.sub_event.empty()) text += " = " + escaped(phase.sub_event);
  }
  return text;
}

std::string event_node(const EventMachine& machine) {
  const PlanEvent& event = machine.event;
  const std::string title = event.label == fmt::format("{} {}", event.type, event.sequence)
                                ? event.label
                                : fmt::format("{}: {}", event.type, event.label);
  return fmt::format("    {} [label=\"{{{} | {{{}}}}}\"{}];\n",
                     node(event.rover_id, event.sequence), escaped(title),
                     phases_text(machine.declaration),
                     event.is_enabled ? "" : ", style=dashed, fontcolor=gray");
}

}  // namespace

std::string to_dot(const MissionMachine& machine) {
  std::string dot =
      "digraph mission {\n"
      "  rankdir=LR;\n"
      "  node [shape=record, style=rounded, fontname=\"Helvetica\"];\n"
      "  edge [fontname=\"Helvetica\"];\n"
      "  fontname=\"Helvetica\";\n"
      "  initialise [shape=oval];\n"
      "  terminate [shape=oval];\n";
  std::string extra;
  for (const RoverMachine& rover : machine.rovers) {
    const std::string id = escaped(rover.rover.id);
    dot += fmt::format("  subgraph \"cluster_{}\" {{\n    label=\"{} ({})\";\n", id, id,
                       escaped(rover.rover.type));
    std::string chain = "initialise";
    for (const EventMachine& event : rover.events) {
      dot += event_node(event);
      const std::string self = node(rover.rover.id, event.event.sequence);
      if (event.event.is_enabled) chain += " -> " + self;
      for (const PlanEvent::Reference& awaited : event.event.start_after) {
        extra += fmt::format("  {} -> {} [style=dashed, label=\"StartAfter\"];\n",
                             node(awaited.rover_id, awaited.sequence), self);
      }
      if (event.event.on_failure == OnFailure::go_to) {
        extra += fmt::format("  {} -> {} [style=dotted, label=\"on failure\"];\n", self,
                             node(rover.rover.id, event.event.go_to_sequence));
      }
    }
    dot += "  }\n";
    extra += fmt::format("  {} -> terminate;\n", chain);
  }
  if (machine.rovers.empty()) extra += "  initialise -> terminate;\n";
  return dot + extra + "}\n";
}

}  // namespace lsos
