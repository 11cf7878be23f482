#include "lua/study/cluster_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <regex>

#include "base/error.h"

namespace lsos {

namespace {

[[noreturn]] void refuse_option(const char* option, const std::string& text, const char* wanted) {
  throw InputError({}, fmt::format("{} {}: {}", option, text, wanted));
}

bool has_line_break(const std::string& text) {
  return text.find_first_of("\r\n") != std::string::npos;
}

}  // namespace

void check_cluster_options(const ClusterOptions& options) {
  if (options.is_slurm && !options.print.empty()) {
    throw InputError({},
                     "--slurm and --print are both given: one sends the script, the other "
                     "prints it");
  }
  if (!options.is_wanted()) {
    const std::array<std::pair<const char*, bool>, 5> given{
        {{"--chunk", options.chunk > 0},
         {"--limit", options.limit > 0},
         {"--time", !options.time.empty()},
         {"--partition", !options.partition.empty()},
         {"--directive", !options.directives.empty()}}};
    for (const auto& [name, is_given] : given) {
      if (!is_given) continue;
      throw InputError({}, fmt::format("{} is for the tasks of a cluster: --slurm sends them, "
                                       "--print prints their script",
                                       name));
    }
  }
  if (!options.time.empty() && !time_limit_s(options.time)) {
    refuse_option(
        "--time", options.time,
        "five minutes or more are wanted, as in 90 (minutes), 1:30:00 or 2-12:00:00 (days-hours)");
  }
  static const std::regex name(R"([A-Za-z0-9_][A-Za-z0-9_.,@:+-]*)");
  if (!options.partition.empty() && !std::regex_match(options.partition, name)) {
    refuse_option("--partition", options.partition,
                  "a name, or several with commas between them, is wanted");
  }
  for (const std::string& directive : options.directives) {
    if (!directive.empty() && !has_line_break(directive)) continue;
    refuse_option("--directive", directive, "one line is wanted, as in --directive=--account=moon");
  }
}

std::optional<std::int64_t> time_limit_s(const std::string& text) {
  // Days, hours, minutes and seconds are parts of the match; no number has so many digits that it
  // overflows.
  static const std::regex with_days(R"((\d{1,4})-(\d{1,4})(?::(\d{1,4}))?(?::(\d{1,4}))?)"),
      with_hours(R"(()(\d{1,6}):(\d{1,6}):(\d{1,6}))"), minutes(R"(()()(\d{1,7})(?::(\d{1,6}))?)");
  std::smatch match;
  const bool is_time = std::regex_match(text, match, with_days) ||
                       std::regex_match(text, match, with_hours) ||
                       std::regex_match(text, match, minutes);
  if (!is_time) return {};
  std::int64_t all_s = 0;
  constexpr std::array<std::int64_t, 4> unit_s{86400, 3600, 60, 1};
  for (std::size_t i = 0; i < unit_s.size(); ++i) {
    const std::string part = match[i + 1].str();
    all_s += part.empty() ? 0 : unit_s[i] * std::stoll(part);
  }
  if (all_s < time_min_s) return {};
  return all_s;
}

}  // namespace lsos
