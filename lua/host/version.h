// Version of the program.
#pragma once

#include <string>

namespace lsos {

inline constexpr const char* program_version = LSOS_VERSION;

// Identifies the build of the running program: the linker's hash of all that is in it. Saved state
// is read by the build that wrote it alone.
std::string program_build();

}  // namespace lsos
