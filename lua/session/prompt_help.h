// help() at the prompt, from the registry that also makes the binding and lua/README.md.
#pragma once

#include <string>

#include "lua/runtime/handle.h"

namespace lsos {

std::string general_help();
std::string help_of(const HandleType& type);

// Help for a function, constant, constructor, object or method by its name: "sleep", "lsos.sleep",
// "ev", "run_for", "sim:run_for". For an unknown name it suggests the nearest one.
std::string help_of(const std::string& name);

}  // namespace lsos
