#include "base/qgis_style_table.h"

#include <fmt/format.h>

namespace lsos {

std::string sql_text(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "''" : std::string(1, c);
  return quoted + "'";
}

std::vector<std::string> qgis_style_sql(const QgisStyleRow& style) {
  // Without a time given, SQLite inserts the present one.
  const std::string utc =
      style.utc.empty() ? "strftime('%Y-%m-%dT%H:%M:%fZ', 'now')" : sql_text(style.utc);
  return {
      "CREATE TABLE IF NOT EXISTS layer_styles (id INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, "
      "f_table_catalog TEXT(256), f_table_schema TEXT(256), f_table_name TEXT(256), "
      "f_geometry_column TEXT(256), styleName TEXT(30), styleQML TEXT, styleSLD TEXT, "
      "useAsDefault BOOLEAN, description TEXT(256), owner TEXT(30), ui TEXT(30), "
      "update_time DATETIME)",
      fmt::format("INSERT OR IGNORE INTO gpkg_contents (table_name, data_type, identifier, "
                  "last_change) VALUES ('layer_styles', 'attributes', 'layer_styles', {})",
                  utc),
      fmt::format("INSERT INTO layer_styles (f_table_catalog, f_table_schema, f_table_name, "
                  "f_geometry_column, styleName, styleQML, useAsDefault, update_time) "
                  "VALUES ('', '', {}, {}, {}, {}, 1, {})",
                  sql_text(style.layer), sql_text(style.geometry_column), sql_text(style.name),
                  sql_text(style.qml), utc)};
}

}  // namespace lsos
