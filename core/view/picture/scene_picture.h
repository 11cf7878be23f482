// A picture as a camera takes it: ground and solids in sunlight, with cast shadows, under a sky.
#pragma once

#include <cstdint>
#include <vector>

#include "view/gl/gpu.h"
#include "view/picture/camera.h"
#include "view/picture/scene.h"

namespace lsos {

struct RgbPicture {
  int width_px = 0, height_px = 0;
  std::vector<std::uint8_t> rgb;  // rows from the top
};
// The same bits each time on one kind of renderer. Not of a scene with nothing in it.
RgbPicture draw(const Gpu& gpu, const Scene& scene, const Camera& camera);

}  // namespace lsos
