#include "picture/lettering.h"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace lsos {

namespace {

// Locations of the font in Debian, Fedora and Arch.
constexpr std::array font_files{
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
    "/usr/share/fonts/TTF/DejaVuSans.ttf",
};

void blend(const RgbCanvas& canvas, int x, int y, const Rgb& colour, double cover) {
  if (x < 0 || y < 0 || x >= canvas.width_px || y >= canvas.height_px) return;
  std::uint8_t* pixel =
      canvas.rgb->data() + 3 * (static_cast<std::ptrdiff_t>(y) * canvas.width_px + x);
  for (std::size_t k = 0; k < 3; ++k) {
    pixel[k] = static_cast<std::uint8_t>(std::lround(pixel[k] + cover * (colour[k] - pixel[k])));
  }
}

// Decodes UTF-8; bytes that are not UTF-8 stand for themselves.
std::vector<char32_t> characters(const std::string& text) {
  std::vector<char32_t> found;
  for (std::size_t i = 0; i < text.size();) {
    const auto first = static_cast<unsigned char>(text[i++]);
    int more = first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : first >= 0xc0 ? 1 : 0;
    char32_t c = more == 0 ? first : first & (0x3fu >> more);
    for (; more > 0 && i < text.size(); --more) {
      c = c << 6 | (static_cast<unsigned char>(text[i++]) & 0x3fu);
    }
    found.push_back(c);
  }
  return found;
}

}  // namespace

struct Lettering::Font {
  FT_Library library = nullptr;
  FT_Face face = nullptr;

  // Loads a glyph: its bitmap and its advance to the next one.
  FT_GlyphSlot load(char32_t character, int size_px) const {
    FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(size_px));
    LSOS_ASSERT(FT_Load_Char(face, character, FT_LOAD_RENDER | FT_LOAD_TARGET_LIGHT) == 0);
    return face->glyph;
  }
};

void fill(const RgbCanvas& canvas, const PixelBox& box, const Rgb& colour, double cover) {
  for (int y = box.top; y < box.top + box.height; ++y) {
    for (int x = box.left; x < box.left + box.width; ++x) blend(canvas, x, y, colour, cover);
  }
}

Lettering::Lettering() : font_(std::make_unique<Font>()) {
  LSOS_ASSERT(FT_Init_FreeType(&font_->library) == 0);
  for (const char* file : font_files) {
    if (FT_New_Face(font_->library, file, 0, &font_->face) == 0) return;
  }
  FT_Done_FreeType(font_->library);
  throw InputError({},
                   "the font DejaVuSans.ttf, for the captions of pictures, is not installed: "
                   "apt-get install fonts-dejavu-core");
}

Lettering::~Lettering() {
  FT_Done_Face(font_->face);
  FT_Done_FreeType(font_->library);
}

int Lettering::width_px(const std::string& text, int size_px) {
  FT_Pos width = 0;
  for (const char32_t c : characters(text)) width += font_->load(c, size_px)->advance.x;
  return static_cast<int>((width + 63) / 64);
}

void Lettering::write(const RgbCanvas& canvas, const std::string& text, int left, int baseline,
                      int size_px, const Rgb& colour) {
  FT_Pos at = static_cast<FT_Pos>(left) * 64;
  for (const char32_t c : characters(text)) {
    const FT_GlyphSlot glyph = font_->load(c, size_px);
    const FT_Bitmap& bitmap = glyph->bitmap;
    for (int y = 0; y < static_cast<int>(bitmap.rows); ++y) {
      for (int x = 0; x < static_cast<int>(bitmap.width); ++x) {
        blend(canvas, static_cast<int>(at / 64) + glyph->bitmap_left + x,
              baseline - glyph->bitmap_top + y, colour,
              bitmap.buffer[y * bitmap.pitch + x] / 255.0);
      }
    }
    at += glyph->advance.x;
  }
}

}  // namespace lsos
