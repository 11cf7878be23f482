// Name of a raster in messages.
#pragma once

#include <fmt/format.h>

#include <string>

#include "base/error.h"

namespace lsos {

struct RasterName {
  Place place;  // position of what requests it
  std::string file;

  [[noreturn]] void refuse(const std::string& why) const {
    throw InputError(place, fmt::format("raster '{}' {}", file, why));
  }
};

// How a user gives an option of a raster: "nodata in lsos.raster, or --nodata".
inline std::string option_of_raster(const std::string& key) {
  return fmt::format("{} in lsos.raster, or --{}", key, key == "is_radius" ? "radius" : key);
}

}  // namespace lsos
