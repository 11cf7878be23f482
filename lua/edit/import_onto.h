// `lsos-host import --onto`: rows of sheets brought back into the KML of a plan that was drawn.
#pragma once

#include <string>
#include <vector>

namespace lsos {

struct OntoOptions {
  std::vector<std::string> files;
  std::string plan, output;
  bool removes_missing = false;  // Placemarks without a row
  bool is_json = false;
};

// Writes the new plan and returns what it did, for the terminal. Throws InputError where a file has
// faults, the plan would have faults with these rows, or no row is of the plan.
std::string import_onto(const OntoOptions& options);

}  // namespace lsos
