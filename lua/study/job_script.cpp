#include "lua/study/job_script.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string_view>

#include "base/error.h"
#include "base/files.h"
#include "base/replaced.h"
#include "lua/app/common_options.h"
#include "lua/host/script_folders.h"
#include "study/filled_template.h"
#include "study/shell_word.h"

namespace lsos {

namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

// An engine, and the file of its template. Most are scripts of a shell.
struct Engine {
  std::string name, file;
  bool has_shell = true;
};

const std::vector<Engine>& all_engines() {
  static const std::vector<Engine> table{{"slurm", "slurm.sh"},
                                         {"pbs", "pbs.sh"},
                                         {"sge", "sge.sh"},
                                         {"condor", "condor.sub", false},
                                         {"parallel", "parallel.sh"}};
  return table;
}

// A site's own template in a folder of LSOS_PATH comes first. One beside the study does not count:
// whoever sends a study would choose what runs on the cluster.
std::string template_file(const Engine& engine) {
  const char* path = std::getenv("LSOS_PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  std::error_code absent;
  for (std::string folder; std::getline(folders, folder, ':');) {
    std::string file = folder + "/cluster/" + engine.file;
    if (!folder.empty() && fs::exists(file, absent)) return file;
  }
  return shipped_scripts() + "/cluster/" + engine.file;
}

// What a batch system takes as the name of a job: a letter first, no other characters than these.
std::string job_name(const Engine& engine, const std::string& name) {
  const std::size_t length_max = engine.name == "pbs" ? 15 : std::string::npos;
  constexpr std::string_view letters =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";
  std::string plain = name;
  std::ranges::replace_if(
      plain, [&](char c) { return letters.find(c) == std::string_view::npos; }, '_');
  const bool has_letter = letters.substr(0, 52).find(plain[0]) != std::string_view::npos;
  return (has_letter ? plain : "s" + plain).substr(0, length_max);
}

// Whether a shell takes it as the name of a variable.
bool is_name(std::string_view name) {
  constexpr std::string_view others = "_0123456789";
  return !name.empty() && std::ranges::all_of(name, [&](char c) {
    return (c >= 'A' && c <= 'Z') || others.find(c) != std::string_view::npos;
  });
}

// The working folder as the user's shell calls it.
std::string working_folder() {
  const char* shown = std::getenv("PWD");
  std::error_code absent;
  const bool is_it = shown != nullptr && *shown == '/' && fs::equivalent(shown, ".", absent);
  return is_it ? shown : fs::current_path().string();
}

// Variables of this process that the cases would miss on another machine, as NAME=VALUE.
Words carried_environment() {
  constexpr std::array<std::string_view, 5> others{"GDAL_DATA", "GDAL_DRIVER_PATH",
                                                   "LD_LIBRARY_PATH", "PROJ_DATA", "PROJ_LIB"};
  Words carried;
  for (char** each = environ; *each != nullptr; ++each) {
    const std::string_view variable = *each, name = variable.substr(0, variable.find('='));
    const bool is_ours =
        name.starts_with("LSOS_") && name.size() < variable.size() && is_name(name);
    if (is_ours || std::ranges::count(others, name) > 0) carried.emplace_back(variable);
  }
  std::ranges::sort(carried);
  return carried;
}

// In an HTCondor value; a $ would begin a macro.
std::string condor_text(const std::string& text) { return replaced(text, "$", "$(DOLLAR)"); }

// Words within the double quotes of HTCondor's arguments and environment.
std::string condor_words(const Words& words) {
  std::string all;
  for (const std::string& word : words) {
    if (!all.empty()) all += ' ';
    const bool is_plain = !word.empty() && word.find_first_of(" \t'") == std::string::npos;
    const std::string text = replaced(condor_text(word), "\"", "\"\"");
    all += is_plain ? text : "'" + replaced(text, "'", "''") + "'";
  }
  return all;
}

// "NAME='VALUE'", which a shell's export takes.
std::string shell_assignment(const std::string& variable) {
  const std::size_t equal = variable.find('=');
  return variable.substr(0, equal + 1) + shell_word(variable.substr(equal + 1));
}

// Time in which a stopped case can write its checkpoint.
constexpr std::int64_t warning_s = 120;
static_assert(2 * warning_s < time_min_s);

// A submit file has no quotes around these.
void refuse_for_condor(const std::string& file) {
  constexpr std::string_view blanks = " \t";
  const auto is_blank = [&](char c) { return blanks.find(c) != std::string_view::npos; };
  if (file.back() != '\\' && !is_blank(file.back())) return;
  throw InputError({file},
                   "its name ends in a backslash or a blank, and a submit file of HTCondor cannot "
                   "hold such a name");
}

// What sets a shell's folder and variables for the command after it.
std::string surroundings_command() {
  Words words{"env"};
  std::ranges::copy(carried_environment(), std::back_inserter(words));
  return fmt::format("cd {} && {} ", shell_word(working_folder()), shell_command(words));
}

class ScriptValues {
 public:
  void add(const std::string& name, std::string value) {
    values_[name].push_back(std::move(value));
  }
  void add(const std::string& name, std::int64_t value) { add(name, fmt::format("{}", value)); }
  void add_if(bool is_given, const std::string& name, std::string value) {
    values_[name];
    if (is_given) add(name, std::move(value));
  }
  void add_all(const std::string& name, Words values) { values_[name] = std::move(values); }

  const TemplateValues& all() const { return values_; }

 private:
  TemplateValues values_;
};

void refuse_line_breaks(const TemplateValues& values) {
  for (const auto& [name, all] : values) {
    for (const std::string& value : all) {
      if (value.find_first_of("\r\n") == std::string::npos) continue;
      throw InputError(
          {}, fmt::format("{}: has a line break, which no script of a job can hold", value));
    }
  }
}

// An option without a gap in the template would be lost.
void refuse_unused(const Engine& engine, const ClusterOptions& options, const std::string& retry,
                   const std::string& text) {
  const auto check = [&](bool is_given, const char* option,
                         std::initializer_list<const char*> names) {
    const bool is_used = std::ranges::any_of(names, [&](const char* name) {
      return text.find(fmt::format("{{{{{}}}}}", name)) != std::string::npos;
    });
    if (!is_given || is_used) return;
    throw InputError({}, fmt::format("{}: a script for {} has no use for it", option, engine.name));
  };
  check(options.limit > 0, "--limit", {"limit", "array", "submit"});
  check(!options.time.empty(), "--time", {"time", "time_s", "working_s"});
  check(!options.partition.empty(), "--partition", {"partition"});
  check(!options.directives.empty(), "--directive", {"directive"});
  check(!retry.empty(), "--retry", {"retry", "arguments"});
}

void add_commands(const Engine& engine, const StudyFiles& files, const std::string& folder,
                  const SweepOptions& options, const std::string& retry, ScriptValues& values) {
  const std::string program = fs::read_symlink("/proc/self/exe").string();
  const std::string study = path_from_root(files.study.file), output = path_from_root(folder);
  Words run{"sweep", "run", study, "-o", output, "--quiet"};
  Words gather{"sweep", "gather", study, "-o", output};
  const int jobs = std::max(1, options.jobs), threads = std::max(1, options.threads);
  run.insert(run.end(), {"-j", std::to_string(jobs), "--threads", std::to_string(threads)});
  gather.insert(gather.end(), {"--threads", std::to_string(jobs * threads)});
  for (Words* words : {&run, &gather}) {
    words->insert(words->end(), access_words().begin(), access_words().end());
  }
  values.add("processors", std::int64_t{jobs} * threads);
  values.add_if(jobs * threads > 1, "slots", std::to_string(jobs * threads));
  values.add("program", engine.has_shell ? shell_word(program) : condor_text(program));
  Words arguments = run;
  const Words again{"--retry", retry};
  if (!retry.empty()) arguments.insert(arguments.end(), again.begin(), again.end());
  values.add("arguments", engine.has_shell ? shell_command(arguments) : condor_words(arguments));
  values.add_if(!retry.empty(), "retry", shell_command(again));
  for (Words* words : {&run, &gather}) words->insert(words->begin(), program);
  values.add("run", shell_command(run));
  // No script of a shell has set the surroundings of that of HTCondor.
  values.add("gather", (engine.has_shell ? "" : surroundings_command()) + shell_command(gather));
}

void add_surroundings(const Engine& engine, ScriptValues& values) {
  const std::string folder = working_folder();
  if (!engine.has_shell) refuse_for_condor(folder);
  values.add("folder", engine.has_shell ? shell_word(folder) : condor_text(folder));
  Words variables = carried_environment();
  if (engine.has_shell) {
    std::ranges::transform(variables, variables.begin(), shell_assignment);
    values.add_all("environment", std::move(variables));
  } else {
    values.add("environment", condor_words(variables));
  }
}

void add_limits(const ClusterOptions& options, ScriptValues& values) {
  const std::int64_t limit_s = time_limit_s(options.time).value_or(0);
  const bool is_limited = limit_s > 0;
  const auto text = [](std::int64_t value) { return fmt::format("{}", value); };
  values.add("warning_s", warning_s);
  values.add_if(is_limited, "time_s", text(limit_s));
  values.add_if(is_limited, "working_s", text(limit_s - warning_s));
  values.add_if(is_limited, "time",
                fmt::format("{}:{:02}:{:02}", limit_s / 3600, limit_s / 60 % 60, limit_s % 60));
  values.add_if(options.limit > 0, "limit", text(options.limit));
  values.add_if(!options.partition.empty(), "partition", options.partition);
  values.add_all("directive", options.directives);
}

}  // namespace

const std::vector<std::string>& engines() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Engine& engine : all_engines()) all.push_back(engine.name);
    return all;
  }();
  return names;
}

std::string path_from_root(const std::string& path) {
  return (fs::path(working_folder()) / path).string();
}

std::string job_script(const std::string& engine_name, const StudyFiles& files,
                       const std::string& folder, const SweepOptions& options,
                       const JobTasks& tasks) {
  const Engine& engine = *std::ranges::find(all_engines(), engine_name, &Engine::name);
  const std::string file = template_file(engine);
  const std::optional<std::string> text = read_file(file);
  if (!text) throw InputError({file}, "cannot be read; it is the template of the script");
  refuse_unused(engine, options.cluster, tasks.retry, *text);
  ScriptValues values;
  values.add("name", job_name(engine, files.study.name));
  values.add("case_count", tasks.case_count);
  values.add("task_count", static_cast<std::int64_t>(tasks.cases.size()));
  // PBS knows no array of one task.
  const std::size_t last =
      engine.name == "pbs" ? std::max<std::size_t>(2, tasks.cases.size()) : tasks.cases.size();
  const std::string range = fmt::format("1-{}", last);
  const int limit = options.cluster.limit;
  const char* before_limit = engine.name == "sge" ? " -tc " : "%";
  values.add("range", range);
  values.add("array", limit > 0 ? fmt::format("{}{}{}", range, before_limit, limit) : range);
  values.add_all("submit", tasks.submit);
  values.add_all("task", tasks.cases);
  add_commands(engine, files, folder, options, tasks.retry, values);
  add_surroundings(engine, values);
  add_limits(options.cluster, values);
  refuse_line_breaks(values.all());
  return filled_template(*text, values.all(), file);
}

}  // namespace lsos
