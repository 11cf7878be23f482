// Parts of QGIS's symbols, as XML of its version 3.22.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lsos {

using QgisOptions = std::vector<std::pair<std::string, std::string>>;

struct QgisSymbolLayer {
  std::string kind;  // "SimpleMarker", "SimpleLine", "SimpleFill", "MarkerLine"
  QgisOptions options;
  QgisOptions properties = {};  // options given by an expression per feature
  std::string marker = {};      // <symbol> of a MarkerLine
};

// <symbol>. `type`: "marker", "line" or "fill"; `layers`: the lowest first.
std::string qgis_symbol(std::string_view type, std::string_view name,
                        const std::vector<QgisSymbolLayer>& layers);
// <renderer-v2> that draws all features alike. `symbol`: named "0".
std::string qgis_single_symbol(const std::string& symbol);

// <labeling> by an expression. `placement`: around points, along lines, or inside polygons.
enum class QgisPlacement { about_points, along_lines, inside };
std::string qgis_labeling(const std::string& expression, QgisPlacement placement);

// Escapes the text of an element or attribute.
std::string xml_escaped(std::string_view text);

}  // namespace lsos
