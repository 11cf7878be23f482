// What lsos.rover makes is a RoverSpec.
#pragma once

namespace lsos {

inline constexpr const char* rover_kind = "rover";

}  // namespace lsos
