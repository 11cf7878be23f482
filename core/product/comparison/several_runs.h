// What several runs came to beside each other: the first is the trunk that all others are set
// against.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "product/compare.h"
#include "record/rows.h"

namespace lsos {

// Runs that fit over each other on a page: a trunk and ten branches.
inline constexpr std::size_t runs_max = 11;

// A run, finished or not.
struct RunOutcome {
  std::string folder;
  std::vector<EventRow> events;
  std::string summary;  // text of summary.json; "" for a run that has not finished
};

// One event, as each run came to it.
struct EventOutcomes {
  std::string rover_id;
  std::int64_t sequence = 0;
  std::string label;                          // of the first run that has it
  std::vector<std::optional<EventRow>> runs;  // absent: that run has no such event

  // Whether status, start, end, distance or energy are not those of the first run.
  bool differs(std::size_t run) const;
};

// "A" for the first run, then "B", ...
std::string run_name(std::size_t run);
// Colour of the run on pages: "#17212b".
std::string run_colour(std::size_t run);

// Events in which any run differs from the first, by rover and sequence.
std::vector<EventOutcomes> differing_events(const std::vector<RunOutcome>& runs);

struct SeveralRuns {
  std::vector<RunOutcome> runs;
  std::vector<EventOutcomes> events;
  std::vector<Comparison> with_first;  // of each run but the first

  bool are_equal() const;
};
// `compared`: the same runs in the same order.
SeveralRuns compare_several(std::vector<RunOutcome> runs, const std::vector<ComparedRun>& compared);

}  // namespace lsos
