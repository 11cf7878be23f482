#include "lua/host/load_budget.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace lsos {

namespace {

constexpr std::int64_t instructions_max = 100'000'000;
constexpr double cpu_max_s = 20;
constexpr std::size_t kept_max = std::size_t{64} << 20;
// Growth that is not worth a collection; what has been thrown away then counts, too.
constexpr std::size_t small = std::size_t{64} << 10;

// The folder that has events/, terrain/soils/ and the like.
std::string folder_of_scripts(const Script& script) {
  const std::filesystem::path above = std::filesystem::path(script.folder).parent_path();
  return (script.kind == ScriptKind::soil ? above.parent_path() : above).string();
}

std::string fault_text(const std::string& what) {
  return "is not loaded: the scripts of a folder may " + what;
}

}  // namespace

void LoadBudget::spend(const Script& script, Faults& faults, const std::function<void()>& load) {
  if (script.is_shipped) return load();
  Spent& spent = spent_[folder_of_scripts(script)];
  const auto refuse = [&](const std::string& what) {
    faults.error({script.file, 0}, fault_text(what));
  };
  if (spent.instructions > instructions_max) {
    return refuse(
        fmt::format("take {} million instructions together to load", instructions_max / 1'000'000));
  }
  if (spent.cpu_s > cpu_max_s) {
    return refuse(fmt::format("take {} s of the processor's time together to load", cpu_max_s));
  }
  const std::int64_t before = context_.instructions_of_calls;
  const std::size_t bytes_before = context_.memory.bytes();
  const double begin_s = cpu_now_s();
  load();
  spent.instructions += context_.instructions_of_calls - before;
  spent.cpu_s += cpu_now_s() - begin_s;
  spent.kept += kept_since(bytes_before);
  if (spent.kept > kept_max) {
    refuse(fmt::format("keep {} MiB of texts and tables together", kept_max >> 20));
  }
}

// Bytes that a script keeps; what it has thrown away is not counted.
std::size_t LoadBudget::kept_since(std::size_t bytes_before) {
  const std::size_t bytes = context_.memory.bytes();
  if (bytes <= bytes_before + small) return bytes - std::min(bytes, bytes_before);
  std::size_t kept = 0;
  lua_.run([&](lua_State* L) { kept = context_.memory.kept_bytes(L); });
  return kept - std::min(kept, bytes_before);
}

}  // namespace lsos
