// How far a sweep is, as its folder shows it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lsos {

struct SweepState {
  std::int64_t cases = 0;                                  // that there are to be
  std::int64_t completed = 0, failed = 0, incomplete = 0;  // missions of cases that are done
  std::int64_t not_run = 0;
  std::vector<std::int64_t> running;
  double mean_wall_s = 0;  // of cases that are done; 0: none is

  std::int64_t done() const { return completed + failed + incomplete; }
  std::int64_t missing() const { return cases - done() - not_run; }
  // Wall time until all are done with as many at a time; absent where it cannot be told.
  std::optional<double> left_s(std::size_t at_a_time) const;
  // Counts one more that is done, with its mission's status.
  void add(const std::string& status, double wall_s);
};

// Reads these cases in the folder. A task of a cluster reads its own alone: all tasks together
// would read each case as often as there are tasks.
SweepState sweep_state(const std::string& folder, const std::vector<std::int64_t>& numbers);

// "12 of 200 cases done (10 completed, 2 failed), 2 running".
std::string to_text(const SweepState& state);
std::string to_json(const SweepState& state);

}  // namespace lsos
