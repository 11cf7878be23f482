// `lsos-host compare`: what differs between two runs.
#include <fmt/format.h>

#include "base/error.h"
#include "lua/commands.h"
#include "product/compare.h"
#include "product/files.h"

namespace lsos {

int compare_command(const CompareOptions& options) {
  const LogReader a(options.folders[0] + "/log.gpkg"), b(options.folders[1] + "/log.gpkg");
  if (options.is_exact) {
    const ExactComparison found = compare_exactly(a, b);
    fmt::print("{}", options.is_json ? to_json(found) : to_text(found, options.folders));
    return found.difference ? 1 : 0;
  }
  std::array<std::string, 2> summaries;
  for (std::size_t k = 0; k < 2; ++k) {
    const std::string& folder = options.folders[k];
    summaries[k] = read_file(folder + "/summary.json").value_or("");
    if (is_summary(summaries[k])) continue;
    throw InputError({folder},
                     "holds no finished run (there is no summary.json of lsos-host); --exact "
                     "compares the logs of unfinished ones too");
  }
  const Comparison found = compare(summaries[0], summaries[1], a.run(), b.run());
  fmt::print("{}", options.is_json ? to_json(found) : to_text(found, options.folders));
  return found.is_equal() ? 0 : 1;
}

}  // namespace lsos
