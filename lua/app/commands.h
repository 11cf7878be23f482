// The program's commands, each in its own file command_NAME.cpp.
#pragma once

#include <functional>
#include <vector>

#include "lua/app/command_options.h"

namespace lsos {

struct Command {
  const char* name;
  const char* sentence;  // what it does, for help
  // Adds its options, and returns the function that runs it once they are read. This function
  // returns the exit code: 0 completed, 1 an event failed or is incomplete, 130/143 stopped by a
  // signal; it throws InputError where what it was given is wrong.
  std::function<int()> (*prepare)(CommandOptions& command);
};

// In the order of help. A new command is a file, its prepare_NAME below and a line in commands.cpp.
const std::vector<Command>& commands();

std::function<int()> prepare_run(CommandOptions& command);
std::function<int()> prepare_resume(CommandOptions& command);
std::function<int()> prepare_branch(CommandOptions& command);
std::function<int()> prepare_check(CommandOptions& command);
std::function<int()> prepare_edit(CommandOptions& command);
std::function<int()> prepare_fsm(CommandOptions& command);
std::function<int()> prepare_list(CommandOptions& command);
std::function<int()> prepare_test(CommandOptions& command);
std::function<int()> prepare_repl(CommandOptions& command);
std::function<int()> prepare_schema(CommandOptions& command);
std::function<int()> prepare_import(CommandOptions& command);
std::function<int()> prepare_export(CommandOptions& command);
std::function<int()> prepare_new(CommandOptions& command);
std::function<int()> prepare_overlay(CommandOptions& command);
std::function<int()> prepare_rig(CommandOptions& command);
std::function<int()> prepare_terrain(CommandOptions& command);
std::function<int()> prepare_light(CommandOptions& command);
std::function<int()> prepare_sight(CommandOptions& command);
std::function<int()> prepare_picture(CommandOptions& command);
std::function<int()> prepare_report(CommandOptions& command);
std::function<int()> prepare_compare(CommandOptions& command);
std::function<int()> prepare_verify(CommandOptions& command);
std::function<int()> prepare_sun(CommandOptions& command);
std::function<int()> prepare_sweep(CommandOptions& command);  // in lua/study

}  // namespace lsos
