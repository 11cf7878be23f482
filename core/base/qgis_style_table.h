// The table in which QGIS looks for the styles of a GeoPackage's layers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lsos {

struct QgisStyleRow {
  std::string layer;
  std::string geometry_column;  // "": the layer has none
  std::string name;
  std::string qml;       // what QGIS would write to a .qml file
  std::string utc = {};  // when it was made; "": not said
};

// Statements that make the table where there is none, and add the style as the layer's default.
std::vector<std::string> qgis_style_sql(const QgisStyleRow& style);

// A text as SQL has it.
std::string sql_text(std::string_view text);

}  // namespace lsos
