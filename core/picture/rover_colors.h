// The colours of rovers on maps and in pictures, by their index in byte order of ids.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace lsos {

// In KML's order: blue, green, red. The first three are those of the rovers in the paper.
inline constexpr std::array<std::string_view, 8> rover_colors{
    "0000ff", "ff0000", "00c000", "00a5ff", "c000c0", "c0c000", "00ffff", "8080ff"};

}  // namespace lsos
