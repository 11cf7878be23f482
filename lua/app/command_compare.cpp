// `lsos-host compare` and `lsos-host verify`: list the differences between two runs, and check that
// the log of a run is the one its summary was written from.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/console.h"
#include "base/error.h"
#include "base/files.h"
#include "lua/app/commands.h"
#include "product/compare.h"

namespace lsos {

namespace {

struct CompareOptions {
  std::array<std::string, 2> folders;
  bool is_exact = false;  // value by value of the logs
  bool is_json = false;
};

struct VerifyOptions {
  std::vector<std::string> folders;
  bool is_json = false;
};

// The text of DIR/summary.json. `advice`: what the message ends in where there is none.
std::string finished_summary(const std::string& folder, const char* advice = "") {
  std::string summary = read_file(folder + "/summary.json").value_or("");
  if (is_summary(summary)) return summary;
  throw InputError(
      {folder},
      fmt::format("holds no finished run (there is no summary.json of lsos-host){}", advice));
}

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

}  // namespace

std::function<int()> prepare_compare(CommandOptions& command) {
  const auto options = std::make_shared<CompareOptions>();
  command.add_option("A", options->folders[0], "Folder of a run").required();
  command.add_option("B", options->folders[1], "Folder of another").required();
  command.add_flag("--exact", options->is_exact, "The first differing value of the logs");
  command.add_flag("--json", options->is_json, "The answer as JSON");
  return [options] { return compare_command(*options); };
}

std::function<int()> prepare_verify(CommandOptions& command) {
  const auto options = std::make_shared<VerifyOptions>();
  command.add_option("DIR", options->folders, "Folders of finished runs").required();
  command.add_flag("--json", options->is_json, "The answer as JSON");
  return [options] { return verify_command(*options); };
}

}  // namespace lsos
