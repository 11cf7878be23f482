// The table in which QGIS keeps the styles of layers.
#include <fmt/format.h>

#include "record/gpkg.h"

namespace lsos::gpkg {

void add_style(GDALDataset& dataset, const LayerStyle& style, const std::string& utc) {
  run_sql(dataset,
          "CREATE TABLE IF NOT EXISTS layer_styles (id INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, "
          "f_table_catalog TEXT(256), f_table_schema TEXT(256), f_table_name TEXT(256), "
          "f_geometry_column TEXT(256), styleName TEXT(30), styleQML TEXT, styleSLD TEXT, "
          "useAsDefault BOOLEAN, description TEXT(256), owner TEXT(30), ui TEXT(30), "
          "update_time DATETIME)");
  run_sql(dataset, fmt::format("INSERT OR IGNORE INTO gpkg_contents (table_name, data_type, "
                               "identifier, last_change) VALUES ('layer_styles', 'attributes', "
                               "'layer_styles', {})",
                               quoted(utc)));
  run_sql(dataset,
          fmt::format("INSERT INTO layer_styles (f_table_catalog, f_table_schema, f_table_name, "
                      "f_geometry_column, styleName, styleQML, useAsDefault, update_time) "
                      "VALUES ('', '', {}, 'geom', {}, {}, 1, {})",
                      quoted(style.layer), quoted(style.name), quoted(style.qml), quoted(utc)));
}

}  // namespace lsos::gpkg
