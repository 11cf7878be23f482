// Several runs beside each other, as text for people and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "product/comparison/several_runs.h"

namespace lsos {

// A table of totals a rover, and one an event that differs.
std::string to_text(const SeveralRuns& several);
std::string to_json(const SeveralRuns& several);

// The events that differ, each with what it came to in each run; null where a run lacks it.
nlohmann::ordered_json events_json(const std::vector<EventOutcomes>& events);

// The first run's log against that of each other, to the first differing value.
struct ExactAgainstFirst {
  std::vector<std::string> folders;         // of all runs
  std::vector<ExactComparison> with_first;  // of each run but the first

  bool are_equal() const;
};
std::string to_text(const ExactAgainstFirst& exact);
std::string to_json(const ExactAgainstFirst& exact);

}  // namespace lsos
