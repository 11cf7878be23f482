// A study's stop_when: it ends after the first cases, in tens, that say well enough what it asks.
// Which these are depends on their results alone, not on the order in which they were run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lua/study/study_files.h"

namespace lsos {

// Looks at the cases of a folder as they come.
class StopWatch {
 public:
  StopWatch(const StudyFiles& files, std::string folder)
      : files_(files), folder_(std::move(folder)) {}

  // The number of the last case that the study needs; absent while that is not known. A case that
  // has not run, or could not be, hides those after it.
  std::optional<std::int64_t> last_case();
  // "known within 0.01 after 120 of 500 cases"; "" while it is not.
  std::string text() const;

 private:
  const StudyFiles& files_;
  std::string folder_;
  std::vector<double> values_;  // of the cases from 1 on
  std::optional<std::int64_t> last_;
  double half_width_ = 0;
};

}  // namespace lsos
