// An orthographic picture as seen from the Sun: solids in their colours, panels in pure green.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "view/gl/gpu.h"
#include "view/gl/mesh.h"

namespace lsos {

struct PictureSolid {
  Mesh mesh;
  Vec3 colour = Vec3::Zero();  // red, green, blue, 0..1
  bool is_emissive = false;    // drawn unshaded; else shaded by its angle to the viewer
};

// A square picture. `towards` points to the viewer, `up` is up in the picture; both are unit
// vectors, at right angles.
struct PictureFrame {
  Vec3 centre_m = Vec3::Zero();
  Vec3 towards = Vec3::UnitZ(), up = Vec3::UnitY();
  double half_m = 1;  // from its middle to its side
  int size_px = 512;
};

struct Picture {
  int size_px = 0;
  std::vector<std::uint8_t> rgb;  // rows from the top
};
Picture draw(const Gpu& gpu, std::span<const PictureSolid> solids, const PictureFrame& frame);

// Number of pure green pixels.
int green_pixels(const Picture& picture);

}  // namespace lsos
