#include "product/replaced_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/console.h"
#include "base/error.h"
#include "base/files.h"
#include "record/log.h"

namespace lsos {

namespace {

// File of another plan whose run the folder holds; "" where it holds no run, a run of this plan, or
// a run of a plan that no longer exists.
std::string other_plan_in(const std::string& folder, const std::string& plan) {
  const std::string bytes = read_file(folder + "/summary.json").value_or("");
  const auto summary = nlohmann::json::parse(bytes, nullptr, false);
  if (!summary.is_object() || !summary.contains("plan") || !summary["plan"].is_string()) return "";
  const std::string other = summary["plan"].get<std::string>();
  std::error_code ignored;
  const bool is_other =
      std::filesystem::exists(other, ignored) && !std::filesystem::equivalent(other, plan, ignored);
  return is_other ? other : "";
}

// Whether the folder holds a run that a signal stopped, and that can go on.
bool has_stopped_run(const std::string& folder) {
  try {
    return std::ranges::any_of(
        LogReader(folder + "/log.gpkg").checkpoints(),
        [](const CheckpointEntry& entry) { return entry.kind == CheckpointKind::stop; });
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

std::string check_replaced_run(const std::string& folder, const std::string& plan, bool is_default,
                               bool is_forced) {
  std::string other = other_plan_in(folder, plan);
  if (is_forced) return other;
  // Without this check plans of the same name in two folders would replace each other's results.
  if (!other.empty() && is_default) {
    throw InputError({folder},
                     fmt::format("holds the run of {}, another plan of that name: -o names another "
                                 "folder, --force replaces it",
                                 other));
  }
  if (has_stopped_run(folder)) {
    throw InputError({folder},
                     fmt::format("holds a run that was stopped; 'lsos-host resume {}' goes on with "
                                 "it, --force replaces it, -o names another folder",
                                 folder));
  }
  return other;
}

void tell_of_replaced_run(const std::string& folder, const std::string& other_plan) {
  if (other_plan.empty()) return;
  print_message("{}: the run of {} that it held is replaced\n", folder, other_plan);
}

}  // namespace lsos
