// help() at the prompt: of the registry that the binding and lua/README.md are made of.
#pragma once

#include <string>

#include "lua/runtime/handle.h"

namespace lsos {

std::string general_help();
std::string help_of(const HandleType& type);

// Of a function, constant, constructor, object or method by its name: "sleep", "lsos.sleep", "ev",
// "run_for", "sim:run_for". An unknown one is told which was meant.
std::string help_of(const std::string& name);

}  // namespace lsos
