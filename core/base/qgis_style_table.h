// The table in which QGIS keeps the styles of a GeoPackage's layers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lsos {

struct QgisStyleRow {
  std::string layer;
  std::string geometry_column;  // "": the layer has none
  std::string name;
  std::string qml;       // content of the .qml file that QGIS would write
  std::string utc = {};  // when the style was made; "": time of insertion
};

// SQL statements that create the table if it does not exist and add the style as the layer's
// default.
std::vector<std::string> qgis_style_sql(const QgisStyleRow& style);

// The text as a quoted SQL literal.
std::string sql_text(std::string_view text);

}  // namespace lsos
