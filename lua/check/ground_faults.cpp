#include "lua/check/ground_faults.h"

#include <algorithm>

namespace lsos {

namespace {

bool is_circle(const Fault& fault) {
  return fault.what.find(": StartAfter goes in a circle: ") != std::string::npos;
}

}  // namespace

std::vector<Fault> ground_faults(const Faults& known, SimulationSetup setup) {
  const auto is_harmless = [](const Fault& fault) {
    return fault.severity == Severity::warning || is_circle(fault);
  };
  if (!std::ranges::all_of(known.sorted(), is_harmless)) return {};
  for (PlanEvent& event : setup.plan.events) event.start_after.clear();
  try {
    const Simulation simulation(std::move(setup));
    return simulation.advice();
  } catch (const InputError& error) {
    return error.faults();
  }
}

}  // namespace lsos
