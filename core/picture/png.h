// Pictures as files.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace lsos {

// What a PNG begins with.
inline constexpr std::string_view png_mark = "\x89PNG\r\n";

// Red, green and blue bytes, or with `has_alpha` grey and alpha ones; rows from the top.
std::string png_bytes(int width, int height, std::span<const std::uint8_t> pixels,
                      bool has_alpha = false);

// Writes red, green and blue bytes, rows from the top, as PNG. Throws InputError when the file
// cannot be written; then none is left.
void write_png(const std::string& file, int width, int height, std::span<const std::uint8_t> rgb);

}  // namespace lsos
