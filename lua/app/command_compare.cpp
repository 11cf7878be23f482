// `lsos-host compare` and `lsos-host verify`: list the differences between runs, or between a run
// and telemetry, and check that the log of a run is the one its summary was written from.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/bounded_file.h"
#include "base/console.h"
#include "base/error.h"
#include "base/files.h"
#include "base/output_file.h"
#include "lua/app/commands.h"
#include "lua/app/opened_run.h"
#include "lua/host/run_mission.h"
#include "product/compare.h"
#include "product/comparison/residuals_text.h"
#include "product/comparison/several_runs_text.h"
#include "product/comparison/telemetry_page.h"

namespace lsos {

namespace {

struct CompareOptions {
  std::string first;
  std::vector<std::string> others;  // folders of runs, or one file of telemetry
  std::string page;                 // of telemetry over a run; "": none
  bool is_exact = false;            // value by value of the logs
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

// The runs, opened.
struct ComparedRuns {
  std::vector<std::string> folders;
  std::vector<std::unique_ptr<LogReader>> logs;

  ComparedRun compared(std::size_t k) const {
    const char* advice = "; compare --exact compares the logs of unfinished ones too";
    return {finished_summary(folders[k], advice), logs[k]->run(), logs[k]->sha256()};
  }
};

ComparedRuns opened(const CompareOptions& options) {
  ComparedRuns runs;
  runs.folders = options.others;
  runs.folders.insert(runs.folders.begin(), options.first);
  if (runs.folders.size() > runs_max) {
    throw InputError(
        {}, fmt::format("{} runs: at most {} are compared", runs.folders.size(), runs_max));
  }
  for (const std::string& folder : runs.folders) {
    runs.logs.push_back(std::make_unique<LogReader>(folder + "/log.gpkg"));
  }
  return runs;
}

int compare_two(const ComparedRuns& runs, const CompareOptions& options) {
  const std::array<std::string, 2> names{runs.folders[0], runs.folders[1]};
  if (options.is_exact) {
    const ExactComparison found = compare_exactly(*runs.logs[0], *runs.logs[1]);
    print_result("{}", options.is_json ? to_json(found) : to_text(found, names));
    return found.difference ? 1 : 0;
  }
  const Comparison found = compare(runs.compared(0), runs.compared(1));
  print_result("{}", options.is_json ? to_json(found) : to_text(found, names));
  return found.is_equal() ? 0 : 1;
}

int compare_more(const ComparedRuns& runs, const CompareOptions& options) {
  if (options.is_exact) {
    ExactAgainstFirst exact{runs.folders, {}};
    for (std::size_t k = 1; k < runs.logs.size(); ++k) {
      exact.with_first.push_back(compare_exactly(*runs.logs[0], *runs.logs[k]));
    }
    print_result("{}", options.is_json ? to_json(exact) : to_text(exact));
    return exact.are_equal() ? 0 : 1;
  }
  std::vector<RunOutcome> outcomes;
  std::vector<ComparedRun> compared;
  for (std::size_t k = 0; k < runs.logs.size(); ++k) {
    compared.push_back(runs.compared(k));
    outcomes.push_back({runs.folders[k], runs.logs[k]->events(), compared.back().summary});
  }
  const SeveralRuns several = compare_several(std::move(outcomes), compared);
  print_result("{}", options.is_json ? to_json(several) : to_text(several));
  return several.are_equal() ? 0 : 1;
}

bool is_table(const std::string& name) {
  if (std::filesystem::is_directory(name)) return false;
  constexpr std::string_view endings[] = {".csv", ".tsv", ".txt"};
  return std::filesystem::is_regular_file(name) || std::filesystem::is_fifo(name) ||
         std::ranges::any_of(endings, [&](std::string_view end) { return name.ends_with(end); });
}

// Lays a table of measured rows over the run. Faults of single rows are warnings.
int compare_with_telemetry(const CompareOptions& options) {
  const std::string &folder = options.first, &file = options.others.front();
  Faults faults;
  if (options.others.size() > 1) {
    faults.error({file}, "is no folder of a run: telemetry is laid over one run alone");
  }
  if (options.is_exact) faults.error({}, "--exact: only between runs, not with telemetry");
  if (!options.page.empty()) {
    check_output("-o", options.page, {".html"}, {folder + "/log.gpkg", file}, faults);
  }
  faults.throw_if_errors();
  const std::string text = read_named_file(file);
  const LogReader log(folder + "/log.gpkg");
  require_samples(log, folder);
  RunExtent extent{log.start(), log.last_sample_time(), {}};
  for (const auto& [id, totals] : log.sample_totals()) extent.rovers.push_back(id);
  const Telemetry telemetry = read_telemetry(file, text, extent);
  for (const Fault& fault : faults_of(telemetry, Severity::warning)) {
    print_message("{}\n", to_string(fault));
  }
  const bool has_page = !options.page.empty();
  const LoggedMission from =
      has_page ? open_run_or_log(folder, log) : open_without_ground(folder, log);
  const Residuals found = residuals(log, *from.run.files.plan.mission.planet, telemetry);
  if (has_page) {
    const std::string summary = read_file(folder + "/summary.json").value_or("");
    write_file(options.page,
               telemetry_page(from.run, log, summary, telemetry, found, {}, from.left_out));
  }
  print_result("{}", options.is_json ? to_json(found, telemetry, folder)
                                     : to_text(found, telemetry, folder));
  return 0;
}

int compare_command(const CompareOptions& options) {
  if (std::ranges::any_of(options.others, is_table)) {
    CompareOptions with_table = options;
    std::stable_partition(with_table.others.begin(), with_table.others.end(), is_table);
    return compare_with_telemetry(with_table);
  }
  if (!options.page.empty()) {
    throw InputError({},
                     "-o: a page of telemetry; 'lsos-host report A B -o FILE.html' writes one "
                     "of several runs");
  }
  const ComparedRuns runs = opened(options);
  return runs.logs.size() == 2 ? compare_two(runs, options) : compare_more(runs, options);
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
  print_result("{}",
               options.is_json
                   ? answers.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n"
                   : text);
  return are_verified ? 0 : 1;
}

}  // namespace

std::function<int()> prepare_compare(CommandOptions& command) {
  const auto options = std::make_shared<CompareOptions>();
  command.add_option("A", options->first, "Folder of a run").required();
  command
      .add_option("B", options->others,
                  "Folders of others, up to ten; or a table of telemetry, CSV")
      .required();
  command.add_option("-o,--output", options->page, "With telemetry: a page of plots, FILE.html");
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
