// Options that several commands have.
#pragma once

#include <CLI/CLI.hpp>

#include "lua/app/instrument_answer.h"
#include "lua/app/terrain_source.h"

namespace lsos {

// A check of a seed: the library would take -1 for the greatest number.
const CLI::Validator& is_seed();

// --threads, 1 to 256.
void add_threads(CLI::App& command, int& threads, const char* what);

// How an instrument prints its answer: --json or --text.
void add_style(CLI::App& command, AnswerStyle& style);

// Which terrain, and which part of it.
void add_ground(CLI::App& command, TerrainOptions& terrain);

}  // namespace lsos
