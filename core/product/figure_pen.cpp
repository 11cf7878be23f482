#include "product/figure_pen.h"

#include <cairo/cairo.h>

#include <cmath>
#include <vector>

#include "base/error.h"
#include "picture/png.h"

namespace lsos {

namespace {

constexpr double mm_per_inch = 25.4;

void set_colour(cairo_t* cairo, const std::string& colour) {
  const auto part = [&](std::size_t at) {
    return std::stoi(colour.substr(at, 2), nullptr, 16) / 255.0;
  };
  cairo_set_source_rgb(cairo, part(1), part(3), part(5));
}

void set_stroke(cairo_t* cairo, const Stroke& stroke) {
  set_colour(cairo, stroke.colour);
  cairo_set_line_width(cairo, stroke.width_mm);
  cairo_set_dash(cairo, stroke.dashes_mm.data(), static_cast<int>(stroke.dashes_mm.size()), 0);
}

void add_box(cairo_t* cairo, const PaperBox& box) {
  cairo_rectangle(cairo, box.left_mm, box.top_mm, box.width_mm, box.height_mm);
}

}  // namespace

struct FigurePen::Sheet {
  cairo_surface_t* surface = nullptr;
  cairo_t* cairo = nullptr;

  void set_font(double size_mm, bool is_bold) const {
    cairo_select_font_face(cairo, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           is_bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo, size_mm);
  }
  double width_mm(const std::string& text) const {
    cairo_text_extents_t extents;
    cairo_text_extents(cairo, text.c_str(), &extents);
    return extents.x_advance;
  }
};

FigurePen::FigurePen(double width_mm, double height_mm, int dpi)
    : sheet_(std::make_unique<Sheet>()) {
  const double scale = dpi / mm_per_inch;
  // Cairo's limit on width and height of a picture.
  constexpr double pixels_max = 32767;
  if (scale * std::max(width_mm, height_mm) > pixels_max) {
    throw InputError(
        {}, fmt::format("--dpi {}: the figure is {:.0f} mm by {:.0f} mm; {:.0f} dpi at "
                        "most make a picture of it",
                        dpi, width_mm, height_mm,
                        std::floor(pixels_max * mm_per_inch / std::max(width_mm, height_mm))));
  }
  sheet_->surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                               static_cast<int>(std::lround(width_mm * scale)),
                                               static_cast<int>(std::lround(height_mm * scale)));
  LSOS_ASSERT(cairo_surface_status(sheet_->surface) == CAIRO_STATUS_SUCCESS);
  sheet_->cairo = cairo_create(sheet_->surface);
  cairo_scale(sheet_->cairo, scale, scale);
  cairo_set_line_join(sheet_->cairo, CAIRO_LINE_JOIN_ROUND);
  // Glyphs are placed by millimetres, not snapped to whole pixels.
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_set_font_options(sheet_->cairo, options);
  cairo_font_options_destroy(options);
  fill({0, 0, width_mm + 1, height_mm + 1}, "#ffffff");
}

FigurePen::~FigurePen() {
  cairo_destroy(sheet_->cairo);
  cairo_surface_destroy(sheet_->surface);
}

void FigurePen::fill(const PaperBox& box, const std::string& colour) {
  set_colour(sheet_->cairo, colour);
  add_box(sheet_->cairo, box);
  cairo_fill(sheet_->cairo);
}

void FigurePen::frame(const PaperBox& box, const Stroke& stroke) {
  set_stroke(sheet_->cairo, stroke);
  add_box(sheet_->cairo, box);
  cairo_stroke(sheet_->cairo);
}

void FigurePen::line(const std::vector<PaperPoint>& points, const Stroke& stroke) {
  if (points.size() < 2) return;
  set_stroke(sheet_->cairo, stroke);
  cairo_new_path(sheet_->cairo);
  for (const PaperPoint& point : points) cairo_line_to(sheet_->cairo, point.x_mm, point.y_mm);
  cairo_stroke(sheet_->cairo);
}

void FigurePen::hatch(const PaperBox& box, const Stroke& stroke, double apart_mm) {
  cairo_save(sheet_->cairo);
  add_box(sheet_->cairo, box);
  cairo_clip(sheet_->cairo);
  for (double x = box.left_mm - box.height_mm; x < box.right_mm(); x += apart_mm) {
    line({{x, box.bottom_mm()}, {x + box.height_mm, box.top_mm}}, stroke);
  }
  cairo_restore(sheet_->cairo);
}

void FigurePen::clip(const PaperBox& box) {
  cairo_reset_clip(sheet_->cairo);
  if (box.width_mm <= 0) return;
  add_box(sheet_->cairo, box);
  cairo_clip(sheet_->cairo);
}

double FigurePen::text_width_mm(const std::string& text, double size_mm) {
  sheet_->set_font(size_mm, false);
  return sheet_->width_mm(text);
}

void FigurePen::write(const std::string& text, const PaperPoint& at, double size_mm, Anchor anchor,
                      bool is_bold, bool is_upwards) {
  cairo_t* cairo = sheet_->cairo;
  sheet_->set_font(size_mm, is_bold);
  const double width_mm = sheet_->width_mm(text);
  const double share = anchor == Anchor::left ? 0 : anchor == Anchor::middle ? 0.5 : 1;
  set_colour(cairo, "#000000");
  cairo_save(cairo);
  cairo_translate(cairo, at.x_mm, at.y_mm);
  if (is_upwards) cairo_rotate(cairo, -M_PI / 2);
  cairo_move_to(cairo, -share * width_mm, 0);
  cairo_show_text(cairo, text.c_str());
  cairo_restore(cairo);
}

std::string FigurePen::png() const {
  cairo_surface_flush(sheet_->surface);
  const int width = cairo_image_surface_get_width(sheet_->surface);
  const int height = cairo_image_surface_get_height(sheet_->surface);
  const int stride = cairo_image_surface_get_stride(sheet_->surface);
  const unsigned char* data = cairo_image_surface_get_data(sheet_->surface);
  std::vector<std::uint8_t> rgb;
  rgb.reserve(3 * static_cast<std::size_t>(width) * height);
  for (int y = 0; y < height; ++y) {
    const auto* row =
        reinterpret_cast<const std::uint32_t*>(data + static_cast<std::ptrdiff_t>(y) * stride);
    for (int x = 0; x < width; ++x) {
      for (const unsigned shift : {16u, 8u, 0u})
        rgb.push_back(static_cast<std::uint8_t>(row[x] >> shift));
    }
  }
  return png_bytes(width, height, rgb);
}

}  // namespace lsos
