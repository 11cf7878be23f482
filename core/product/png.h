// Pictures as files.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace lsos {

// Writes red, green and blue bytes, rows from the top, as PNG. Throws InputError when the file
// cannot be written; then none is left.
void write_png(const std::string& file, int width, int height, std::span<const std::uint8_t> rgb);

}  // namespace lsos
