// How QGIS draws the layers of a log: XML of its version 3.22, in parts that its project files and
// its styles share.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lsos {

struct QgisLayer {
  std::string_view layer;     // of log.gpkg
  std::string title;          // "Samples"
  std::string_view geometry;  // Point, Line
  std::string renderer;       // <renderer-v2>
  std::string labeling;       // <labeling>; "": none
  std::string temporal;       // <temporal>; "": always shown
  bool is_on = true;          // drawn when the project opens
};

// Those that have places, the topmost first. `rovers`: their ids in byte order, which decides their
// colours.
std::vector<QgisLayer> qgis_layers(const std::vector<std::string>& rovers);

// A style as QGIS keeps it in the table layer_styles.
std::string qgis_style(const QgisLayer& layer);

// "255,0,0,110": of the rover at that place in the order of ids; opacity of 255.
std::string rover_qgis_color(std::size_t rover, int opacity);

}  // namespace lsos
