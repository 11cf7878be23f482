// Why something was not opened: GDAL itself speaks only of a file that cannot be opened.
#pragma once

#include <string>

namespace lsos {

// Remembers the first reason on this thread since forget_refusal.
void refuse(const std::string& why);
// The remembered reason, "" when there is none.
const std::string& last_refusal();
void forget_refusal();

}  // namespace lsos
