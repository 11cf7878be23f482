// Scenarios: scripts that put a rover somewhere, run it, and say what must have come of it.
#pragma once

#include <functional>
#include <string>

namespace lsos {

struct ScenarioResult {
  std::string file, name;
  std::string failure;  // "" when it passed: message with file, line and simulated time
  std::string log;      // folder of what a failed one left
  double wall_s = 0;
};

// Runs the scenarios of a file whose name holds `filter`, and reports each when it has ended. Each
// leaves its logs in a folder of its own in `folder`, which goes when it has passed. A script that
// does not load is one failed scenario without a name.
void run_scenarios(const std::string& file, const std::string& filter, const std::string& folder,
                   const std::function<void(const ScenarioResult&)>& report);

}  // namespace lsos
