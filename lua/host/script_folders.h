// Where scripts are looked for.
#pragma once

#include <string>
#include <vector>

#include "lua/runtime/script.h"

namespace lsos {

// Beside the plan (in the working folder, when `plan_file` is ""), then each folder of `lsos_path`
// (separated by colons), then the shipped ones, which count once. Folders that do not exist are
// harmless.
std::vector<ScriptFolder> script_folders(const std::string& plan_file, const std::string& lsos_path,
                                         const std::string& shipped_folder);

// Of the tree that the program was built from.
extern const char* const source_folder;

// The folder of the shipped scripts, seen from the running program: the nearest folder above it
// that has share/lsos-host/events or events/Route.lua; otherwise `built_from`.
std::string shipped_folder(const std::string& program_file, const std::string& built_from);

// The folder of the shipped scripts, as the running program finds it.
std::string shipped_scripts();

// The file that tells editors what the lsos module has; "" where it is not installed.
std::string library_file();

}  // namespace lsos
