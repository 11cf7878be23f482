#include "lua/session/scenario_runner.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <set>

#include "base/bounded_file.h"
#include "base/console.h"
#include "base/files.h"
#include "base/output_file.h"
#include "lua/runtime/handle.h"
#include "lua/runtime/loader.h"
#include "lua/runtime/state.h"
#include "lua/session/scenario.h"
#include "lua/session/session_api.h"
#include "lua/session/sim_sessions.h"
#include "picture/png.h"
#include "product/run_folder.h"

namespace lsos {

namespace {

namespace fs = std::filesystem;

bool is_plain(const fs::path& file, fs::file_type type) {
  std::error_code unreadable;
  return fs::symlink_status(file, unreadable).type() == type;
}

// A picture that `sim:picture` has named.
bool is_picture(const fs::path& file) {
  return file.filename().string().ends_with("_s.png") && is_plain(file, fs::file_type::regular) &&
         read_file(file.string()).value_or("").starts_with(png_mark);
}

// Removes what the simulations of a scenario have left there. Whatever else lies there stays: users
// name the folder, scripts the scenario.
void clear_logs(const fs::path& folder) {
  if (!is_plain(folder, fs::file_type::directory)) return;
  const auto entries_of = [](const fs::path& of) {
    std::error_code unreadable;
    std::vector<fs::path> entries;
    for (const auto& entry : fs::directory_iterator(of, unreadable)) entries.push_back(entry);
    return entries;
  };
  for (const fs::path& log : entries_of(folder)) {
    if (!SimSessions::is_folder_name(log.filename().string()) ||
        !is_plain(log, fs::file_type::directory)) {
      continue;
    }
    try {
      RunFolder run(log.string(), true);
      for (const fs::path& file : entries_of(log)) {
        if (is_picture(file)) ::unlink(file.c_str());
      }
      run.clear();
    } catch (const std::runtime_error&) {
      // No run of this program, or it cannot be removed.
    }
  }
  ::rmdir(folder.c_str());  // fails where something else lies in it
}

// Pops a scenario's function and runs it.
ScenarioResult run_one(lua_State* L, SimSessions& sims, const std::string& file,
                       const std::string& name, const std::string& folder) {
  ScenarioResult result{file, name, "", folder, 0};
  const auto begin = std::chrono::steady_clock::now();
  push_handle(L, scenario_handle_type(), 0);
  try {
    if (const auto failure = call_script(L, 1, 0)) {
      result.failure = failure->message;
      // Where it came through, when that is more than the scenario itself.
      if (std::ranges::count(failure->traceback, '\n') > 4) {
        result.failure += "\n" + failure->traceback;
      }
      // An event that broke is what most of them fail of.
      for (const std::string& news : sims.take_news()) result.failure += "\n" + news;
    }
  } catch (const std::exception& error) {
    result.failure = fmt::format("fault inside the program: {}", error.what());
  }
  if (result.failure.empty()) result.failure = sims.failed_expectation();
  sims.close_all();
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
  result.wall_s = wall.count();
  if (result.failure.empty()) clear_logs(folder);
  std::error_code ignored;
  if (result.failure.empty() || !fs::exists(folder, ignored)) result.log.clear();
  return result;
}

// A folder's name made of a scenario's; no two scenarios of a file have the same.
std::string folder_name(const std::string& name, std::set<std::string>& taken) {
  constexpr std::size_t longest = 80;
  std::string text;
  for (const char c : name.substr(0, longest)) {
    text += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  }
  if (text.empty()) text.push_back('_');
  std::string own = text;
  for (int k = 2; !taken.insert(own).second; ++k) own = fmt::format("{}_{}", text, k);
  return own;
}

}  // namespace

void run_scenarios(const std::string& file, const std::string& filter, const std::string& folder,
                   const std::function<void(const ScenarioResult&)>& report) {
  const fs::path path = file;
  Script script;
  script.name = path.stem();
  script.file = file;
  script.folder = path.parent_path();
  FileBounds bounds;
  bounds.may_be_pipe = true;
  Parsed<std::string> source = read_bounded(file, bounds);
  if (!source) return report({file, "", fmt::format("{}: {}", file, source.why), "", 0});
  script.source = *std::move(source.value);

  LuaState lua(make_session_api, session_limits());
  lua.run([&](lua_State* L) {
    // On standard error: standard output is the report.
    const auto say = [](const std::string& line) { print_message("{}\n", line); };
    SimSessions at_load(folder, say, true);
    lua.context().interactive_rovers = &at_load;
    Faults faults;
    if (!run_script(L, script, faults)) {
      std::string text;
      for (const Fault& fault : faults.sorted()) text += to_string(fault) + "\n";
      return report({file, "", text, "", 0});
    }
    lua_settop(L, 0);
    push_scenarios(L);
    const auto count = static_cast<lua_Integer>(lua_rawlen(L, 1));
    if (count == 0) report({file, "", file + ": has no lsos.scenario(name, function)", "", 0});
    std::set<std::string> folders;
    for (lua_Integer k = 1; k <= count; ++k) {
      lua_settop(L, 1);
      lua_rawgeti(L, 1, k);
      lua_rawgeti(L, 2, 1);
      const std::string name = error_text(L, 3);
      if (name.find(filter) == std::string::npos && file.find(filter) == std::string::npos)
        continue;
      lua_rawgeti(L, 2, 2);
      const std::string own_name = folder_name(name, folders), own_folder = folder + "/" + own_name;
      refuse_links(folder, own_name);
      SimSessions sims(own_folder, say);
      lua.context().interactive_rovers = &sims;
      report(run_one(L, sims, file, name, own_folder));
    }
  });
  lua.context().interactive_rovers = nullptr;
}

}  // namespace lsos
