// The text of docs/log.md: the layers and columns of a log, made from what is written.
#pragma once

#include <string>

namespace lsos {

// Markdown.
std::string log_reference();

}  // namespace lsos
