// Version of the program.
#pragma once

namespace lsos {

inline constexpr const char* program_version = LSOS_VERSION;

}  // namespace lsos
