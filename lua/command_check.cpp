// `lsos-host check` and `lsos-host fsm`: what a plan says, without simulating it.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "lua/commands.h"
#include "lua/mission_files.h"

namespace lsos {

namespace {

std::string json_text(const MissionFiles& files) {
  nlohmann::ordered_json faults = nlohmann::ordered_json::array();
  for (const Fault& fault : files.faults.sorted()) {
    faults.push_back({{"severity", fault.severity == Severity::error ? "error" : "warning"},
                      {"file", fault.place.file},
                      {"line", fault.place.line},
                      {"what", fault.what}});
  }
  const nlohmann::ordered_json answer{{"plan", files.plan.file},
                                      {"is_valid", !files.faults.has_errors()},
                                      {"rovers", files.plan.rovers.size()},
                                      {"events", files.plan.events.size()},
                                      {"decoration", files.plan.decoration_count},
                                      {"faults", faults},
                                      {"defaults", files.plan.defaults},
                                      {"assumptions", files.assumptions}};
  return answer.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string json_text(const MissionMachine& machine) {
  nlohmann::ordered_json rovers = nlohmann::ordered_json::array();
  for (const RoverMachine& rover : machine.rovers) {
    nlohmann::ordered_json events = nlohmann::ordered_json::array();
    for (const EventMachine& event : rover.events) {
      nlohmann::ordered_json phases = nlohmann::ordered_json::array();
      for (const EventDeclaration::Phase& phase : event.declaration.phases) {
        phases.push_back(phase.name);
      }
      events.push_back({{"sequence", event.event.sequence},
                        {"type", event.event.type},
                        {"label", event.event.label},
                        {"enabled", event.event.is_enabled},
                        {"phases", phases}});
    }
    rovers.push_back(
        {{"rover_id", rover.rover.id}, {"type", rover.rover.type}, {"events", events}});
  }
  return nlohmann::ordered_json{{"rovers", rovers}}.dump(2, ' ', false,
                                                         nlohmann::json::error_handler_t::replace) +
         "\n";
}

std::string people_text(const MissionFiles& files) {
  std::string text;
  for (const Fault& fault : files.faults.sorted()) text += to_string(fault) + "\n";
  if (files.faults.has_errors()) return text;
  const auto counted = [](std::size_t count, const char* noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
  };
  text += fmt::format(
      "{}: {}, {}, {} left alone\n", files.plan.file, counted(files.plan.rovers.size(), "rover"),
      counted(files.plan.events.size(), "event"),
      counted(static_cast<std::size_t>(files.plan.decoration_count), "other Placemark"));
  for (const std::string& line : files.plan.defaults) text += fmt::format("  default: {}\n", line);
  for (const std::string& line : files.assumptions) text += fmt::format("  assumption: {}\n", line);
  return text;
}

}  // namespace

int check_command(const CheckOptions& options) {
  MissionFiles files = read_mission(options.plan);
  if (!files.faults.has_errors()) {
    try {
      // The machine's `initialise`: rovers are put on the ground, nothing moves.
      const Simulation simulation(simulation_setup(files));
      for (const std::string& line : simulation.assumptions()) files.assumptions.push_back(line);
      files.faults.add(simulation.ground().advice());
    } catch (const InputError& error) {
      files.faults.add(error.faults());
    }
  }
  fmt::print("{}", options.is_json ? json_text(files) : people_text(files));
  return files.faults.has_errors() ? 2 : 0;
}

int fsm_command(const std::string& plan, bool is_json) {
  const MissionFiles files = read_mission(plan);
  files.faults.throw_if_errors();
  const MissionMachine machine = synthesise(files.plan, files.catalog->declarations());
  fmt::print("{}", is_json ? json_text(machine) : to_dot(machine));
  return 0;
}

}  // namespace lsos
