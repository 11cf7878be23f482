#include "lua/host/run_mission.h"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/files.h"
#include "lua/host/mission_reader.h"
#include "lua/host/run_values.h"

namespace lsos {

namespace {

MissionFiles files_of_run(const std::string& folder,
                          const std::map<std::string, std::string>& run) {
  if (!run.contains("seed") || !run.contains("plan_sha256")) {
    throw InputError({}, folder + ": its log does not say what was run");
  }
  const std::string& seed_text = run.at("seed");  // may have been given as an option
  std::uint64_t seed = 0;
  const char* const end = seed_text.data() + seed_text.size();
  if (std::from_chars(seed_text.data(), end, seed).ptr != end || seed_text.empty()) {
    throw InputError({folder + "/log.gpkg"},
                     fmt::format("layer 'run', seed = '{}': a whole number is allowed", seed_text));
  }
  const auto summary =
      nlohmann::json::parse(read_file(folder + "/summary.json").value_or("{}"), nullptr, false);
  if (summary.is_object() && summary.contains("plan") && summary["plan"].is_string()) {
    const std::string original = summary["plan"].get<std::string>();
    std::error_code unreadable;  // as in a folder that may not be entered
    if (std::filesystem::is_regular_file(original, unreadable)) {
      // The run may come from elsewhere: what lies beside that plan is read where it is the same.
      try {
        const PlanSource source = read_plan_source(original);
        MissionFiles files = read_mission(source, read_catalog(source), seed);
        if (!files.faults.has_errors() && files.plan.hash() == run.at("plan_sha256")) {
          allow_around(source);
          return files;
        }
      } catch (const InputError&) {
        // It is no plan any more: the copy is.
      }
    }
  }
  const std::string copy = folder + "/plan.kml";
  MissionFiles files = read_mission(copy, seed);
  if (!files.faults.has_errors()) return files;
  const auto ours = std::make_shared<const Catalog>(script_folders(""));
  MissionFiles with_ours = read_mission(read_plan_source(copy), ours, seed);
  return with_ours.faults.has_errors() ? files : with_ours;
}

}  // namespace

MissionFiles mission_of_run(const std::string& folder,
                            const std::map<std::string, std::string>& run) {
  MissionFiles files = files_of_run(folder, run);
  restore_site(run, files.plan);
  return files;
}

void require_samples(const LogReader& log, const std::string& folder) {
  if (log.has_samples()) return;
  throw InputError({folder},
                   "its log has no sample: the run was stopped before its first, and there is "
                   "nothing to show");
}

}  // namespace lsos
