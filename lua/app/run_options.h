// What `lsos-host run` is told, once and with --watch.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace lsos {

struct RunOptions {
  std::string plan;
  std::string folder;  // "": out/PLAN-NAME
  bool is_quiet = false;
  bool is_json = false;
  bool is_forced = false;  // replace an unfinished run
  bool has_report = true;  // report.html
  int threads = 1;
  std::optional<std::uint64_t> seed;  // instead of the plan's
  bool save_every_exchange = false;
  bool is_watched = false;  // run again whenever the plan or a script changes
};
int run_command(const RunOptions& options);
// Runs it again each time that the plan or a script changes, until a signal comes.
int watch_command(RunOptions options);

}  // namespace lsos
