// From where a picture of a run is taken.
#pragma once

#include <string>
#include <vector>

#include "picture/picture_scene.h"
#include "view/picture/camera.h"

namespace lsos {

struct PictureView {
  enum class Kind { sun, chase, east, above, rover };
  Kind kind = Kind::sun;
  std::string rover;  // that is looked from
};

// Throws InputError: neither a view nor one of these rovers.
PictureView view_of(const std::string& from, const std::vector<std::string>& rovers);

// `subject`: the rover of the picture. `bodies`: drawn about any point; that which is looked from
// is among them.
Camera camera_of(const PictureView& view, const Ground& ground, const LoggedRover& subject,
                 const std::vector<DrawnBody>& bodies, int width_px, int height_px);

}  // namespace lsos
