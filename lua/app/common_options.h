// Options that several commands have.
#pragma once

#include <string>
#include <vector>

#include "lua/app/command_options.h"
#include "lua/app/instrument_answer.h"
#include "lua/app/terrain_source.h"

namespace lsos {

// --threads, 1 to 256.
CommandOption add_threads(CommandOptions& command, int& threads, const char* what);

// How an instrument prints its answer: --json or --text.
void add_style(CommandOptions& command, AnswerStyle& style);

// Which terrain, and which part of it.
void add_ground(CommandOptions& command, TerrainOptions& terrain);

// What may be opened beside what the user names: --allow-files, --allow-network.
struct AccessOptions {
  std::vector<std::string> folders;
  bool has_network = false;
};
void add_access(CommandOptions& command, AccessOptions& access);

// From now on only files are opened that lie in these folders, in those of LSOS_ALLOW_FILES,
// LSOS_PATH and LSOS_REFERENCE_DATA, among the shipped ones, or beside what the user names.
void restrict_to(const AccessOptions& access);
// The options of the last call, as words of a command line.
const std::vector<std::string>& access_words();

}  // namespace lsos
