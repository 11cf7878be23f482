// Folders in which scripts are searched.
#pragma once

#include <string>
#include <vector>

#include "lua/runtime/script.h"

namespace lsos {

// The folder of the plan (the working folder when `plan_file` is ""), then each folder of
// `lsos_path` (separated by colons), then the shipped scripts. A folder that occurs twice counts
// once. Folders that do not exist are harmless.
std::vector<ScriptFolder> script_folders(const std::string& plan_file, const std::string& lsos_path,
                                         const std::string& shipped_folder);

// Source tree from which the program was built.
extern const char* const source_folder;

// Folder of the shipped scripts for a program: the nearest folder above it that has
// share/lsos-host/events or events/Route.lua; otherwise `built_from`.
std::string shipped_folder(const std::string& program_file, const std::string& built_from);

// Folder of the shipped scripts for the running program.
std::string shipped_scripts();

// File that describes the lsos module to editors; "" where it is not installed.
std::string library_file();

}  // namespace lsos
