// What a user states about a raster: which file, and what its own metadata leaves open.
#pragma once

#include <optional>
#include <string>
#include <variant>

namespace lsos {

// A raster that GDAL opens. What is absent is taken from the file.
struct RasterSurface {
  std::string file;
  std::variant<int, std::string> band = 1;  // its number from 1, or its description
  std::optional<double> nodata = {};        // the sample value that marks missing ones
  std::string unit = {};                    // of length: "m", "ft", "km", ...
  std::optional<bool> is_radius = {};       // samples are distances from the body's centre
  std::string crs = {};                     // anything that GDAL reads as one
  bool is_band_given = false;               // the user chose the band: else it is the first
  bool has_classes = false;                 // samples are numbers of classes, not heights
};

}  // namespace lsos
