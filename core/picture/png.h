// Pictures as PNG.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace lsos {

// The first bytes of a PNG.
inline constexpr std::string_view png_mark = "\x89PNG\r\n";

// Red, green and blue bytes, or with `has_alpha` grey and alpha ones; rows from the top.
std::string png_bytes(int width, int height, std::span<const std::uint8_t> pixels,
                      bool has_alpha = false);

// Writes red, green and blue bytes, rows from the top, as PNG. Throws as write_file() does.
void write_png(const std::string& file, int width, int height, std::span<const std::uint8_t> rgb);

}  // namespace lsos
