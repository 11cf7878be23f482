#include "picture/caption.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lsos {

namespace {

constexpr Rgb white{255, 255, 255}, grey{205, 205, 205}, black{0, 0, 0};

std::string length_text(double length_m) {
  if (length_m >= 1000) return fmt::format("{:g} km", length_m / 1000);
  if (length_m < 1) return fmt::format("{:g} cm", std::round(length_m * 100));
  return fmt::format("{:g} m", length_m);
}

// Share of the picture's width that remains beside the scale bar.
constexpr double text_share = 0.72;

// Wraps lines where three spaces separate their parts.
std::vector<std::string> wrapped(const std::vector<std::string>& lines, Lettering& letters,
                                 int size_px, int most_px) {
  constexpr std::string_view apart = "   ";
  std::vector<std::string> broken;
  for (const std::string& line : lines) {
    std::string now;
    for (std::size_t from = 0; from <= line.size();) {
      const std::size_t end = std::min(line.find(apart, from), line.size());
      const std::string part = line.substr(from, end - from);
      const std::string longer = now.empty() ? part : fmt::format("{}{}{}", now, apart, part);
      if (!now.empty() && letters.width_px(longer, size_px) > most_px) {
        broken.push_back(now);
        now = part;
      } else {
        now = longer;
      }
      from = end + apart.size();
    }
    broken.push_back(now);
  }
  return broken;
}

}  // namespace

double round_length_m(double most_m) {
  const double decade_m = std::pow(10, std::floor(std::log10(most_m)));
  for (const double digit : {5.0, 2.0}) {
    if (digit * decade_m <= most_m) return digit * decade_m;
  }
  return decade_m;
}

void add_caption(const RgbCanvas& canvas, const Caption& whole, Lettering& letters) {
  const int size_px = std::max(9, canvas.height_px / 42), margin_px = size_px;
  const int line_px = size_px * 3 / 2;
  Caption caption = whole;
  const double room = whole.metres_per_pixel > 0 ? text_share : 1;
  caption.lines = wrapped(whole.lines, letters, size_px,
                          static_cast<int>(room * canvas.width_px) - 2 * margin_px);
  const int lines = 1 + static_cast<int>(caption.lines.size());
  const int top = canvas.height_px - lines * line_px - margin_px;
  fill(canvas, {0, top, canvas.width_px, canvas.height_px - top}, black, 0.62);
  int baseline = top + margin_px / 2 + size_px;
  letters.write(canvas, caption.title, margin_px, baseline, size_px, white);
  for (const std::string& line : caption.lines) {
    baseline += line_px;
    letters.write(canvas, line, margin_px, baseline, size_px, grey);
  }
  if (caption.metres_per_pixel <= 0) return;
  const double length_m = round_length_m(0.22 * canvas.width_px * caption.metres_per_pixel);
  const int bar_px = static_cast<int>(std::lround(length_m / caption.metres_per_pixel));
  const int right = canvas.width_px - margin_px, left = right - bar_px;
  const int thick_px = std::max(1, size_px / 6), tick_px = size_px / 2;
  const int bar_top = top + margin_px / 2 + size_px - thick_px;
  fill(canvas, {left, bar_top, bar_px, thick_px}, white);
  for (const int x : {left, right - thick_px}) {
    fill(canvas, {x, bar_top + thick_px - tick_px, thick_px, tick_px}, white);
  }
  const std::string text = length_text(length_m) + " " + caption.scale_where;
  letters.write(canvas, text, right - letters.width_px(text, size_px),
                top + margin_px / 2 + size_px + line_px, size_px, white);
}

}  // namespace lsos
