// The machine of a mission as a figure, for Graphviz.
#include <fmt/format.h>

#include <algorithm>

#include "mission/model/machine.h"

namespace lsos {

namespace {

// Events in one row; a rover with more has several rows, one below the other.
constexpr std::size_t columns = 6;

// Escapes text for a quoted DOT string; braces, bars and angle brackets have a meaning in record
// labels.
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
  const std::string at = event.at ? fmt::format(" at {:g} s", seconds(*event.at)) : "";
  return fmt::format("    {} [label=\"{{{}{} | {{{}}}}}\"{}];\n",
                     node(event.rover_id, event.sequence), escaped(title), at,
                     phases_text(machine.declaration),
                     event.is_enabled ? "" : ", style=dashed, fontcolor=gray");
}

// The rover with those events alone that have a turn.
RoverMachine with_turns(const RoverMachine& rover) {
  RoverMachine turns{rover.rover, {}};
  for (const EventMachine& event : rover.events) {
    if (!event.event.at) turns.events.push_back(event);
  }
  return turns;
}

// Edges to the events that take effect at a time, whatever the rover does.
std::string timed_edges(const RoverMachine& rover) {
  std::string dot;
  for (const EventMachine& machine : rover.events) {
    const PlanEvent& event = machine.event;
    if (!event.at || !event.is_enabled) continue;
    dot += fmt::format("  initialise -> {} [style=dotted, label=\"at {:g} s\"];\n",
                       node(event.rover_id, event.sequence), seconds(*event.at));
  }
  return dot;
}

// Puts the events of one column into one rank; each further row begins at the first column.
std::string ranks(const RoverMachine& rover) {
  std::string dot;
  for (std::size_t column = 0; column < columns; ++column) {
    dot += "    { rank=same;";
    for (std::size_t i = column; i < rover.events.size(); i += columns) {
      dot += " " + node(rover.rover.id, rover.events[i].event.sequence) + ";";
    }
    dot += " }\n";
  }
  return dot;
}

// Edges from `initialise` through the enabled events to `terminate`.
std::string chain(const RoverMachine& rover) {
  const bool is_wrapped = rover.events.size() > columns;
  const auto node_of = [&](std::size_t i) {
    return node(rover.rover.id, rover.events[i].event.sequence);
  };
  std::string dot, row = "initialise", last = row;
  std::size_t next_column = 0;  // first column that lies farther along the row
  for (std::size_t i = 0; i < rover.events.size(); ++i) {
    if (!rover.events[i].event.is_enabled) continue;
    const bool goes_back = is_wrapped && i % columns < next_column;
    if (goes_back) {
      dot += fmt::format("  {};\n  {} -> {} [constraint=false];\n", row, last, node_of(i));
      row = node_of(i);
    } else {
      row += " -> " + node_of(i);
    }
    last = node_of(i);
    next_column = i % columns + 1;
  }
  if (!is_wrapped) return dot + fmt::format("  {} -> terminate;\n", row);
  // An invisible edge puts `terminate` to the right of all rows, at half their height.
  const std::size_t middle = rover.events.size() / columns / 2 * columns + columns - 1;
  return dot + fmt::format(
                   "  {};\n  {} -> terminate [constraint=false];\n"
                   "  {} -> terminate [style=invis];\n",
                   row, last, node_of(std::min(middle, rover.events.size() - 1)));
}

// Cross edges: dashed to events that wait, dotted to the event that a failure leads to.
std::string references(const RoverMachine& rover) {
  const std::string free = rover.events.size() > columns ? ", constraint=false" : "";
  std::string dot;
  for (const EventMachine& machine : rover.events) {
    const PlanEvent& event = machine.event;
    const std::string self = node(rover.rover.id, event.sequence);
    for (const PlanEvent::Reference& awaited : event.start_after) {
      dot += fmt::format("  {} -> {} [style=dashed, label=\"StartAfter\"{}];\n",
                         node(awaited.rover_id, awaited.sequence), self, free);
    }
    if (event.on_failure == OnFailure::go_to) {
      dot += fmt::format("  {} -> {} [style=dotted, label=\"on failure\"{}];\n", self,
                         node(rover.rover.id, event.go_to_sequence), free);
    }
  }
  return dot;
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
  std::string edges;
  for (const RoverMachine& rover : machine.rovers) {
    const std::string id = escaped(rover.rover.id);
    dot += fmt::format("  subgraph \"cluster_{}\" {{\n    label=\"{} ({})\";\n", id, id,
                       escaped(rover.rover.type));
    for (const EventMachine& event : rover.events) dot += event_node(event);
    const RoverMachine turns = with_turns(rover);
    if (turns.events.size() > columns) dot += ranks(turns);
    dot += "  }\n";
    edges += references(rover) + chain(turns) + timed_edges(rover);
  }
  if (machine.rovers.empty()) edges += "  initialise -> terminate;\n";
  return dot + edges + "}\n";
}

}  // namespace lsos
