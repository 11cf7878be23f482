// Text and boxes drawn into pictures.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace lsos {

using Rgb = std::array<std::uint8_t, 3>;

// Red, green and blue bytes, rows from the top; of someone else's.
struct RgbCanvas {
  int width_px = 0, height_px = 0;
  std::vector<std::uint8_t>* rgb = nullptr;
};

struct PixelBox {
  int left = 0, top = 0, width = 0, height = 0;
};

// What lies outside the picture is left out. `cover` 0..1: 1 hides what was there.
void fill(const RgbCanvas& canvas, const PixelBox& box, const Rgb& colour, double cover = 1);

// The font DejaVu Sans.
class Lettering {
 public:
  // Throws InputError: the font is not installed; says how to.
  Lettering();
  ~Lettering();
  Lettering(const Lettering&) = delete;
  Lettering& operator=(const Lettering&) = delete;

  // UTF-8. `size_px`: of an em.
  int width_px(const std::string& text, int size_px);
  // From `left` on the line `baseline`.
  void write(const RgbCanvas& canvas, const std::string& text, int left, int baseline, int size_px,
             const Rgb& colour);

 private:
  struct Font;
  std::unique_ptr<Font> font_;
};

}  // namespace lsos
