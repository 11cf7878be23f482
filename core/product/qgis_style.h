// Styles with which QGIS draws the layers of a log: XML of its version 3.22, in parts that project
// files and styles share.
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

// The layers that have places, the topmost first. `rovers`: their ids in byte order, which
// determines their colours.
std::vector<QgisLayer> qgis_layers(const std::vector<std::string>& rovers);

// A style as QGIS keeps it in the table layer_styles.
std::string qgis_style(const QgisLayer& layer);

// Colour of the rover at that index in the order of ids: "255,0,0,110"; `opacity`: 0..255.
std::string rover_qgis_color(std::size_t rover, int opacity);

}  // namespace lsos
