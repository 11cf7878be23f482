#include "product/overlay_icons.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "picture/png.h"

namespace lsos {

namespace {

struct Icon {
  OverlayIcon icon;
  const char *name, *on_server;
};
// In the order of the enumeration.
constexpr std::array icons{Icon{OverlayIcon::arrow, "arrow", "triangle"},
                           Icon{OverlayIcon::disc, "disc", "placemark_circle"},
                           Icon{OverlayIcon::cross, "cross", "forbidden"},
                           Icon{OverlayIcon::square, "square", "caution"},
                           Icon{OverlayIcon::diamond, "diamond", "open-diamond"}};

const Icon& known(OverlayIcon icon) { return icons.at(static_cast<std::size_t>(icon)); }

// Signed distance of a point from the shape's edge, or a bound on it; negative inside. x is east
// and y south of the icon's centre, in units of half its width.
double distance(OverlayIcon icon, double x, double y) {
  const double across = std::abs(x), size = 0.72;
  const double diagonal = (std::abs(x) + std::abs(y)) * std::numbers::sqrt2 / 2;
  switch (icon) {
    case OverlayIcon::arrow: {
      // Sides from the tip (0, -0.85) to the feet (0.65, 0.8), with a notch at the tail.
      const double side = (across * 1.65 - (y + 0.85) * 0.65) / std::hypot(1.65, 0.65);
      const double tail = (y - 0.8 + (0.65 - across) * 0.55) / std::hypot(1.0, 0.55);
      return std::max(side, tail);
    }
    case OverlayIcon::disc:
      return std::hypot(x, y) - size;
    case OverlayIcon::cross: {
      const double along = diagonal,
                   beside = std::abs(std::abs(x) - std::abs(y)) / std::numbers::sqrt2;
      return std::max(along - 0.95, beside - 0.22);
    }
    case OverlayIcon::square:
      return std::max(across, std::abs(y)) - 0.62;
    case OverlayIcon::diamond:
      return std::abs(diagonal - 0.5) - 0.15;
  }
  return 1;
}

// White with a dark rim, so that it shows on any ground.
std::string picture(OverlayIcon icon) {
  constexpr int side = 64;
  constexpr double pixel = 2.0 / side, rim = 0.09;
  constexpr double dark = 60, white = 255;
  std::vector<std::uint8_t> pixels;
  pixels.reserve(std::size_t{2} * side * side);
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const double from_edge = distance(icon, (column + 0.5) * pixel - 1, (row + 0.5) * pixel - 1);
      const double covered = std::clamp(0.5 - from_edge / pixel, 0.0, 1.0);
      const double inner = std::clamp(0.5 - (from_edge + rim) / pixel, 0.0, 1.0);
      pixels.push_back(static_cast<std::uint8_t>(std::lround(dark + (white - dark) * inner)));
      pixels.push_back(static_cast<std::uint8_t>(std::lround(255 * covered)));
    }
  }
  return png_bytes(side, side, pixels, true);
}

}  // namespace

std::string server_icon(OverlayIcon icon) {
  return std::string("https://maps.google.com/mapfiles/kml/shapes/") + known(icon).on_server +
         ".png";
}

std::string packed_icon(OverlayIcon icon) {
  return std::string("icons/") + known(icon).name + ".png";
}

std::vector<PackedFile> packed_icons() {
  std::vector<PackedFile> files;
  for (const Icon& each : icons) files.push_back({packed_icon(each.icon), picture(each.icon)});
  return files;
}

}  // namespace lsos
