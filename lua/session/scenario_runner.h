// Scenarios: scripts that set up a mission, run it, and check the outcome.
#pragma once

#include <functional>
#include <string>

namespace lsos {

struct ScenarioResult {
  std::string file, name;
  std::string failure;  // "" when it passed: message with file, line and simulated time
  std::string log;      // folder with the logs of a failed scenario
  double wall_s = 0;
};

// Runs the scenarios of a file whose name, or the file's, contains `filter`, and reports each when
// it has ended. Each leaves its logs in its own folder within `folder`, which is removed when the
// scenario has passed. A script that does not load counts as one failed scenario without a name.
void run_scenarios(const std::string& file, const std::string& filter, const std::string& folder,
                   const std::function<void(const ScenarioResult&)>& report);

}  // namespace lsos
