// `lsos-host test`: runs scenarios, each file in a separate process.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <deque>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "base/child_process.h"
#include "base/console.h"
#include "base/error.h"
#include "base/files.h"
#include "base/output_file.h"
#include "lua/app/commands.h"
#include "lua/app/common_options.h"
#include "lua/session/scenario_runner.h"

namespace lsos {

namespace {

constexpr const char* default_folder = "out/scenarios";

struct TestOptions {
  std::vector<std::string> paths{"tests/scenarios"};
  std::string filter;  // only scenarios with it in their name, or their file's
  std::string junit_file;
  std::string folder = default_folder;  // of the logs of those that fail
  int threads = 2;
  bool is_json = false;
};

namespace fs = std::filesystem;

// A file whose scenarios run in another process, which writes a line of JSON for each scenario.
struct Worker {
  std::string file;
  ChildProcess process;
};

nlohmann::json to_json(const ScenarioResult& r) {
  return {{"file", r.file},
          {"name", r.name},
          {"failure", r.failure},
          {"log", r.log},
          {"wall_s", r.wall_s}};
}

std::string result_line(const ScenarioResult& r) {
  return to_json(r).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

// Parses the lines that line_of() makes.
std::vector<ScenarioResult> from_lines(const std::string& text) {
  std::vector<ScenarioResult> results;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const nlohmann::json r = nlohmann::json::parse(line, nullptr, false);
    if (r.is_discarded()) continue;  // an incomplete line
    results.push_back({r.at("file"), r.at("name"), r.at("failure"), r.at("log"), r.at("wall_s")});
  }
  return results;
}

Worker start(const std::string& file, const std::string& folder, const TestOptions& options) {
  int lines = -1;
  std::optional<ChildProcess> process = ChildProcess::fork(ChildProcess::Pipe::from_child, lines);
  if (process) return {file, std::move(*process)};
  const auto report = [&](const ScenarioResult& result) { write_all(lines, result_line(result)); };
  try {
    run_scenarios(file, options.filter, folder, report);
  } catch (const std::exception& error) {
    report({file, "", error.what(), "", 0});
  }
  std::fflush(nullptr);
  _exit(0);
}

std::vector<ScenarioResult> wait_for(Worker& worker) {
  std::vector<ScenarioResult> results = from_lines(worker.process.read_all());
  const ChildProcess::Ending ending = worker.process.wait();
  if (ending.is_success()) return results;
  const std::string how =
      ending.signal ? fmt::format("signal {}", *ending.signal) : "a fault inside the program";
  results.push_back({worker.file, "",
                     fmt::format("{}: ended by {} in the scenario after these", worker.file, how),
                     "", 0});
  return results;
}

// Log folder of each file, named after the file; no two are the same. Throws InputError where one,
// or the default folder, is a link.
std::vector<std::string> folders_of(const std::vector<std::string>& files,
                                    const std::string& folder) {
  if (folder == default_folder) refuse_links("", folder);
  std::vector<std::string> folders;
  std::set<std::string> taken;
  for (const std::string& file : files) taken.insert(fs::path(file).stem());
  std::set<std::string> begun;
  for (const std::string& file : files) {
    const std::string stem = fs::path(file).stem();
    std::string name = stem;
    // A second file of the same name gets a number that makes its folder unique.
    if (!begun.insert(stem).second) {
      for (int number = 2; !taken.insert(name).second; ++number) {
        name = fmt::format("{}_{}", stem, number);
      }
    }
    refuse_links(folder, name);
    folders.push_back(fmt::format("{}/{}", folder, name));
  }
  return folders;
}

// Files as given; folders are searched for *.lua. Throws InputError.
std::vector<std::string> files_of(const std::vector<std::string>& paths) {
  std::vector<std::string> files;
  for (const std::string& path : paths) {
    if (fs::is_regular_file(path)) {
      files.push_back(path);
      continue;
    }
    if (!fs::is_directory(path)) {
      throw InputError({}, fmt::format("{}: there is no such file or folder of scenarios", path));
    }
    std::vector<std::string> found;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path)) {
      if (entry.path().extension() == ".lua") found.push_back(entry.path());
    }
    std::ranges::sort(found);
    files.insert(files.end(), found.begin(), found.end());
  }
  if (files.empty()) throw InputError({}, "there is no scenario: no *.lua in the folder");
  return files;
}

// Title on one line, escaped so that TAP finds no directive in it.
std::string title(const ScenarioResult& r) {
  std::string text;
  for (const char c : r.name.empty() ? r.file : fmt::format("{}: {}", r.file, r.name)) {
    if (c == '#' || c == '\\') text += '\\';
    text += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return text;
}

std::string indented(const std::string& text, const std::string& by) {
  std::string lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines += by + text.substr(at, end - at) + "\n";
    at = end + 1;
  }
  return lines;
}

// Test Anything Protocol 14.
std::string tap(std::size_t number, const ScenarioResult& r) {
  std::string text = fmt::format("{} {} - {} # {:.1f} s\n", r.failure.empty() ? "ok" : "not ok",
                                 number, title(r), r.wall_s);
  if (r.failure.empty()) return text;
  text += "  ---\n  message: |\n" + indented(r.failure, "    ");
  if (!r.log.empty()) text += fmt::format("  log: {}\n", r.log);
  return text + "  ...\n";
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\n':
        out += "&#10;";
        break;
      default:
        out += static_cast<unsigned char>(c) < ' ' ? '?' : c;  // XML allows no other
    }
  }
  return out;
}

std::string junit(const std::vector<ScenarioResult>& results) {
  const auto failed =
      std::ranges::count_if(results, [](const ScenarioResult& r) { return !r.failure.empty(); });
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"lsos-host\" tests=\"{}\" "
      "failures=\"{}\">\n",
      results.size(), failed);
  for (const ScenarioResult& r : results) {
    text += fmt::format("  <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\"", escaped(r.file),
                        escaped(r.name), r.wall_s);
    text += r.failure.empty() ? "/>\n"
                              : fmt::format(">\n    <failure message=\"{}\"/>\n  </testcase>\n",
                                            escaped(r.failure));
  }
  return text + "</testsuite>\n";
}

int test_command(const TestOptions& options) {
  const std::vector<std::string> files = files_of(options.paths);
  std::vector<ScenarioResult> results;
  if (!options.is_json) print_result("TAP version 14\n");
  const auto add = [&](Worker& worker) {
    for (ScenarioResult& result : wait_for(worker)) {
      results.push_back(std::move(result));
      if (!options.is_json) print_result("{}", tap(results.size(), results.back()));
    }
    std::fflush(stdout);
  };
  // Results are printed in the order of the files, whichever ends first.
  std::deque<Worker> running;
  const std::vector<std::string> folders = folders_of(files, options.folder);
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (running.size() >= static_cast<std::size_t>(options.threads)) {
      add(running.front());
      running.pop_front();
    }
    running.push_back(start(files[i], folders[i], options));
  }
  for (Worker& worker : running) add(worker);
  if (!options.is_json) print_result("1..{}\n", results.size());
  if (options.is_json) {
    nlohmann::json list = nlohmann::json::array();
    for (const ScenarioResult& result : results) list.push_back(to_json(result));
    print_result("{}\n", list.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  }
  if (!options.junit_file.empty()) write_file(options.junit_file, junit(results));
  if (results.empty())
    throw InputError({}, fmt::format("no scenario has '{}' in its name", options.filter));
  const bool has_failed =
      std::ranges::any_of(results, [](const ScenarioResult& r) { return !r.failure.empty(); });
  return has_failed ? 1 : 0;
}

}  // namespace

std::function<int()> prepare_test(CommandOptions& command) {
  const auto options = std::make_shared<TestOptions>();
  command.add_option("PATH", options->paths, "Files, or folders of them (tests/scenarios)");
  command.add_option("--filter", options->filter, "Only those with this in their name or file");
  command.add_option("--junit", options->junit_file, "Write the results as JUnit XML too");
  command.add_option("-o,--output", options->folder, "Logs of those that fail (out/scenarios)");
  add_threads(command, options->threads, "Files at a time (2)");
  command.add_flag("--json", options->is_json, "The results as JSON, in place of TAP");
  return [options] { return test_command(*options); };
}

}  // namespace lsos
