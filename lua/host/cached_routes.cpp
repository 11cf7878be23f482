#include "lua/host/cached_routes.h"

#include <fmt/format.h>

#include <filesystem>

#include "base/file_lock.h"
#include "base/files.h"
#include "lua/host/version.h"
#include "mission/routes/planned_legs.h"
#include "route/refine/optimise.h"

namespace lsos {

namespace {

constexpr const char* cached_legs_suffix = ".routes";

// Files larger than this are not added to: reading one costs each run more than it saves.
constexpr std::size_t kept_bytes_max = std::size_t{32} << 20;

// Another build may plan otherwise: what it kept is not ours.
std::string program_stamp() {
  const std::filesystem::path program = "/proc/self/exe";
  std::error_code ignored;
  const auto size = std::filesystem::file_size(program, ignored);
  const auto written = std::filesystem::last_write_time(program, ignored).time_since_epoch();
  return fmt::format("lsos-host {} {} {} {}\n", program_version, size, written.count(),
                     optimiser_stamp());
}

}  // namespace

std::string read_cached_legs(const std::string& plan_file) {
  const std::string file = plan_file + cached_legs_suffix;
  std::error_code ignored;
  if (std::filesystem::exists(file, ignored) && !std::filesystem::is_regular_file(file, ignored)) {
    return "";
  }
  const std::string bytes = read_file(file).value_or("");
  const std::string stamp = program_stamp();
  return bytes.starts_with(stamp) ? bytes.substr(stamp.size()) : "";
}

std::vector<Fault> cached_legs_advice(const std::string& plan_file) {
  const std::string file = plan_file + cached_legs_suffix;
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored) || std::filesystem::is_regular_file(file, ignored)) {
    return {};
  }
  return {{Severity::warning,
           {file, 0},
           "it is no file: planned routes would be kept under this name, and are not"}};
}

std::vector<Fault> cache_legs(const std::string& plan_file, const std::string& bytes) {
  std::error_code ignored;
  const bool is_file = std::filesystem::is_regular_file(plan_file, ignored);  // no pipe
  if (bytes.empty() || !is_file || !cached_legs_advice(plan_file).empty()) return {};
  try {
    const FileLock lock(plan_file);
    const std::string kept = read_cached_legs(plan_file);
    // The cases of a study may each need legs of their own, which no other will ask for.
    if (kept.size() > kept_bytes_max) return {};
    write_file(plan_file + cached_legs_suffix, program_stamp() + merged_legs(kept, bytes));
    return {};
  } catch (const std::runtime_error& error) {
    return {{Severity::warning,
             {},
             fmt::format("planned routes are not kept for the next run: {}", error.what())}};
  }
}

}  // namespace lsos
