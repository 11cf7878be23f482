// The differences between two runs: in the results of rovers and events, or in any value of their
// logs.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "product/summary.h"
#include "record/log_difference.h"

namespace lsos {

// A value that differs between the runs, as JSON text; "null" where a run lacks it.
struct Difference {
  std::string of;        // "run", "rover SEV1", "event SEV1/10 To the array"
  std::string quantity;  // distance_m
  std::string a, b;
  std::optional<double> change;  // b - a, for numbers
};

// The digest of a log: computed from the log, and as recorded in the run's summary.
struct LogDigest {
  std::string of_log, of_summary;
  bool matches() const { return of_log == of_summary; }
};
LogDigest log_digest(const std::string& summary, const std::string& sha256_of_log);
// Message that the log is not the one that the summary was written of; "" where the digests match.
std::string digest_fault(const LogDigest& digest);

struct Comparison {
  std::vector<Difference> differences;  // in results
  std::vector<Difference> made_of;      // plan, scripts, seed, ...: why results may differ
  // Digests of the logs, computed and recorded. They differ where a log was changed afterwards; the
  // summary then belongs to another run.
  std::array<LogDigest, 2> logs;

  bool has_equal_logs() const { return logs[0].of_log == logs[1].of_log; }
  bool is_equal() const { return differences.empty() && logs[0].matches() && logs[1].matches(); }
};

// The parts of a finished run that are compared.
struct ComparedRun {
  std::string summary;                     // text of summary.json
  std::map<std::string, std::string> run;  // layer `run` of the log
  std::string log_sha256;                  // computed from the log
};
Comparison compare(const ComparedRun& a, const ComparedRun& b);

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
