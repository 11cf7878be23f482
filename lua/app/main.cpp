// The command line of lsos-host.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <csignal>
#include <filesystem>
#include <new>
#include <sstream>
#include <system_error>

#include "base/console.h"
#include "base/error.h"
#include "base/output_error.h"
#include "base/stop_signal.h"
#include "lua/app/commands.h"
#include "lua/app/common_options.h"
#include "lua/host/version.h"

namespace {

using lsos::InputError;

// `lsos-host PLAN.kml ...` is `lsos-host run PLAN.kml ...`; for anything else that is no command
// the nearest one is suggested.
void insert_run(std::vector<std::string>& arguments) {
  if (arguments.empty()) return;
  if (arguments.front() == "help") {  // "help run" is "run --help"
    arguments.erase(arguments.begin());
    arguments.emplace_back("--help");
  }
  const std::string& first = arguments.front();
  if (first == "-h" || first == "--help" || first == "--version") return;
  std::vector<std::string> known;
  for (const lsos::Command& command : lsos::commands()) known.emplace_back(command.name);
  if (std::ranges::count(known, first) > 0) return;
  std::error_code ignored;
  if (first.starts_with('-') || std::filesystem::exists(first, ignored)) {
    arguments.insert(arguments.begin(), "run");
    return;
  }
  throw InputError({}, fmt::format("'{}' is neither a command nor a readable plan{}", first,
                                   lsos::did_you_mean(first, known)));
}

// Options of the command that was given which its unknown ones may mean: a line each. Names are
// compared without their dashes, which all of them have in common.
std::string meant_options(const CLI::App& app) {
  std::string text;
  for (const CLI::App* command : app.get_subcommands()) {
    std::vector<std::string> known;
    for (const CLI::Option* option : command->get_options()) {
      if (option->get_group().empty()) continue;  // hidden
      for (const std::string& name : option->get_lnames()) known.push_back(name);
    }
    std::vector<std::string> unknown = command->remaining();
    std::ranges::reverse(unknown);
    for (const std::string& argument : unknown) {
      if (!argument.starts_with("--")) continue;
      const std::string name = argument.substr(0, argument.find('='));
      std::string meant = lsos::did_you_mean(std::string_view(name).substr(2), known);
      if (meant.empty()) continue;
      meant.insert(meant.find('\'') + 1, "--");
      text +=
          fmt::format("{}: there is no such option of '{}'{}\n", name, command->get_name(), meant);
    }
  }
  return text;
}

int run_program(std::vector<std::string> arguments) {
  insert_run(arguments);
  CLI::App app("Simulates planetary surface missions that are drawn on a map.", "lsos-host");
  app.set_version_flag("--version", lsos::program_version);
  app.require_subcommand(1);
  app.footer("lsos-host PLAN.kml is short for lsos-host run PLAN.kml.");
  // Every command accepts options that any command may be given, so that shell scripts need not
  // know which command uses them.
  bool is_quiet = false;
  int threads = 1;
  lsos::AccessOptions access;
  std::vector<std::pair<CLI::App*, std::function<int()>>> prepared;
  for (const lsos::Command& command : lsos::commands()) {
    CLI::App* subcommand = app.add_subcommand(command.name, command.sentence);
    lsos::CommandOptions options(*subcommand);
    prepared.emplace_back(subcommand, command.prepare(options));
    if (!options.has_option("--quiet")) options.add_flag("--quiet", is_quiet, "").hidden();
    if (!options.has_option("--threads")) lsos::add_threads(options, threads, "").hidden();
    lsos::add_access(options, access);
  }

  try {
    std::ranges::reverse(arguments);  // the order that CLI11 expects
    app.parse(arguments);
  } catch (const CLI::ParseError& error) {
    std::ostringstream result, message;
    const int code = app.exit(error, result, message);
    lsos::write_result(result.str());
    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) message << meant_options(app);
    lsos::write_message(message.str());
    return code == 0 ? 0 : 2;
  }
  lsos::restrict_to(access);
  const auto chosen =
      std::ranges::find_if(prepared, [](const auto& entry) { return entry.first->parsed(); });
  return chosen->second();
}

// Whether the machine is at fault, and not a path.
bool is_of_machine(const std::error_code& code) {
  constexpr std::array kinds{
      std::errc::no_space_on_device,  std::errc::io_error,
      std::errc::file_too_large,      std::errc::not_enough_memory,
      std::errc::too_many_files_open, std::errc::too_many_files_open_in_system};
  return std::ranges::any_of(kinds, [&](std::errc kind) { return code == kind; });
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);
  // Beyond a file size limit a write must fail and be reported, not kill the program.
  std::signal(SIGXFSZ, SIG_IGN);
  lsos::catch_fatal_signals();
  lsos::open_missing_streams();
  try {
    const int code = run_program({argv + 1, argv + argc});
    lsos::flush_results();
    return code;
  } catch (const InputError& error) {
    lsos::print_message("{}\n", error.what());
    return 2;
  } catch (const std::filesystem::filesystem_error& error) {
    // Usually a folder that may not be entered.
    lsos::print_message("{}: {}\n", error.path1().string(), error.code().message());
    return is_of_machine(error.code()) ? 3 : 2;
  } catch (const lsos::OutputError& error) {
    lsos::print_message("{}\n", error.what());
    return 3;
  } catch (const std::bad_alloc&) {
    lsos::print_message("out of memory\n");
    return 3;
  } catch (const std::exception& error) {
    lsos::print_message("fault inside the program: {}\n", error.what());
    return 3;
  }
}
