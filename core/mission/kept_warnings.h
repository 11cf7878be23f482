// The warnings of a run: a script may give thousands a second.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/archive.h"

namespace lsos {

// Warnings of scripts and events that are kept; those of a run's end come on top.
inline constexpr std::size_t kept_warnings_max = 1000;

class KeptWarnings {
 public:
  // Keeps the warning while there is room, else counts it.
  void add(std::string warning) {
    if (texts_.size() < kept_warnings_max) {
      texts_.push_back(std::move(warning));
    } else {
      ++left_out_;
    }
  }
  // Warnings of the run's end are as few as its rovers, and kept in any case.
  void add_last(std::string warning) { texts_.push_back(std::move(warning)); }

  const std::vector<std::string>& texts() const { return texts_; }
  // Says how many were not kept; "" when all were.
  std::string rest() const {
    if (left_out_ == 0) return "";
    return fmt::format(
        "{} more warnings are not listed, after the first {}; those that events gave are all in "
        "the log, table notes, name warning",
        left_out_, kept_warnings_max);
  }

  void archive(Archive& a) { LSOS_ARCHIVE(a, texts_, left_out_); }

 private:
  std::vector<std::string> texts_;
  std::int64_t left_out_ = 0;
};

}  // namespace lsos
