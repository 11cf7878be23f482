// `lsos-host compare` and `lsos-host verify`: what differs between two runs, and whether the log of
// a run is the one that its summary was written of.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "lua/commands.h"
#include "lua/console.h"
#include "product/compare.h"
#include "product/files.h"

namespace lsos {

namespace {

// The text of DIR/summary.json. `advice`: what the message ends in where there is none.
std::string finished_summary(const std::string& folder, const char* advice = "") {
  std::string summary = read_file(folder + "/summary.json").value_or("");
  if (is_summary(summary)) return summary;
  throw InputError(
      {folder},
      fmt::format("holds no finished run (there is no summary.json of lsos-host){}", advice));
}

}  // namespace

int compare_command(const CompareOptions& options) {
  const LogReader a(options.folders[0] + "/log.gpkg"), b(options.folders[1] + "/log.gpkg");
  if (options.is_exact) {
    const ExactComparison found = compare_exactly(a, b);
    print_result("{}", options.is_json ? to_json(found) : to_text(found, options.folders));
    return found.difference ? 1 : 0;
  }
  const auto compared = [&](std::size_t k, const LogReader& log) {
    const char* advice = "; compare --exact compares the logs of unfinished ones too";
    return ComparedRun{finished_summary(options.folders[k], advice), log.run(), log.sha256()};
  };
  const Comparison found = compare(compared(0, a), compared(1, b));
  print_result("{}", options.is_json ? to_json(found) : to_text(found, options.folders));
  return found.is_equal() ? 0 : 1;
}

int verify_command(const VerifyOptions& options) {
  nlohmann::ordered_json answers = nlohmann::ordered_json::array();
  std::string text;
  bool are_verified = true;
  for (const std::string& folder : options.folders) {
    const LogReader log(folder + "/log.gpkg");
    const LogDigest digest = log_digest(finished_summary(folder), log.sha256());
    const std::string fault = digest_fault(digest);
    are_verified &= fault.empty();
    answers.push_back({{"folder", folder},
                       {"is_verified", fault.empty()},
                       {"log_sha256", digest.of_log},
                       {"summary_log_sha256", digest.of_summary}});
    text += fmt::format(
        "{}: {}\n", folder,
        fault.empty() ? "log.gpkg is as summary.json says, log_sha256 " + digest.of_log : fault);
  }
  print_result("{}", options.is_json ? answers.dump(2) + "\n" : text);
  return are_verified ? 0 : 1;
}

}  // namespace lsos
