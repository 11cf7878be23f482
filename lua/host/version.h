// What the program calls itself.
#pragma once

namespace lsos {

inline constexpr const char* program_version = LSOS_VERSION;

}  // namespace lsos
