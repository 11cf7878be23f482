// The program's commands, each in its own file command_NAME.cpp.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <vector>

namespace lsos {

struct Command {
  const char* name;
  const char* sentence;  // what it does, for help
  // Adds its options, and returns what runs it once they are read. That returns the exit code:
  // 0 completed, 1 an event failed or is incomplete, 130/143 stopped by a signal; it throws
  // InputError where what it was given is wrong.
  std::function<int()> (*prepare)(CLI::App& app);
};

// In the order of help. A new command is a file and a line here.
const std::vector<Command>& commands();

std::function<int()> prepare_run(CLI::App& app);
std::function<int()> prepare_check(CLI::App& app);
std::function<int()> prepare_fsm(CLI::App& app);
std::function<int()> prepare_list(CLI::App& app);
std::function<int()> prepare_test(CLI::App& app);
std::function<int()> prepare_repl(CLI::App& app);
std::function<int()> prepare_schema(CLI::App& app);
std::function<int()> prepare_new(CLI::App& app);
std::function<int()> prepare_overlay(CLI::App& app);
std::function<int()> prepare_rig(CLI::App& app);
std::function<int()> prepare_terrain(CLI::App& app);
std::function<int()> prepare_light(CLI::App& app);
std::function<int()> prepare_sight(CLI::App& app);
std::function<int()> prepare_picture(CLI::App& app);
std::function<int()> prepare_report(CLI::App& app);
std::function<int()> prepare_compare(CLI::App& app);
std::function<int()> prepare_verify(CLI::App& app);
std::function<int()> prepare_sun(CLI::App& app);

}  // namespace lsos
