// What differs between two runs: in what rovers and events came to, or in any value of their logs.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "product/summary.h"
#include "record/log_difference.h"

namespace lsos {

// A value of both runs, as JSON text; "null" where one has none.
struct Difference {
  std::string of;        // "run", "rover SEV1", "event SEV1/10 To the array"
  std::string quantity;  // distance_m
  std::string a, b;
  std::optional<double> change;  // b - a, of numbers
};

struct Comparison {
  std::vector<Difference> differences;  // of results
  std::vector<Difference> made_of;      // plan, scripts, seed, ...: why results may differ
  bool has_equal_logs = false;          // the same log_sha256
  bool is_equal() const { return differences.empty(); }
};

// `summary_a`, `summary_b`: texts of summary.json; `run_a`, `run_b`: the logs' layer run.
Comparison compare(const std::string& summary_a, const std::string& summary_b,
                   const std::map<std::string, std::string>& run_a,
                   const std::map<std::string, std::string>& run_b);

struct ExactComparison {
  std::array<std::string, 2> sha256;
  std::optional<LogDifference> difference;
};
ExactComparison compare_exactly(const LogReader& a, const LogReader& b);

std::string to_json(const Comparison& found);
std::string to_text(const Comparison& found, const std::array<std::string, 2>& names);
std::string to_json(const ExactComparison& found);
std::string to_text(const ExactComparison& found, const std::array<std::string, 2>& names);

}  // namespace lsos
