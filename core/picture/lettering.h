// Text and boxes drawn into pictures.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace lsos {

using Rgb = std::array<std::uint8_t, 3>;

// Red, green and blue bytes, rows from the top. Does not own them.
struct RgbCanvas {
  int width_px = 0, height_px = 0;
  std::vector<std::uint8_t>* rgb = nullptr;
};

struct PixelBox {
  int left = 0, top = 0, width = 0, height = 0;
};

// Fills the part of the box that lies in the picture. `cover`: opacity, 0..1.
void fill(const RgbCanvas& canvas, const PixelBox& box, const Rgb& colour, double cover = 1);

// Writes text in the font DejaVu Sans.
class Lettering {
 public:
  // Throws InputError, with advice, when the font is not installed.
  Lettering();
  ~Lettering();
  Lettering(const Lettering&) = delete;
  Lettering& operator=(const Lettering&) = delete;

  // `text`: UTF-8. `size_px`: size of an em.
  int width_px(const std::string& text, int size_px);
  // The text begins at x = `left` on the baseline y = `baseline`.
  void write(const RgbCanvas& canvas, const std::string& text, int left, int baseline, int size_px,
             const Rgb& colour);

 private:
  struct Font;
  std::unique_ptr<Font> font_;
};

}  // namespace lsos
