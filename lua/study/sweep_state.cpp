#include "lua/study/sweep_state.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "product/study/case_record.h"

namespace lsos {

namespace {

// A case that runs holds its lock.
bool is_locked(const std::string& file) {
  const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
  if (descriptor < 0) return false;
  const bool is_held = flock(descriptor, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  close(descriptor);
  return is_held;
}

}  // namespace

std::optional<double> SweepState::left_s(std::size_t at_a_time) const {
  if (missing() == 0) return 0;
  if (mean_wall_s == 0 || at_a_time == 0) return {};
  return mean_wall_s * static_cast<double>(missing()) / static_cast<double>(at_a_time);
}

void SweepState::add(const std::string& status, double wall_s) {
  const auto before = static_cast<double>(done());
  mean_wall_s = (mean_wall_s * before + wall_s) / (before + 1);
  ++(status == "completed" ? completed : status == "failed" ? failed : incomplete);
}

SweepState sweep_state(const std::string& folder, const std::vector<std::int64_t>& numbers) {
  SweepState state;
  state.cases = static_cast<std::int64_t>(numbers.size());
  std::error_code absent;
  for (const std::int64_t number : numbers) {
    const std::string name = case_folder(folder, number);
    if (const auto record = read_case_record(read_file(name + "/" + case_file).value_or(""))) {
      state.add(record->status, record->wall_s);
    } else if (std::filesystem::exists(not_run_file(folder, number), absent)) {
      ++state.not_run;
    } else if (is_locked(name + ".lock")) {
      state.running.push_back(number);
    }
  }
  return state;
}

std::string to_text(const SweepState& state) {
  std::string text = fmt::format("{} of {} cases done", state.done(), state.cases);
  std::vector<std::string> kinds;
  const auto add = [&](std::int64_t count, const char* what) {
    if (count > 0) kinds.push_back(fmt::format("{} {}", count, what));
  };
  add(state.completed, "completed");
  add(state.failed, "failed");
  add(state.incomplete, "incomplete");
  if (!kinds.empty()) text += fmt::format(" ({})", fmt::join(kinds, ", "));
  if (state.not_run > 0) text += fmt::format(", {} could not be run", state.not_run);
  if (!state.running.empty()) text += fmt::format(", {} running", state.running.size());
  return text;
}

std::string to_json(const SweepState& state) {
  const auto left = state.left_s(state.running.size());
  const nlohmann::ordered_json json{
      {"cases", state.cases},
      {"done", state.done()},
      {"completed", state.completed},
      {"failed", state.failed},
      {"incomplete", state.incomplete},
      {"not_run", state.not_run},
      {"missing", state.missing()},
      {"running", state.running},
      {"mean_wall_s", state.mean_wall_s},
      {"left_s", left ? nlohmann::ordered_json(*left) : nlohmann::ordered_json(nullptr)}};
  return json.dump(2) + "\n";
}

}  // namespace lsos
