// `lsos-host repl`: a prompt with editing and history on a terminal; piped input is run as a
// script.
#include <editline/readline.h>
#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "base/console.h"
#include "base/output_file.h"
#include "base/stop_signal.h"
#include "lua/app/commands.h"
#include "lua/session/repl.h"

namespace lsos {

namespace {

Repl* completed_by = nullptr;  // the one prompt of the process
volatile std::sig_atomic_t is_interrupted = 0;

char* next_completion(const char*, int state) {
  static std::vector<std::string> found;
  static std::size_t next = 0;
  if (state == 0) {
    found =
        completed_by->completions(std::string(rl_line_buffer, static_cast<std::size_t>(rl_point)));
    next = 0;
  }
  return next < found.size() ? strdup(found[next++].c_str()) : nullptr;
}

char** complete(const char* text, int, int) {
  rl_attempted_completion_over = 1;  // never complete file names
  return rl_completion_matches(text, next_completion);
}

std::string history_file() {
  const char* home = std::getenv("HOME");
  return home == nullptr ? "" : std::string(home) + "/.lsos_history";
}

int run_terminal(Repl& repl) {
  completed_by = &repl;
  rl_readline_name = const_cast<char*>("lsos-host");
  rl_attempted_completion_function = complete;
  rl_basic_word_break_characters = const_cast<char*>(" \t\n\"'(){}[]=,;+-*/<>~");
  using_history();
  const std::string history = history_file();
  if (!history.empty()) read_history(history.c_str());
  std::string text;
  for (;;) {
    is_interrupted = 0;
    char* line = readline(text.empty() ? "> " : ">> ");
    if (line == nullptr && is_interrupted != 0) {  // discard the unfinished input
      text.clear();
      std::clearerr(stdin);
      print_result("\n");
      continue;
    }
    if (line == nullptr) break;
    text += (text.empty() ? "" : "\n") + std::string(line);
    if (*line != '\0') add_history(line);
    std::free(line);
    const Repl::Outcome outcome = repl.run(text);
    if (outcome == Repl::Outcome::ended) break;
    if (outcome != Repl::Outcome::incomplete) text.clear();
  }
  if (!history.empty()) write_history(history.c_str());
  print_result("\n");
  return 0;
}

// Runs standard input as a script. All errors are printed; the exit code is 1 if there was any.
int run_piped_input(Repl& repl) {
  bool has_failed = false;
  int number = 0, first = 1;
  std::string text;
  for (std::string line; std::getline(std::cin, line);) {
    ++number;
    text += (text.empty() ? "" : "\n") + line;
    const Repl::Outcome outcome = repl.run(text, first);
    if (outcome == Repl::Outcome::incomplete) continue;
    if (outcome == Repl::Outcome::ended) return has_failed ? 1 : 0;
    has_failed |= outcome == Repl::Outcome::failed;
    text.clear();
    first = number + 1;
  }
  if (!text.empty()) {
    print_result("prompt:{}: the input ends within this\n", first);
    has_failed = true;
  }
  return has_failed ? 1 : 0;
}

int repl_command(const std::string& plan_file) {
  const std::string name =
      plan_file.empty() ? "prompt" : std::filesystem::path(plan_file).stem().string();
  const std::string folder = "out/repl/" + name;
  refuse_links("", folder);
  Repl repl(plan_file, folder, [](const std::string& text) {
    print_result("{}\n", text);
    flush_results();
  });
  catch_signal(SIGINT, [](int) {
    is_interrupted = 1;
    SimSession::interrupt();
  });
  return isatty(STDIN_FILENO) != 0 ? run_terminal(repl) : run_piped_input(repl);
}

}  // namespace

std::function<int()> prepare_repl(CommandOptions& command) {
  const auto options = std::make_shared<std::string>();
  command.add_option("PLAN", *options, "A plan: KML, KMZ or GeoPackage");
  return [options] { return repl_command(*options); };
}

}  // namespace lsos
