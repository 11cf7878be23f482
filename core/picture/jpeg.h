// Pictures as JPEG, where size matters.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace lsos {

// `channels` 3: red, green and blue bytes; 1: grey. Rows from the top. `quality` 1..100.
std::string jpeg_bytes(int width, int height, int channels, std::span<const std::uint8_t> pixels,
                       int quality);

}  // namespace lsos
