// Options that several commands have.
#pragma once

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

}  // namespace lsos
