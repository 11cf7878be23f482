// Chooses what a map or a page shows of layers that grow with a run: its planned paths, and when
// who saw whom. The log has all.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "record/log.h"

namespace lsos {

// Greatest numbers of planned paths, of their points together, and of intervals of sight.
inline constexpr std::size_t shown_paths_max = 5000, shown_path_points_max = 5'000'000;
inline constexpr std::size_t shown_intervals_max = 200'000;

struct ShownRows {
  std::size_t shown = 0, in_log = 0;

  bool is_whole() const { return shown == in_log; }
};

// Visits planned paths in order of the log: all, or the greatest number, evenly spread.
ShownRows for_each_shown_path(const LogReader& log,
                              const std::function<void(const PlannedPathRow&)>& visit);

// "5,000 of 120,000 planned paths; log.gpkg has all".
std::string shown_text(const ShownRows& rows, const std::string& what);

}  // namespace lsos
