// Camera views of a run's pictures.
#pragma once

#include <string>
#include <vector>

#include "picture/picture_scene.h"
#include "view/picture/camera.h"

namespace lsos {

struct PictureView {
  enum class Kind { sun, chase, east, above, rover };
  Kind kind = Kind::sun;
  std::string rover;  // the rover that carries the camera
};

// Throws InputError where `from` is neither a view nor one of these rovers.
PictureView view_of(const std::string& from, const std::vector<std::string>& rovers);

// `subject`: the rover of the picture. `bodies` may be drawn relative to any point; they include
// the rover that carries the camera.
Camera camera_of(const PictureView& view, const Ground& ground, const LoggedRover& subject,
                 const std::vector<DrawnBody>& bodies, int width_px, int height_px);

}  // namespace lsos
