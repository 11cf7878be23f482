#include "product/shown_rows.h"

#include <fmt/format.h>

#include <algorithm>

#include "product/thinned_notes.h"

namespace lsos {

ShownRows for_each_shown_path(const LogReader& log,
                              const std::function<void(const PlannedPathRow&)>& visit) {
  ShownRows paths;
  paths.in_log = log.row_count("planned_paths");
  EvenChoice choice{paths.in_log, shown_paths_max};
  std::size_t points = 0;
  log.for_each_planned_path([&](const PlannedPathRow& row) {
    const bool is_chosen = choice.takes_next();
    if (!is_chosen || points + row.line.size() > shown_path_points_max) return;
    points += row.line.size();
    ++paths.shown;
    visit(row);
  });
  // Some rows of a run that goes on were written after counting.
  paths.in_log = std::max(paths.in_log, paths.shown);
  return paths;
}

std::string shown_text(const ShownRows& rows, const std::string& what) {
  return fmt::format("{} of {} {}; log.gpkg has all", rows.shown, rows.in_log, what);
}

}  // namespace lsos
