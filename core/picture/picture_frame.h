// Renders one picture of a run, as it is written to a file.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "picture/lettering.h"
#include "picture/picture_run.h"
#include "view/picture/scene_picture.h"

namespace lsos {

struct PictureRequest {
  std::string from = "sun";  // sun, chase, east, above, or a rover
  std::string rover;         // "": the first
  int size_px = 0;           // width; for the view from the Sun each side; 0: 1280, or 800
};

struct PictureSize {
  int width_px = 0, height_px = 0;
};
// Throws InputError where there is no such view.
PictureSize picture_size(const PictureRun& run, const PictureRequest& request);

struct PictureFrameOut {
  RgbPicture picture;
  nlohmann::ordered_json about;  // facts for the answer
};

// `k`: index into the run's times.
PictureFrameOut picture_of(const PictureRun& run, std::size_t k, const PictureRequest& request,
                           const Gpu& gpu, Lettering& letters);

}  // namespace lsos
